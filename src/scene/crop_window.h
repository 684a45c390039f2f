// The part of the film that is rendered, as specified in scene files and on the command line.
#pragma once
#include <array>
#include <span>

namespace drc {

// x0 x1 y0 y1, as fractions of the film's width and height from its upper left corner, each in [0, 1]; x0 < x1, y0 <
// y1.
using CropWindow = std::array<float, 4>;

// Returns the window of `values`, read as pbrt reads them: x0 x1 y0 y1, with the two edges of an axis in either order,
// clipped to the film. Throws Error if there are not four values, if one is NaN, or if the clipped window is empty. The
// message lacks the name of the parameter ("must be ..."), for the caller to put in front.
CropWindow cropWindowOf(std::span<const double> values);

}  // namespace drc
