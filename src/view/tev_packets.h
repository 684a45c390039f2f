// The packets of the network protocol by which programs tell tev, the image viewer, what to show. A packet consists of
// its own length in bytes, its type and a payload. Integers and floats are little-endian; strings end with a zero byte,
// so names must not contain one. grabFocus: whether tev selects the image.
//     https://github.com/Tom94/tev
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace drc::tev {

// Opens a file of the machine that tev runs on. channels: the ones to show, for example "direct.R,direct.G"; empty:
// all.
std::string openImage(std::string_view path, std::string_view channels, bool grabFocus);
// Reads an open file again.
std::string reloadImage(std::string_view name, bool grabFocus);
std::string closeImage(std::string_view name);
// Creates an image of zeros, in place of any image of that name. Channels are named as in OpenEXR: "R", "normal.X".
std::string createImage(std::string_view name, bool grabFocus, int width, int height,
                        std::span<const std::string> channels);
// Replaces a part of an image, in some of its channels. values: part.count() * channels.size() numbers, row by row,
// with the channels of each pixel together. Throws std::length_error if the packet would have 4 GiB or more.
std::string updateImage(std::string_view name, bool grabFocus, const PixelRegion& part,
                        std::span<const std::string> channels, std::span<const float> values);

}  // namespace drc::tev
