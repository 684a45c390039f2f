// Perlin's gradient noise and sums of it at rising frequencies (PBR 3e, section 10.6). Dimensionless.
#pragma once
#include "math/vec.h"

namespace drc {

// In about [-1, 1], with mean 0 and features of size 1; 0 at points whose coordinates are whole, and where a coordinate
// is not finite or so large that it has no fraction. Repeats every 256.
float noise(const Vec3& p);

// Which frequencies a sum of noise has. dpdx, dpdy: the axes of the footprint that is averaged over, in the units of p.
// Octaves finer than what it resolves are faded out and replaced by their mean.
struct NoiseSum {
    int octaves = 8;
    float roughness = 0.5f;  // amplitude of each octave relative to the one before; its frequency is 1.99 times as high
};
// "Fractional Brownian motion": the sum of the octaves, with mean 0.
float fbm(const Vec3& p, const Vec3& dpdx, const Vec3& dpdy, const NoiseSum& sum);
// The sum of the octaves' absolute values: creases where one changes its sign.
float turbulence(const Vec3& p, const Vec3& dpdx, const Vec3& dpdy, const NoiseSum& sum);

}  // namespace drc
