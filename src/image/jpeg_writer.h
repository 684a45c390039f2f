// Writes JPEG files, by libjpeg-turbo.
#pragma once
#include <string>

#include "image/image.h"

namespace drc {

// Encodes linear RGB (the first three channels, or grey) as sRGB with 8 bits, clipped at 1. quality: libjpeg's, from 1
// to 100. From 90 on, chroma has the full resolution; below, half of it. `path` is for messages. Throws Error if the
// image is empty or larger than the format allows, 65500 pixels a side.
std::string encodeJpeg(const Image& linear, int quality, const std::string& path = "a JPEG");

}  // namespace drc
