// The packets of tev's network protocol: by them a program tells tev, the image viewer, what to show. Each is its own
// length in bytes, its type and a payload; integers and floats are little-endian, strings end with a zero byte, so
// names must have none. grabFocus: whether tev selects the image.
//     https://github.com/Tom94/tev
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace drc::tev {

// Opens a file of the machine that tev runs on. channels: shows these alone, as "direct.R,direct.G"; empty: all.
std::string openImage(std::string_view path, std::string_view channels, bool grabFocus);
// Reads an open file again.
std::string reloadImage(std::string_view name, bool grabFocus);
std::string closeImage(std::string_view name);
// Makes an image of zeros, in place of any of that name. Channels are named as in OpenEXR: "R", "normal.X".
std::string createImage(std::string_view name, bool grabFocus, int width, int height,
                        std::span<const std::string> channels);
// Replaces a part of an image, in some of its channels. values: those of each pixel together, row by row, as many as
// part.count() * channels.size(). Throws std::length_error from 4 GiB on, which a packet cannot have.
std::string updateImage(std::string_view name, bool grabFocus, const PixelRegion& part,
                        std::span<const std::string> channels, std::span<const float> values);

}  // namespace drc::tev
