// The mean of a quantity over a picture, and how sure it is where neighbouring pixels err alike.
#pragma once
#include <limits>

#include "image/convolution.h"

namespace drc {

// NaN: not known.
struct Estimate {
    double mean = std::numeric_limits<double>::quiet_NaN();
    double standardError = std::numeric_limits<double>::quiet_NaN();
};

// The side of the tiles for a picture: 32 pixels, which is more than the blotches of denoisers and caches measure, but
// less in small pictures, so that there are some 64 tiles; at least 8.
int tileSide(int width, int height);

// The mean of all values that are not NaN, and its standard error. The picture is divided into tiles of about the given
// side, and these are taken as independent, not the pixels: filters and caches make neighbours err alike. A tile's
// variance is estimated from its differences to the tiles beside, above and below it (the estimator of successive
// differences of survey sampling; Wolter, "Introduction to Variance Estimation", 2007, chapter 8), so that it does not
// matter that one side of the picture is harder than the other. What adjacent tiles differ by in the scene itself
// remains in it: it is rather too large than too small. NaN where there are fewer than two tiles.
Estimate meanOverTiles(const Plane& values, int side);

// The standard error of the mean of values whose true mean is zero: from the tiles' own sums.
double standardErrorOfZero(const Plane& values, int side);

}  // namespace drc
