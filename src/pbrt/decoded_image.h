// Reads an image that belongs to a light.
#pragma once
#include <string>
#include <vector>

#include "math/vec.h"

namespace drc::pbrt {

struct DecodedImage {
    int width = 0, height = 0;
    std::vector<Rgb> texels;  // row-major, top row first
};

// Returns the values as stored, with integers scaled to [0, 1]. Throws Error that names the path.
DecodedImage readAsStored(const std::string& path);
// Like readAsStored(), but with integers decoded from sRGB.
DecodedImage readLinear(const std::string& path);

}  // namespace drc::pbrt
