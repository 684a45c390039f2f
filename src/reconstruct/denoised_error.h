// The error of a denoised picture, estimated from its half buffers, without a reference.
//
// A and B are pictures of half of the samples each, a and b the same denoised. The noise of B knows nothing of that of
// A, and so nothing of a. Therefore
//     ((a - B)^2 + (b - A)^2 - (A - B)^2) / 2
// has the expectation of the squared error of a and b: what the denoiser has left of the noise, and what it has smeared
// or invented. A and B have to be independent (RenderParams::independentHalves), since stratification over all samples
// makes each half err where the other does not, and the sum above too small. So must be their G-buffers, for the same
// reason.
#pragma once
#include <functional>

#include "film/layered_picture.h"

namespace drc {

struct DenoisedError {
    // X: the relative error to expect of a pixel: the square root of the mean of (T - I)^2 / (D^2 + 0.01) over the
    // channels, with T the denoised picture, I the true one and D the radiance around the pixel (relative_norm.h) in
    // the denoised halves, averaged over the pixels around.
    Image local;
    // The relative error to expect of the whole picture (root mean square): the square root of what `drc compare` calls
    // error, or NaN if not a single pixel has samples in both halves.
    double whole = 0;
};

// unfiltered: as a session's snapshot, of an integrator with halves and RenderParams::independentHalves. filter: the
// denoiser. It is applied to both halves, so this takes twice as long as denoising the picture.
DenoisedError estimateDenoisedError(const LayeredPicture& unfiltered,
                                    const std::function<void(LayeredPicture&)>& filter);

}  // namespace drc
