// Perlin's gradient noise, and sums of it over octaves (PBR 3e, section 10.6). Dimensionless.
#pragma once
#include "math/vec.h"

namespace drc {

// Noise in about [-1, 1] with mean 0 and features of size 1. It is 0 at integer coordinates, and where a coordinate is
// not finite or too large to have a fraction. Its period is 256.
float noise(const Vec3& p);

// Parameters of a sum over octaves. dpdx and dpdy below are the axes of the filter footprint, in the units of p.
// Octaves finer than the footprint are faded out and replaced by their mean.
struct NoiseSum {
    int octaves = 8;
    float roughness = 0.5f;  // ratio of the amplitudes of successive octaves; their frequencies have the ratio 1.99
};
// "Fractional Brownian motion": the sum of all octaves, with mean 0.
float fbm(const Vec3& p, const Vec3& dpdx, const Vec3& dpdy, const NoiseSum& sum);
// The sum of the octaves' absolute values, which has creases where an octave changes its sign.
float turbulence(const Vec3& p, const Vec3& dpdx, const Vec3& dpdy, const NoiseSum& sum);

}  // namespace drc
