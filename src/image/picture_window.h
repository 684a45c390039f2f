// Pictures whose stored pixels are a part of the whole picture, or more than it: OpenEXR's data and display windows.
#pragma once
#include <string>

#include "image/exr_storage.h"
#include "image/image.h"

namespace drc {

// "48x40 at (10, 20) of 640x480", or "48x40" if the stored pixels are the whole picture, for messages.
std::string placeString(const Image& image, const ExrWindow& window);

bool isWhole(const Image& image, const ExrWindow& window);
// Whether any stored pixel is within the whole picture.
bool overlaps(const Image& image, const ExrWindow& window);

struct PlacedPicture {
    std::string path;
    const Image& image;
    const ExrWindow& window;
};

// Throws Error, naming both files and the reason, unless their pixels show the same part of the same whole. For a file
// whose format has no windows, only the size is checked. what: the operation, for the message, such as "compared".
void requireSamePlace(const PlacedPicture& first, const PlacedPicture& other, const std::string& what);

// The whole picture: stored pixels outside are cut off, and missing pixels are zero in all channels. `path` is for
// messages. Throws Error if the whole is beyond the limits of pictures or does not fit in memory.
Image placedInWindow(const Image& image, const ExrWindow& window, const std::string& path);

}  // namespace drc
