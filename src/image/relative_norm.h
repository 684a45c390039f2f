// What the error of each pixel is relative to, where there are two references with noise of their own.
#pragma once
#include "image/image.h"

namespace drc {

// Added to the square of the norm, so that the errors of black pixels are finite: (radiance 0.1)^2.
inline constexpr double kRelativeNormOffset = 0.01;

// A Gaussian around a pixel, without the (2 hole + 1)^2 pixels in its middle. sigma and radius in pixels.
struct RingWindow {
    float sigma = 2;
    int radius = 5, hole = 1;
};
// For pixels: neighbours have a pixel's noise in them if the pixel filter is wide.
inline constexpr RingWindow kPixelRing{2, 5, 1};
// For means of blocks, whose noise is nearly their own.
inline constexpr RingWindow kBlockRing{1, 2, 0};

// The radiance D(p) of R, G and B that an error at p is divided by: error^2 / (D^2 + 0.01). If D knew the references'
// noise at p, it would be larger where this noise brightens, and the mean of the quotients would be biased. So D is
//
//     max(S(p), min(R1(p), R2(p)) / 2),
//
// S the mean of both references by the ring around p. A pixel that one reference has more than three times as bright as
// the other, a firefly, counts in S as twice the darker. The second term keeps highlights of few pixels, that both
// references show and S does not know, from being measured by what is around them; it counts only where p is twice as
// bright as its surroundings. Pixels with NaN or an infinity are left out of S, and pixels without neighbours have
// S = 0; D itself is finite and not negative. Throws Error if the sizes differ.
Image relativeNorm(const Image& first, const Image& second, const RingWindow& ring = kPixelRing);

}  // namespace drc
