// The light transport that pictures and radiance maps are made of: paths from the camera or from a map's origin, and
// the exact split of what arrives at a primary point into direct and indirect light (PBR 3e, chapter 14).
//
//     radiance(ray) = direct(ray) + [primary point's non-specular lobes] * incident(...)
//
// Primary point: a non-specular hit that the camera sees through a chain of perfect mirrors and smooth glass. The
// chain counts for nothing in path depth. Radiance is linear RGB.
#pragma once
#include "integrators/path_walker.h"

namespace drc {

// A non-specular hit seen by the camera, with the share of its radiance that reaches the pixel.
struct PrimaryHit {
    SurfaceInteraction surface;
    Bsdf bsdf;
    Rgb throughput{1.f};  // specular chain, divided by the probability of the branches chosen
    float distance = 0;   // length of the whole chain
    int bounces = 0;      // of the chain: mirrors and faces of smooth glass
};

// A sample of direct light by what it is made of, and indirect light that it can bring along from the same points.
// Direct light, glossy and broad indirect light have a luminance of at most the settings' clamp each.
struct SampleLayers {
    Rgb emission{0.f};  // Le that the camera sees, by way of mirrors and smooth glass too
    Rgb lit{0.f};       // the direct light that surfaces scatter
    Rgb glossy{0.f};    // indirect, of the glossy lobes, which radiance maps cannot resolve
    Rgb broad{0.f};     // indirect, of the broad ones: what the maps should give
    // Of the first point that has broad lobes, and of the first that has glossy ones: their albedo times the throughput
    // to it. Zero if there is none.
    Rgb broadAlbedo{0.f}, glossyAlbedo{0.f};
    // Of the first point that has lobes other than specular ones: their albedo times the throughput to it, its
    // position, its shading normal and the world width of a pixel there. All zero if there is none.
    Rgb albedo{0.f};
    Vec3 position{0.f}, normal{0.f};
    float pixelSize = 0;

    Rgb direct() const { return emission + lit; }
    // For a camera whose rays do not all count alike.
    void scale(float weight) {
        for (Rgb* light : {&emission, &lit, &glossy, &broad, &broadAlbedo, &glossyAlbedo, &albedo}) *light *= weight;
    }
};

class PathTracer {
  public:
    // All arguments must outlive the tracer.
    PathTracer(const Scene& scene, const Accel& accel, const LightSampler& lights, const PathSettings& settings = {})
        : scene_(scene), lighting_(accel, lights), walker_(lighting_, settings) {}
    PathTracer(const PathTracer&) = delete;
    PathTracer& operator=(const PathTracer&) = delete;
    // See DirectLighting.
    void setGuide(EnvironmentGuide* guide) { lighting_.setGuide(guide); }

    // All light that arrives at the ray's origin along it. gBuffer, if not null, receives what the path met first.
    Rgb radiance(const Ray& ray, Sampler& sampler, GBufferSample* gBuffer = nullptr) const {
        return walker_.walk(ray, sampler, PathWalker::FirstEmission::Counted, {nullptr, gBuffer});
    }

    // The same without what is emitted by the first surface itself (or by the environment, if there is none): the R of
    // the split. Emitters seen by way of a mirror or glass are kept. The point that the ray leaves is a vertex of the
    // path, and counts in its depth.
    Rgb incident(const Ray& ray, Sampler& sampler, FirstHit* first = nullptr) const {
        return walker_.walk(ray, sampler, PathWalker::FirstEmission::Skipped, {first, nullptr});
    }

    // D: emission seen through the specular chain, and one bounce of light at each non-specular hit along it. Where a
    // surface has both kinds of lobes, both are followed.
    Rgb direct(const Ray& ray, Sampler& sampler, GBufferSample* gBuffer = nullptr) const {
        return directLayers(ray, sampler, false, false, gBuffer).direct();
    }
    // The same in layers, with a sample of the glossy lobes' indirect light and, if traceBroad, one of the broad
    // lobes'.
    SampleLayers layers(const Ray& ray, Sampler& sampler, bool traceBroad, GBufferSample* gBuffer = nullptr) const {
        return directLayers(ray, sampler, true, traceBroad, gBuffer);
    }

    // The primary point of a camera ray. Where a surface has both kinds of lobes, one is chosen at random. False: none
    // (the ray escaped, or was absorbed).
    bool primaryHit(const Ray& ray, Sampler& sampler, PrimaryHit& hit) const;

    // One sample of the non-specular lobes' share of indirect light at a primary point: f R cos / pdf.
    Rgb indirect(const PrimaryHit& hit, Sampler& sampler, const LobeMask& lobes = LobeFlags::NonSpecular) const;

    const Scene& scene() const { return scene_; }
    // Whether a path's time makes a difference.
    bool anythingMoves() const { return lighting_.accel().anythingMoves(); }
    const PathSettings& settings() const { return walker_.settings(); }
    // The lobes whose indirect light radiance maps bring, and the other non-specular ones, by the settings' threshold.
    LobeMask broad() const { return broadLobes(settings().broadAlpha); }
    LobeMask glossy() const { return glossyLobes(settings().broadAlpha); }

  private:
    // withIndirect: whether more than emission and lit is wanted.
    SampleLayers directLayers(const Ray& ray, Sampler& sampler, bool withIndirect, bool traceBroad,
                              GBufferSample* gBuffer) const;
    // One sample of indirect light for the glossy lobes alone. Paths of little weight are not traced.
    Rgb indirectGlossy(const SurfaceInteraction& at, const Bsdf& bsdf, Sampler& sampler) const;
    // The BSDF's sample of direct light at a primary point, and if broad indirect light is wanted the path beyond it.
    Rgb bsdfSample(const SurfaceInteraction& at, const BsdfView& bsdf, int group, const Rgb& throughput,
                   const VertexNumbers& u, Sampler& sampler, Rgb* broadLight) const;

    const Scene& scene_;
    DirectLighting lighting_;
    PathWalker walker_;
};

}  // namespace drc
