// Finds the exposure of a picture from the picture alone, as a camera's meter does.
#pragma once
#include "image/image.h"

namespace drc {

// Stops by which the picture (linear RGB or grey) is to be brightened so that it is neither dark nor burnt out:
//
// - The trimmed mean of log luminance becomes middle grey (view_transform.h).
// - No more is clipped at 1 than the brightest tenth of the pixels: else the picture becomes darker until that holds.
// - A bright room is not a grey one: if the brightest tenth begins below 0.7, the picture becomes brighter, by up to a
//   stop, until it begins there.
//
// Lamps, windows and fireflies hardly move it, as long as they fill less than a tenth of the picture; black borders do
// not, however large: pixels that are 10 stops darker than the brightest tenth are left out. NaN and infinity are left
// out too. 0 if nothing is left. The same picture gives the same bits, whatever the number of threads, and a picture
// that is k times as bright gives log2(k) less, to within a 32nd of a stop.
float autoExposure(const Image& linear);

}  // namespace drc
