// The size of the finest radiance cells at first.
#pragma once
#include <cmath>

namespace drc {

// distance: the median distance that the pictures show. The cells' edge is about 16 pixels of a picture 1280 pixels
// wide, rounded to a power of two, so that cameras at similar distances have the same cells.
inline float cellSizeFor(float distance) { return std::exp2(std::round(std::log2(0.0144f * distance))); }

}  // namespace drc
