// JPEG, by libjpeg-turbo.
#pragma once
#include "image/encoded_image.h"
#include "image/image_file.h"

namespace drc {

// Channels "Y" or "R", "G", "B". CMYK and YCCK (inverted, as Adobe's programs write them) become RGB: each channel is
// the light that its ink and black transmit. The orientation tag of a camera is not applied. Throws Error, even where
// libjpeg would fill missing data with grey.
ImageFile decodeJpeg(const EncodedImage& encoded);

}  // namespace drc
