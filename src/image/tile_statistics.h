// The mean of a quantity over a picture, and its standard error, which allows for correlation between neighbouring
// pixels.
#pragma once
#include <limits>

#include "image/convolution.h"

namespace drc {

// NaN: unknown.
struct Estimate {
    double mean = std::numeric_limits<double>::quiet_NaN();
    double standardError = std::numeric_limits<double>::quiet_NaN();
};

// The side of a picture's tiles, in pixels: 32, which is larger than the blotches of denoisers and caches. Less in
// small pictures, so that there are about 64 tiles, but at least 8.
int tileSide(int width, int height);

// The mean of all values that are not NaN, and its standard error. The picture is divided into tiles of about the given
// side, and tiles, not pixels, are taken as independent, because filters and caches correlate the errors of neighbours.
// A tile's variance is estimated from its differences from the tiles beside, above and below it (the estimator of
// successive differences of survey sampling; Wolter, "Introduction to Variance Estimation", 2007, chapter 8), so that a
// slow variation of the error over the picture does not count as uncertainty. Differences of the true values between
// adjacent tiles still count, so the result tends to overestimate the standard error. NaN if there are fewer than two
// tiles.
Estimate meanOverTiles(const Plane& values, int side);

// The standard error of the mean of values whose expectation is zero, from the squares of the tiles' sums.
double standardErrorOfZero(const Plane& values, int side);

}  // namespace drc
