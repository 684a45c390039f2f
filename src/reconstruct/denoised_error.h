// The error of a denoised picture, estimated from its half buffers, without a reference.
//
// A and B are pictures of half of the samples each; a and b are A and B after denoising. The noise of B is independent
// of that of A, and so of a. Therefore
//     ((a - B)^2 + (b - A)^2 - (A - B)^2) / 2
// has the expectation of the squared error of a and b: the noise that the denoiser has left, and the detail that it has
// smeared or invented. A and B have to be independent (RenderParams::independentHalves): with stratification over all
// samples, each half errs where the other does not, and the sum above is too small. For the same reason, their
// G-buffers have to be independent.
#pragma once
#include <functional>

#include "film/layered_picture.h"

namespace drc {

struct DenoisedError {
    // X: the expected relative error of a pixel: the square root of the mean of (T - I)^2 / (D^2 + 0.01) over the
    // channels and over the pixels around. T is the denoised picture, I the true one, and D the radiance around the
    // pixel (relative_norm.h) in the denoised halves.
    Image local;
    // The expected relative error of the whole picture (root mean square): the square root of the error that `drc
    // compare` prints. NaN if no pixel has samples in both halves.
    double whole = 0;
};

// unfiltered: the snapshot of a session, with IntegratorTraits::halves and RenderParams::independentHalves. filter: the
// denoiser. It is applied to both halves, so this takes twice as long as denoising the picture.
DenoisedError estimateDenoisedError(const LayeredPicture& unfiltered,
                                    const std::function<void(LayeredPicture&)>& filter);

}  // namespace drc
