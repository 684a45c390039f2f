// The error of a picture against two independent references, without the references' own noise.
#pragma once
#include <array>
#include <cstdint>

#include "image/image.h"
#include "image/tile_statistics.h"

namespace drc {

// T is the picture, R1 and R2 are references with independent noise n1 and n2 of mean zero, e is the error of T. Since
// (T - R1)(T - R2) = (e - n1)(e - n2), its expectation is e^2, however noisy the references are. One bias remains:
// pixels that are fireflies in both references by chance look like highlights of the scene. If fireflies have the share
// m of the references' radiance, `error` is too small by up to m^2.
struct CrossErrors {
    // The mean over pixels and channels of (T - R1)(T - R2) / (D^2 + 0.01), with D of relative_norm.h. It is an
    // estimate: for a nearly perfect picture it may be negative.
    Estimate error;
    // `error` without the floor(0.1 %) of the pixels with the largest (T - D)^2 / (D^2 + 0.01), because a few fireflies
    // of T can dominate `error`. Selecting by the product itself would be biased: it would keep those pixels whose
    // product the references' noise makes small. D(p) does not depend on this noise.
    Estimate trimmed;
    // `error` of means of 8x8 pixels, with a D of their own: measures errors that are correlated between neighbours.
    Estimate block;
    // The mean of (R1 - R2)^2 / 2 in the same norm, for pixels and for blocks: the noise of each reference. The noise
    // of the mean of both is half of this.
    double noise = 0, blockNoise = 0;
    std::array<double, 3> meanRatio{1, 1, 1};  // mean(T) / mean of both references, R, G, B; 1 if both are 0
    // The number of pixels with NaN or infinity in R1, R2 and T. They are left out everywhere; if no pixel is left, all
    // values are NaN.
    std::array<int64_t, 3> nonFinite{};
};

// norm: relativeNorm(first, second). Throws Error if sizes differ.
CrossErrors crossErrors(const Image& first, const Image& second, const Image& norm, const Image& test);

// CrossErrors::noise alone.
double referenceNoise(const Image& first, const Image& second, const Image& norm);

// The mean over the channels of (a - b)(c - d) / (norm^2 + 0.01) at each pixel; NaN if a value is not finite. All
// images have one size.
Plane relativeProducts(const Image& a, const Image& b, const Image& c, const Image& d, const Image& norm);

}  // namespace drc
