// The part of the film that is rendered, as scene files and the command line give it.
#pragma once
#include <array>
#include <span>

namespace drc {

// x0 x1 y0 y1, in parts of the film's width and height from its upper left corner, each in [0, 1]; x0 < x1, y0 < y1.
using CropWindow = std::array<float, 4>;

// The window that these numbers mean, as pbrt takes them: x0 x1 y0 y1, in either order of the two edges, cut to the
// film. Throws Error with the complaint alone ("must be ..."), for the caller to say of what: other than four values,
// one that is no number, or a window of which nothing lies on the film.
CropWindow cropWindowOf(std::span<const double> values);

}  // namespace drc
