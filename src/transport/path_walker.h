// The walk over the vertices of a path. All light transport from the camera is made of these parts: the walk itself
// (paths, radiance maps), the chain of mirrors and smooth glass before it (direct light, primary points), and the sinks
// that record on the way (G-buffer, first hit of a radiance map).
//
// Depth counts non-specular vertices only; mirrors and smooth glass do not count. Radiance is linear RGB.
#pragma once
#include "math/sampler.h"
#include "transport/direct_lighting.h"
#include "transport/path_sinks.h"

namespace drc {

struct PathSettings {
    int maxDepth = 64;        // non-specular vertices; Russian roulette ends nearly all paths earlier
    int rouletteDepth = 3;    // vertices before roulette starts
    float clamp = kInfinity;  // upper bound on a sample's luminance; infinity: unbiased
    // Lobes whose alpha is at least this are broad (LobeMask): radiance maps give their indirect light. The default is
    // the roughness that maps of 32x32 texels resolve (broadAlpha() of cache/projection.h).
    float broadAlpha = 0.2f;
};

// A part of a sample's radiance when the sample is scaled down to the luminance `clamp`; black if the sample is not
// finite.
inline Rgb partOfClamped(const Rgb& part, const Rgb& radiance, float clamp) {
    if (!isFinite(radiance)) return Rgb(0.f);
    const float l = luminance(radiance);
    return l <= clamp ? part : part * (clamp / l);
}
inline Rgb clampedSample(const Rgb& radiance, float clamp) { return partOfClamped(radiance, radiance, clamp); }

// The state of a path after its latest vertex.
struct PathState {
    explicit PathState(const Ray& r) : ray(r), from(r.o) {}

    Ray ray;
    Vec3 from;  // the vertex that the ray leaves, on the surface, not offset from it
    Rgb throughput{1.f};
    Rgb weight{1.f};                        // the factor that the latest vertex has multiplied it by
    float passing = 1;                      // the probability with which media have let it pass so far
    float pdf = DirectLighting::kSpecular;  // of the ray's direction, per solid angle
    float etaScale = 1;                     // undoes the scaling of radiance by refraction, for Russian roulette
    float distance = 0;                     // length of the path, world units
    int depth = 0, chain = 0;               // depth: non-specular vertices; chain: specular vertices, in total
    int group = DirectLighting::kNoGroup;   // of the guide, for the vertex that the ray leaves
};

// The random numbers of one vertex.
struct VertexNumbers {
    explicit VertexNumbers(Sampler& sampler) : VertexNumbers(sampler.getFour2D()) {}
    explicit VertexNumbers(const std::array<Vec2, 4>& u)
        : onLight(u[0]), direction(u[1]), light(u[2].x), lobe(u[2].y), roulette(u[3].x) {}
    Vec2 onLight, direction;
    float light, lobe, roulette;
};

// Follows the ray to the next surface with a material, through those without one. met(hit) is called for that surface,
// and for emitters on the way. Escaped: there is no such surface, and `ray` is the last segment. Lost: there were too
// many surfaces, and no light may be taken from there. found: the result of accel.find for the ray. goesOn(ray, length)
// is called for each segment of the way, before what it leads to; if it returns false, the path ends on that segment,
// and the result is Scattered.
enum class Arrival { Surface, Escaped, Lost, Scattered };
template <class Met, class GoesOn>
inline Arrival toSurface(const Accel& accel, Ray& ray, Accel::Found& found, bool any, SurfaceInteraction& hit,
                         Met&& met, GoesOn&& goesOn) {
    for (int passed = 0; passed <= kMaxPassThrough; ++passed) {
        if (any) accel.describe(ray, found, hit);
        if (!goesOn(ray, any ? hit.t : kInfinity)) return Arrival::Scattered;
        if (!any) return Arrival::Escaped;
        const bool ends = hit.primitive->material != nullptr;
        if (ends || hit.primitive->areaLight) met(hit);
        if (ends) return Arrival::Surface;
        ray = hit.onward(ray);
        any = accel.find(ray, found);
    }
    return Arrival::Lost;
}
// Overload for empty space; ignores any media along the way.
template <class Met>
inline Arrival toSurface(const Accel& accel, Ray& ray, SurfaceInteraction& hit, Met&& met) {
    Accel::Found found;
    const bool any = accel.find(ray, found);
    return toSurface(accel, ray, found, any, hit, met, [](const Ray&, float) { return true; });
}

// The chain of mirrors and smooth glass between a camera and the surfaces that it sees in them.
class SpecularChain {
  public:
    SpecularChain(const Accel& accel, const Ray& cameraRay) : accel_(accel), ray_(cameraRay), from_(cameraRay.o) {}

    // Moves on to the next surface with a material, surface(). met(hit) is called as by toSurface. Where the path
    // escapes, atInfinity(from, ray) is called. False: the path ends.
    template <class Met, class AtInfinity>
    bool next(Met&& met, AtInfinity&& atInfinity) {
        const Arrival arrival = toSurface(accel_, ray_, surface_, [&](const SurfaceInteraction& hit) {
            distance_ += hit.t;
            met(hit);
        });
        if (arrival == Arrival::Escaped) atInfinity(from_, ray_);
        return arrival == Arrival::Surface;
    }
    // Leaves surface() by one of its specular lobes. probability: that of having chosen to do so. False: the path ends.
    bool follow(const Bsdf& bsdf, float uLobe, const Vec2& u, float probability = 1);

    const SurfaceInteraction& surface() const { return surface_; }
    const Rgb& throughput() const { return throughput_; }  // of the chain up to surface()
    float distance() const { return distance_; }           // to surface() along the chain, world units
    int bounces() const { return bounces_; }

  private:
    const Accel& accel_;
    Ray ray_;
    Vec3 from_;  // what the ray left: the camera or a surface
    SurfaceInteraction surface_;
    Rgb throughput_{1.f};
    float distance_ = 0;
    int bounces_ = 0;
};

class PathWalker {
  public:
    // lighting must outlive the walker.
    PathWalker(const DirectLighting& lighting, const PathSettings& settings)
        : lighting_(lighting), settings_(settings) {}

    // Whether Le before the first vertex counts. It is skipped where another layer has it (the R of the split).
    enum class FirstEmission { Counted, Skipped };
    // All light that arrives along the ray. start: the first surface on the ray, if it is known already. If first
    // emission is skipped, the ray's origin is a vertex of the path, and counts in its depth.
    Rgb walk(const Ray& ray, Sampler& sampler, FirstEmission first, PathSinks sinks = {},
             const SurfaceInteraction* start = nullptr) const;

    // A light sample at a vertex, weighted against BSDF sampling.
    Rgb sampleLight(const SurfaceInteraction& at, const BsdfView& view, int group, const VertexNumbers& u) const {
        auto proposal = lighting_.propose(at, view, group, u.light, u.onLight);
        return lighting_.weighted(at, proposal);
    }
    const DirectLighting& lighting() const { return lighting_; }
    const PathSettings& settings() const { return settings_; }

    // Samples the next direction at a vertex. False: the path ends.
    bool scatter(PathState& path, const SurfaceInteraction& hit, const BsdfView& view, const VertexNumbers& u) const;
    bool scatter(PathState& path, const MediumVertex& at, const VertexNumbers& u) const;

    // Follows the path to its next vertex, which is `hit`, or `vertex` if the path is scattered in a medium on the way.
    // any, found: what accel.find said of path.ray. met(hit) as for toSurface. passed(emitted, weight) is called for
    // each segment in a medium: with the light that it emits towards the path's latest vertex, and then with what the
    // rest of the path is to be multiplied by, as path.throughput has been.
    template <class Met, class Passed>
    Arrival advance(PathState& path, bool any, Accel::Found& found, SurfaceInteraction& hit, MediumVertex& vertex,
                    Sampler& sampler, GBufferSample* gBuffer, Met&& met, Passed&& passed) const {
        const auto goesOn = [&](const Ray& ray, float length) {
            if (ray.medium == nullptr) return true;
            const float reach = lighting_.accel().lengthInMedium(length);
            const Vec2 u = ray.medium->scatters() ? sampler.get2D() : Vec2(0.f);
            const MediumSegment segment = sampleSegment(*ray.medium, reach, path.throughput, u);
            if (gBuffer && path.depth == 0) {
                const Rgb seen = path.throughput * path.passing;
                if (segment.scattered)
                    recordThroughMedia(ray, seen, path.distance, *gBuffer);
                else
                    gBuffer->albedo += seen * ray.medium->scatteredIn(reach);
            }
            path.passing *= segment.passing;
            passed(ray.medium->emitted(reach), segment.weight);
            path.throughput *= segment.weight;
            if (!segment.scattered) return true;
            path.distance += *segment.scattered;
            vertex = MediumVertex(ray, *segment.scattered);
            return false;
        };
        const Arrival arrival = toSurface(lighting_.accel(), path.ray, found, any, hit, met, goesOn);
        if (gBuffer && arrival != Arrival::Escaped) gBuffer->covered = true;
        return arrival;
    }

  private:
    // The part of a path's state that all kinds of vertices change alike: Russian roulette. False: the path ends.
    bool survives(PathState& path, float u) const;
    // Records what the camera sees along a ray through media, as if they did not scatter the path but only hid a part
    // of what is behind them. All samples of a pixel then record nearly the same, whether they are scattered or not.
    // seen: the throughput up to the ray. distance: the same, along the path.
    void recordThroughMedia(Ray ray, Rgb seen, float distance, GBufferSample& gBuffer) const;

    const DirectLighting& lighting_;
    PathSettings settings_;
};

}  // namespace drc
