// The radiance that the error of each pixel is divided by, estimated from two references with independent noise.
#pragma once
#include "image/image.h"

namespace drc {

// Added to the squared norm, so that the errors of black pixels are finite: the square of radiance 0.1.
inline constexpr double kRelativeNormOffset = 0.01;

// A Gaussian window around a pixel without the (2 hole + 1)^2 pixels in its middle. sigma and radius in pixels.
struct RingWindow {
    float sigma = 2;
    int radius = 5, hole = 1;
};
// For pixels. The hole includes neighbours, because wide pixel filters make them share a pixel's noise.
inline constexpr RingWindow kPixelRing{2, 5, 1};
// For means of blocks, whose noise is nearly independent.
inline constexpr RingWindow kBlockRing{1, 2, 0};

// The radiance D(p) of R, G and B that an error at p is divided by: error^2 / (D^2 + 0.01). If D depended on the
// references' noise at p, it would be larger where this noise is positive, and the mean of the quotients would be
// biased. So D is
//
//     max(S(p), min(R1(p), R2(p)) / 2),
//
// with S the mean of both references in the ring around p. A pixel that is more than three times as bright in one
// reference as in the other, a firefly, counts in S as twice the darker one. The second term is for highlights of few
// pixels, which both references show but S does not: they must not be measured relative to their dark surroundings. It
// counts only where p is twice as bright as its surroundings. Pixels with NaN or infinity are left out of S, and pixels
// without neighbours have S = 0; D itself is finite and not negative. Throws Error if the sizes differ.
Image relativeNorm(const Image& first, const Image& second, const RingWindow& ring = kPixelRing);

}  // namespace drc
