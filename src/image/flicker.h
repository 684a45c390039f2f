// How much an animation flickers: the error of what changes from one frame to the next, on the surfaces that both show.
//
// DX(t) = X(t+1) warped onto frame t, minus X(t). With T the frames to judge, and R1 and R2 two reference animations of
// different seeds, the flicker is the mean of (DT - DR1)(DT - DR2) / (D^2 + 0.01), with D of relative_norm.h. Its
// expectation has no noise of the references, true changes of light count for nothing, and blurred frames gain nothing.
#pragma once
#include <vector>

#include "image/cross_error.h"
#include "image/frame_surfaces.h"

namespace drc {

struct Flicker {
    Estimate pixels;  // of pixels
    Estimate blocks;  // of means of 8x8 pixels
    // The median and the 99th percentile of |DT|, the greatest of R, G and B, in displayed colours in units of 1/255.
    double medianStep = 0, percentile99 = 0;
    double compared = 0;  // the share of pixels whose point both frames show
};

// The flicker between two frames: surfaces, references and tests of both, linear RGB. The surfaces are those of one of
// the references. exposure: stops, for displayed colours.
struct FramePair {
    const FrameSurfaces &surfaces, &nextSurfaces;
    const Image &first, &nextFirst, &second, &nextSecond;  // the references
};
Flicker flickerBetween(const FramePair& pair, const Image& test, const Image& nextTest, float exposure);

// Means over pairs of frames, whose errors are taken as independent.
Flicker meanFlicker(const std::vector<Flicker>& pairs);

}  // namespace drc
