// JPEG, by libjpeg-turbo.
#pragma once
#include "image/encoded_image.h"
#include "image/image_file.h"

namespace drc {

// Channels "Y" or "R", "G", "B". Inks (CMYK and YCCK, inverted as Adobe's programs write them) become colours: each is
// what its ink and black let through. An orientation that a camera noted down is not applied. Throws Error, also where
// libjpeg would go on with grey in place of what is missing.
ImageFile decodeJpeg(const EncodedImage& encoded);

}  // namespace drc
