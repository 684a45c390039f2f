// Light transport for pictures and radiance maps: paths from the camera or from a map's origin, and the exact split of
// the radiance of a primary point into direct and indirect light (PBR 3e, chapter 14).
//
//     radiance(ray) = direct(ray) + [primary point's non-specular lobes] * incident(...)
//
// A primary point is a non-specular hit that the camera sees through a chain of perfect mirrors and smooth glass. The
// chain does not count in the path's depth. Radiance is linear RGB.
#pragma once
#include "transport/incident_visitor.h"

namespace drc {

// A non-specular hit seen by the camera, with the throughput from it to the pixel.
struct PrimaryHit {
    SurfaceInteraction surface;
    Bsdf bsdf;
    Rgb throughput{1.f};  // of the specular chain, divided by the probability of the branches chosen
    float distance = 0;   // length of the whole chain, world units
    int bounces = 0;      // mirrors and faces of smooth glass in the chain
};

// A sample of direct light, divided into layers, and of the indirect light that can be sampled at the same points.
// Direct light, glossy and broad indirect light are each clamped to luminance PathSettings::clamp.
struct SampleLayers {
    Rgb emission{0.f};  // Le that the camera sees, directly or through mirrors and smooth glass
    Rgb lit{0.f};       // direct light, scattered once
    Rgb glossy{0.f};    // indirect light of the glossy lobes, which radiance maps cannot resolve
    Rgb broad{0.f};     // indirect light of the broad lobes: an unbiased sample of what the maps give
    // Albedo of the broad lobes (of the glossy lobes) times the throughput, at the first point that has such lobes.
    // Zero if there is none.
    Rgb broadAlbedo{0.f}, glossyAlbedo{0.f};
    // For the first point with non-specular lobes: their albedo times the throughput, its position, its shading normal,
    // and the width of a pixel there in world units. All zero if there is none.
    Rgb albedo{0.f};
    Vec3 position{0.f}, normal{0.f};
    float pixelSize = 0;

    Rgb direct() const { return emission + lit; }
    // Multiplies by the weight of the camera ray.
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

    // Radiance that arrives at the ray's origin along the ray.
    Rgb radiance(const Ray& ray, Sampler& sampler, const SampleParts& parts = {}) const;

    // R of the split: radiance() without Le of the first surface itself, or of the environment if the ray escapes.
    // Emitters seen through a mirror or glass are included. The ray's origin is a vertex of the path, and counts in its
    // depth.
    Rgb incident(const Ray& ray, Sampler& sampler, FirstHit* first = nullptr) const;

    // D: Le seen through the specular chain, and one bounce of light at each non-specular hit along it. Where a surface
    // has specular and other lobes, both are followed.
    Rgb direct(const Ray& ray, Sampler& sampler, GBufferSample* gBuffer = nullptr) const {
        return directLayers(ray, sampler, false, false, gBuffer).direct();
    }
    // direct() in layers, plus one sample of the indirect light of the glossy lobes and, if traceBroad, of the broad
    // ones.
    SampleLayers layers(const Ray& ray, Sampler& sampler, bool traceBroad, GBufferSample* gBuffer = nullptr) const {
        return directLayers(ray, sampler, true, traceBroad, gBuffer);
    }

    // Finds the primary point of a camera ray. Where a surface has specular and other lobes, one kind is chosen at
    // random. False: there is no primary point, because the ray escaped or was absorbed.
    bool primaryHit(const Ray& ray, Sampler& sampler, PrimaryHit& hit) const;

    // One sample of the indirect light that `lobes` scatter at a primary point: f R cos / pdf.
    Rgb indirect(const PrimaryHit& hit, Sampler& sampler, const LobeMask& lobes = LobeFlags::NonSpecular) const;

    const Scene& scene() const { return scene_; }
    // Whether anything in the scene moves, so that a path's time matters.
    bool anythingMoves() const { return lighting_.accel().anythingMoves(); }
    const PathSettings& settings() const { return walker_.settings(); }
    const DirectLighting& lighting() const { return lighting_; }
    // The broad lobes, whose indirect light comes from radiance maps, and the glossy ones, by the threshold
    // PathSettings::broadAlpha.
    LobeMask broad() const { return broadLobes(settings().broadAlpha); }
    LobeMask glossy() const { return glossyLobes(settings().broadAlpha); }

  private:
    class LayersVisitor;
    // withIndirect: whether more than emission and lit is needed.
    SampleLayers directLayers(const Ray& ray, Sampler& sampler, bool withIndirect, bool traceBroad,
                              GBufferSample* gBuffer) const;
    // One sample of the glossy lobes' indirect light. Russian roulette skips paths of little weight.
    Rgb indirectGlossy(const SurfaceInteraction& at, const Bsdf& bsdf, Sampler& sampler) const;

    const Scene& scene_;
    DirectLighting lighting_;
    PathWalker walker_;
};

}  // namespace drc
