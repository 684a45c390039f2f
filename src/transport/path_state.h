// The state of a path from the camera, and its limits.
//
// Depth counts non-specular vertices only; mirrors and smooth glass do not count. Radiance is linear RGB.
#pragma once
#include "math/sampler.h"
#include "transport/direct_lighting.h"

namespace drc {

struct PathSettings {
    int maxDepth = 64;        // non-specular vertices; Russian roulette ends nearly all paths earlier
    int rouletteDepth = 3;    // vertices before roulette starts
    float clamp = kInfinity;  // upper bound on a sample's luminance; infinity: unbiased
    // Lobes whose alpha is at least this are broad (LobeMask): radiance maps give their indirect light. The default is
    // the roughness that maps of 32x32 texels resolve (broadAlpha() of maps/projection.h).
    float broadAlpha = 0.2f;
};

// Scales a part of a sample's radiance by the factor of the firefly clamp, which brings the whole sample's luminance
// down to `clamp`; black if the sample is not finite.
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
    Vec3 from;  // position of the vertex that the ray leaves, not offset from the surface
    Rgb throughput{1.f};
    Rgb weight{1.f};                        // factor that the latest vertex contributed to the throughput
    float passing = 1;                      // probability with which media let the path pass unscattered so far
    float pdf = DirectLighting::kSpecular;  // of the ray's direction, per solid angle
    float etaScale = 1;                     // undoes the scaling of radiance by refraction, for Russian roulette
    float distance = 0;                     // length of the path, world units
    int depth = 0, chain = 0;               // depth: non-specular vertices; chain: specular vertices, in total
    int group = DirectLighting::kNoGroup;   // of the guide, for the vertex that the ray leaves
    bool playsRoulette = true;              // whether Russian roulette may end the path
};

// The random numbers of one vertex.
struct VertexNumbers {
    explicit VertexNumbers(Sampler& sampler) : VertexNumbers(sampler.getFour2D()) {}
    explicit VertexNumbers(const std::array<Vec2, 4>& u)
        : onLight(u[0]), direction(u[1]), light(u[2].x), lobe(u[2].y), roulette(u[3].x) {}
    Vec2 onLight, direction;
    float light, lobe, roulette;
};

}  // namespace drc
