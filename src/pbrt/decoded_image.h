// A picture that a scene names, as colours.
#pragma once
#include <string>
#include <vector>

#include "math/vec.h"

namespace drc::pbrt {

struct DecodedImage {
    int width = 0, height = 0;
    std::vector<Rgb> texels;     // row-major from the top
    bool isSrgbEncoded = false;  // texels are as stored, and stored in integers
};

// Texels as the file stores them; integers as [0, 1]. Throws Error, naming the path.
DecodedImage readAsStored(const std::string& path);
// The same, but decoded from sRGB where the file stores integers.
DecodedImage readLinear(const std::string& path);

}  // namespace drc::pbrt
