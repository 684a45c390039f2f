// The picture so far, as shown while a render is running.
#pragma once
#include <optional>

#include "image/image.h"
#include "image/white_balance.h"

namespace drc {

// All images have the size of the film's region.
struct Preview {
    Image beauty;                // linear RGB times the film's scale, clamped at zero, unfiltered
    std::optional<Image> alpha;  // A: as LayeredPicture::alpha
    Image samples;               // X: number of camera samples

    // Maps the colours as LayeredPicture::balance does.
    void balance(const RgbMatrix& matrix);
};

}  // namespace drc
