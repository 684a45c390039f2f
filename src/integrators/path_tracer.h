// The light transport that every integrator is made of: paths from the camera or from a radiance map's origin, and the
// exact split of what arrives at a primary point into direct and indirect light (PBR 3e, chapter 14).
//
//     radiance(ray) = direct(ray) + [primary point's non-specular lobes] * incident(...)
//
// Primary point: a non-specular hit that the camera sees through a chain of perfect mirrors and smooth glass. The
// chain counts for nothing in path depth. Radiance is linear RGB.
#pragma once
#include "integrators/environment_guide.h"
#include "integrators/light_sampler.h"
#include "integrators/ray_queries.h"
#include "math/sampler.h"
#include "scene/bsdf_view.h"

namespace drc {

struct PathSettings {
    int maxDepth = 64;        // non-specular vertices; Russian roulette ends nearly all paths long before
    int rouletteDepth = 3;    // vertices before roulette starts
    float clamp = kInfinity;  // upper bound on a sample's luminance; infinity: none, the unbiased default
    // Lobes that are rougher are broad (LobeMask), and of those radiance maps bring the indirect light: this default is
    // what maps of 32x32 texels resolve (broadAlpha() of cache/projection.h).
    float broadAlpha = 0.2f;
};

// Where a path first met a surface, as a radiance map records it.
struct FirstHit {
    float distance = -1;   // world units; -1: the path escaped
    Vec3 normal{0, 0, 0};  // geometric, turned towards the origin; zero if it escaped
    // Share of light that the surface sends on towards the origin (Bsdf::albedo), in [0, 1]. Of an emitter without a
    // body, that of what lies behind; zero if the path escaped.
    Rgb albedo{0.f};
    // Of the sample, what reaches the first non-specular vertex straight from emitters; the rest has been at another.
    Rgb direct{0.f};
};

// A non-specular hit seen by the camera, with the share of its radiance that reaches the pixel.
struct PrimaryHit {
    SurfaceInteraction surface;
    Bsdf bsdf;
    Rgb throughput{1.f};  // specular chain, divided by the probability of the branches chosen
    float distance = 0;   // length of the whole chain
    int bounces = 0;      // of the chain: mirrors and faces of smooth glass
};

// What a sample of direct light is made of, and indirect light that it can bring along, at the same points.
struct SampleLayers {
    bool traceWide = false;  // in: whether `wide` is wanted

    Rgb lit{0.f};     // of the direct light what surfaces scatter: all but the emission that the camera sees
    Rgb narrow{0.f};  // indirect, of the narrow lobes, which radiance maps cannot resolve
    Rgb wide{0.f};    // indirect, of the wide ones: what the maps should give
    // Of the first point that has wide lobes, and of the first that has narrow ones: their albedo times the throughput
    // to it. Zero if there is none.
    Rgb wideAlbedo{0.f}, narrowAlbedo{0.f};
    // Of the first point that has lobes other than specular ones: their albedo times the throughput to it, its
    // position, its shading normal and the world width of a pixel there. All zero if there is none.
    Rgb albedo{0.f};
    Vec3 position{0.f}, normal{0.f};
    float pixelSize = 0;

    // For a camera whose rays do not all count alike.
    void scale(float weight) {
        for (Rgb* light : {&lit, &narrow, &wide, &wideAlbedo, &narrowAlbedo, &albedo}) *light *= weight;
    }
};

class PathTracer {
  public:
    // All arguments must outlive the tracer.
    PathTracer(const Scene& scene, const Accel& accel, const LightSampler& lights, const PathSettings& settings = {})
        : scene_(scene), accel_(accel), lights_(lights), settings_(settings) {}
    // From here on samples of the guide's light are guided, and what becomes of them is learned. Null: no longer.
    void setGuide(EnvironmentGuide* guide) { guide_ = guide; }

    // All light that arrives at the ray's origin along it.
    Rgb radiance(const Ray& ray, Sampler& sampler) const;

    // The same without what is emitted by the first surface itself (or by the environment, if there is none): the R of
    // the split. Emitters seen by way of a mirror or glass are kept. The point that the ray leaves is a vertex of the
    // path, and counts in its depth.
    Rgb incident(const Ray& ray, Sampler& sampler, FirstHit* first = nullptr) const;

    // Emission seen through the specular chain, and one bounce of light at each non-specular hit along it: D.
    // layers, if not null, receives what it is made of, and indirect light that is traced on the way.
    Rgb direct(const Ray& ray, Sampler& sampler, SampleLayers* layers = nullptr) const;

    // The primary point of a camera ray. Where a surface has both kinds of lobes, one is chosen at random. False: none
    // (the ray escaped, or was absorbed).
    bool primaryHit(const Ray& ray, Sampler& sampler, PrimaryHit& hit) const;

    // One sample of the non-specular lobes' share of indirect light at a primary point: f R cos / pdf.
    Rgb indirect(const PrimaryHit& hit, Sampler& sampler, const LobeMask& lobes = LobeFlags::NonSpecular) const;

    const Scene& scene() const { return scene_; }
    // Whether a path's time makes a difference.
    bool anythingMoves() const { return accel_.anythingMoves(); }
    const PathSettings& settings() const { return settings_; }
    LobeMask broad() const { return broadLobes(settings_.broadAlpha); }
    LobeMask glossy() const { return glossyLobes(settings_.broadAlpha); }

  private:
    enum class Emission { Counted, SkippedAtFirst };
    static constexpr int kNoGroup = -1;
    // A path as it goes on from its latest vertex.
    struct Path {
        Ray ray;
        Vec3 from;  // the vertex that the ray leaves, before it was moved off the surface
        Rgb throughput{1.f};
        float pdf = 0;       // of the ray's direction; 0: none that light sampling could have chosen
        float etaScale = 1;  // undoes the scaling of radiance inside glass, which is no loss, for roulette
        int depth = 0, chain = 0;
        int group = kNoGroup;  // of the vertex that the ray leaves
    };
    // A light sample that nothing may block yet: what arrives through the BSDF is weight times its radiance.
    struct LightProposal {
        const Light* light = nullptr;  // null: no light
        LightSample sample{};
        Rgb weight{0.f};
        int slot = -1;  // of the guide, which is told whether the sample arrives; -1: not guided
    };
    // The random numbers of one vertex.
    struct VertexNumbers {
        explicit VertexNumbers(Sampler& sampler) : VertexNumbers(sampler.getFour2D()) {}
        explicit VertexNumbers(const std::array<Vec2, 4>& u)
            : onLight(u[0]), direction(u[1]), light(u[2].x), lobe(u[2].y), roulette(u[3].x) {}
        Vec2 onLight, direction;
        float light, lobe, roulette;
    };
    // The guide's group for a point on a surface.
    int groupOf(const SurfaceInteraction& at, const Bsdf& bsdf) const {
        if (guide_ == nullptr) return kNoGroup;
        const int group = guide_->group(at.p, faceForward(bsdf.frame().n, at.wo));
        guide_->prefetch(group);
        return group;
    }
    // start: what the ray meets first, if that is known.
    Rgb trace(const Ray& ray, Sampler& sampler, Emission emission, FirstHit* first,
              const SurfaceInteraction* start = nullptr) const;
    // Samples the next direction at a hit. False: the path ends.
    bool scatter(Path& path, const SurfaceInteraction& hit, const BsdfView& bsdf, const VertexNumbers& u) const;
    // One sample of indirect light for the narrow lobes alone. Paths of little weight are not traced.
    Rgb indirectNarrow(const SurfaceInteraction& at, const Bsdf& bsdf, Sampler& sampler) const;
    // The BSDF's sample of direct light at a primary point, and with wide indirect light wanted the path beyond it.
    Rgb bsdfSample(const SurfaceInteraction& at, const BsdfView& bsdf, int group, const Rgb& throughput,
                   const VertexNumbers& u, Sampler& sampler, SampleLayers* layers) const;
    // Light sample at a non-specular vertex, weighted against the density of the BSDF's own samples, and what of it
    // arrives if its shadow ray is free.
    LightProposal proposeLight(const SurfaceInteraction& at, const BsdfView& bsdf, int group,
                               const VertexNumbers& numbers) const;
    Rgb arriving(const SurfaceInteraction& at, const LightProposal& proposal) const;
    // Emission met by a ray that the BSDF sampled with the given density, weighted against light sampling.
    Rgb emissionAtHit(const SurfaceInteraction& hit, const Vec3& from, float pdf) const;
    Rgb emissionAtInfinity(const Vec3& d, const Vec3& from, float pdf, int group) const;

    const Scene& scene_;
    const Accel& accel_;
    const LightSampler& lights_;
    PathSettings settings_;
    EnvironmentGuide* guide_ = nullptr;
};

}  // namespace drc
