// The surfaces that the camera sees in a sample, for denoisers.
#pragma once
#include "accel/accel.h"

namespace drc {

struct MediumPassage;
struct PathState;

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
    // The first surface that the camera's own ray meets, such as a mirror itself, or the one behind a particle of a
    // medium: whether there is one, and the point on it, world space.
    bool meets = false;
    Vec3 position{0.f};
    // Whether the camera's own ray met anything: a surface with a material, or a particle of a medium.
    bool covered = false;

    // To be called for each surface with a material or a light that the path meets before it is scattered.
    void meet(const SurfaceInteraction& at) {
        if (meets) return;
        meets = true;
        position = at.p;
    }
    void record(const Rgb& throughput, const SurfaceInteraction& at, const Bsdf& bsdf, float distance) {
        if (!bsdf.hasNonSpecular()) return;
        albedo += throughput * bsdf.albedo(at.wo, LobeFlags::NonSpecular);
        if (depth > 0) return;
        normal = faceForward(bsdf.frame().n, at.wo);
        depth = distance;
    }
    // For a visitor's passed(): adds the albedo of the medium and, if the path is scattered in it, records the surface
    // behind, as if media did not scatter paths but only hid part of what is behind them. All samples of a pixel then
    // record nearly the same values, whether their paths are scattered or not.
    void recordMedium(const Accel& accel, const PathState& path, const MediumPassage& passage);
};

}  // namespace drc
