// White balance: a picture is changed so that what looked white under a light of another colour is white.
#pragma once
#include <array>

#include "math/vec.h"

namespace drc {

// A linear map of colours; rows first.
struct RgbMatrix {
    std::array<Vec3, 3> rows;

    Rgb operator*(const Rgb& c) const {
        const Vec3 v(c.x, c.y, c.z);
        return Rgb(dot(rows[0], v), dot(rows[1], v), dot(rows[2], v));
    }
    // An upper bound on the variances of the map's result, from those of R, G and B, however these are correlated.
    Rgb ofVariance(const Rgb& variance) const;
};

// Maps linear Rec. 709 under a light of the given colour to how it looks under D65: von Kries' scaling of the responses
// of cones, in Bradford's space (K. Lam's thesis, 1985), as pbrt-v4 balances pictures. The light itself, whatever its
// brightness, becomes grey of the same luminance. The colour must have a positive X, Y and Z.
RgbMatrix whiteBalance(const Rgb& light);

// The colour of daylight of a correlated temperature in kelvin, from 4000 to 25000, with a luminance of one: the CIE's
// locus (CIE 15, "Colorimetry"). D65 is at 6504 K.
Rgb daylight(float kelvin);

}  // namespace drc
