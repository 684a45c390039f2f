// Reads an image that a light names.
#pragma once
#include <string>
#include <vector>

#include "math/vec.h"

namespace drc::pbrt {

struct DecodedImage {
    int width = 0, height = 0;
    std::vector<Rgb> texels;  // row-major from the top
};

// The values in the file; integers are scaled to [0, 1]. Throws Error that names the path.
DecodedImage readAsStored(const std::string& path);
// Like readAsStored(), but with integers decoded from sRGB.
DecodedImage readLinear(const std::string& path);

}  // namespace drc::pbrt
