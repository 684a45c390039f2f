// White balance: changes a picture so that objects that look white under a light of another colour become white.
#pragma once
#include <array>

#include "math/vec.h"

namespace drc {

// A linear map of colours as a 3 x 3 matrix, by rows.
struct RgbMatrix {
    std::array<Vec3, 3> rows;

    Rgb operator*(const Rgb& c) const {
        const Vec3 v(c.x, c.y, c.z);
        return Rgb(dot(rows[0], v), dot(rows[1], v), dot(rows[2], v));
    }
    // An upper bound on the variances of the map's result, from those of R, G and B, however these are correlated.
    Rgb ofVariance(const Rgb& variance) const;
};

// Maps linear Rec. 709 colours seen under a light of the given colour to those seen under D65: von Kries' scaling of
// the responses of cones, in Bradford's space (K. Lam's thesis, 1985), as pbrt-v4 balances pictures. The light itself,
// whatever its brightness, becomes grey of the same luminance. The colour must have a positive X, Y and Z.
RgbMatrix whiteBalance(const Rgb& light);

// The colour of daylight of a correlated temperature in kelvin, from 4000 to 25000, with a luminance of one: the CIE's
// locus (CIE 15, "Colorimetry"). D65 is at 6504 K.
Rgb daylight(float kelvin);

}  // namespace drc
