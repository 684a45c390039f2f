// Computes an exposure from the picture alone, as a camera's meter does.
#pragma once
#include "image/image.h"

namespace drc {

// Stops by which to brighten the picture (linear RGB or grey) so that it is neither dark nor overexposed:
//
// - The trimmed mean of log luminance becomes middle grey (view_transform.h).
// - At most the brightest tenth of the pixels is clipped at 1; otherwise the exposure is reduced until this holds.
// - If the brightest tenth then begins below 0.7, as in a bright room, the exposure is raised until it begins at 0.7,
//   but by no more than one stop.
//
// Lamps, windows and fireflies hardly change the result as long as they fill less than a tenth of the picture. Black
// borders of any size do not change it: pixels more than 10 stops darker than the brightest tenth are left out, as are
// NaN and infinity. 0 if no pixel is left. The result has the same bits for any number of threads, and a picture that
// is k times as bright gives log2(k) less, to within a 32nd of a stop.
float autoExposure(const Image& linear);

}  // namespace drc
