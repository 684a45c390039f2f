// Reduces a colour image to one channel as pbrt-v4 does, for textures that need numbers, such as masks.
#pragma once
#include "image/image.h"
#include "scene/textures/mip_pyramid.h"

namespace drc::pbrt {

// One channel: the alpha of an image that has red, green and blue, and an alpha which is not 1 everywhere; else the
// mean of red, green and blue; else the first channel. encoding: of the image, and of the result. A mean is linear. As
// in pbrt, alpha is decoded as the colours are.
Image meanOrAlpha(const Image& image, TexelEncoding& encoding);

}  // namespace drc::pbrt
