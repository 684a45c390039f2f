// Reduces a colour image to one channel as pbrt-v4 does, for textures that need numbers, such as masks.
#pragma once
#include "image/image.h"
#include "scene/textures/mip_pyramid.h"

namespace drc::pbrt {

// Returns one channel: alpha, if the image has red, green and blue and an alpha that is not 1 everywhere; else the mean
// of red, green and blue; for images of fewer than three channels, the first. encoding: the image's on input, the
// result's on output. A mean is linear, except of a grey image, which is returned as stored. As in pbrt, alpha is
// decoded like the colours.
Image meanOrAlpha(const Image& image, TexelEncoding& encoding);

}  // namespace drc::pbrt
