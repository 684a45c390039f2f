// The mean of a quantity over a picture, and its standard error if the errors of neighbouring pixels are correlated.
#pragma once
#include <limits>

#include "image/convolution.h"

namespace drc {

// NaN: unknown.
struct Estimate {
    double mean = std::numeric_limits<double>::quiet_NaN();
    double standardError = std::numeric_limits<double>::quiet_NaN();
};

// The side of the tiles for a picture: 32 pixels, which is more than the blotches of denoisers and caches measure; less
// in small pictures, so that there are some 64 tiles, but at least 8.
int tileSide(int width, int height);

// The mean of all values that are not NaN, and its standard error. The picture is divided into tiles of about the given
// side, and tiles, not pixels, are taken as independent, because filters and caches correlate the errors of neighbours.
// A tile's variance is estimated from its differences from the tiles beside, above and below it (the estimator of
// successive differences of survey sampling; Wolter, "Introduction to Variance Estimation", 2007, chapter 8), so that a
// scene with an easy and a hard side does not seem uncertain. Differences of the scene itself between adjacent tiles
// remain, so the result rather overestimates the standard error. NaN if there are fewer than two tiles.
Estimate meanOverTiles(const Plane& values, int side);

// The standard error of the mean of values whose true mean is zero, from the tiles' own sums.
double standardErrorOfZero(const Plane& values, int side);

}  // namespace drc
