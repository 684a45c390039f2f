// The part of the film that is rendered, as specified in scene files and on the command line.
#pragma once
#include <array>
#include <span>

namespace drc {

// x0 x1 y0 y1, as fractions of the film's width and height from its upper left corner, each in [0, 1]; x0 < x1, y0 <
// y1.
using CropWindow = std::array<float, 4>;

// The window of these numbers, read as pbrt does: x0 x1 y0 y1, with the two edges in either order, clipped to the film.
// Throws Error with the complaint alone ("must be ..."), so that the caller can name the parameter: if there are not
// four values, if one is NaN, or if the window lies outside the film.
CropWindow cropWindowOf(std::span<const double> values);

}  // namespace drc
