// The picture so far, as shown while a render is running.
#pragma once
#include <optional>

#include "image/image.h"
#include "image/white_balance.h"

namespace drc {

// All images have the size of the film's region.
struct Preview {
    Image beauty;                // linear RGB multiplied by the film's scale, clamped at zero, not denoised
    std::optional<Image> alpha;  // A: as LayeredPicture::alpha
    Image samples;               // X: number of camera samples

    // Applies a colour matrix, as LayeredPicture::balance does.
    void balance(const RgbMatrix& matrix);
};

}  // namespace drc
