// Records of a path, filled in while it is walked.
#pragma once
#include "accel/interaction.h"

namespace drc {

// The first surface of a path, as a radiance map records it.
struct FirstHit {
    float distance = -1;   // world units; -1: the path escaped
    Vec3 normal{0, 0, 0};  // geometric, turned towards the origin; zero if it escaped
    // The albedo of the surface towards the origin (Bsdf::albedo), in [0, 1]. For an emitter without a material, that
    // of the surface behind it; zero if the path escaped.
    Rgb albedo{0.f};
    // The part of the sample's radiance that reaches the first non-specular vertex straight from emitters; the rest has
    // met at least one more such vertex.
    Rgb direct{0.f};
};

// The G-buffer of a camera sample: surfaces in the pixel, seen directly or through mirrors and smooth glass. All zero
// if there are none.
struct GBufferSample {
    // The albedos of the non-specular lobes along the specular chain, times its throughput. This is an estimate whose
    // mean is the pixel's albedo; single samples may exceed 1.
    Rgb albedo{0.f};
    // For the first surface with non-specular lobes: the shading normal on the viewer's side (world space, unit
    // length), and the length of the chain up to it (world units).
    Vec3 normal{0.f};
    float depth = 0;
    // Whether the camera's own ray met anything: a surface with a material, or a particle of a medium.
    bool covered = false;

    void record(const Rgb& throughput, const SurfaceInteraction& at, const Bsdf& bsdf, float distance) {
        if (!bsdf.hasNonSpecular()) return;
        albedo += throughput * bsdf.albedo(at.wo, LobeFlags::NonSpecular);
        if (depth > 0) return;
        normal = faceForward(bsdf.frame().n, at.wo);
        depth = distance;
    }
};

// Each may be null.
struct PathSinks {
    FirstHit* firstHit = nullptr;
    GBufferSample* gBuffer = nullptr;
    // The part of the sample's radiance that comes straight from emitters or has met a single non-specular vertex: what
    // path tracing to a depth of 1 gives.
    Rgb* direct = nullptr;
};

}  // namespace drc
