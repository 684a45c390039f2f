// The result of reading a picture's file.
#pragma once
#include "image/exr_storage.h"
#include "image/image.h"

namespace drc {

// How a file stores its values. Integers are read as [0, 1]; by convention, such pictures are sRGB-encoded.
enum class Encoding { UInt8, UInt16, Float };

struct ImageFile {
    Image image;  // values as stored: integers are neither decoded nor multiplied by alpha
    Encoding encoding = Encoding::Float;
    // The gamma of a PNG that does not declare sRGB: stored value = displayed intensity ^ gamma. 0: the integers are
    // sRGB-encoded.
    float gamma = 0;
    // Set for EXR files only.
    ExrWindow window{};
    ExrStorage storage{};
    std::string beautyPart{};  // of a file with several parts: the part whose channels are not prefixed by its name

    bool isSrgbEncoded() const { return encoding != Encoding::Float; }
};

}  // namespace drc
