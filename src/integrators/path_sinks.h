// What can be recorded of a path while it is walked.
#pragma once
#include "accel/interaction.h"

namespace drc {

// Where a path first met a surface, as a radiance map records it.
struct FirstHit {
    float distance = -1;   // world units; -1: the path escaped
    Vec3 normal{0, 0, 0};  // geometric, turned towards the origin; zero if it escaped
    // Share of light that the surface sends on towards the origin (Bsdf::albedo), in [0, 1]. Of an emitter without a
    // material, that of what lies behind; zero if the path escaped.
    Rgb albedo{0.f};
    // Of the sample, what reaches the first non-specular vertex straight from emitters; the rest has been at another.
    Rgb direct{0.f};
};

// What a camera sample says of the surfaces that its pixel shows, seen by way of mirrors and smooth glass too. All zero
// where there is none.
struct GBufferSample {
    // Albedos of the non-specular lobes along the specular chain, times its throughput: an estimate whose mean is that
    // of the pixel, single samples may exceed 1.
    Rgb albedo{0.f};
    // Of the first surface with non-specular lobes: shading normal on the viewer's side, world space, unit; and the
    // length of the chain to it, world units.
    Vec3 normal{0.f};
    float depth = 0;

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
};

}  // namespace drc
