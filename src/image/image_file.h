// The result of reading a picture's file.
#pragma once
#include "image/image.h"

namespace drc {

// How a file stores its values. Integers are read as [0, 1]; by convention, such pictures are sRGB-encoded.
enum class Encoding { UInt8, UInt16, Float };

struct ImageFile {
    Image image;  // values as stored: integers are neither decoded nor multiplied by alpha
    Encoding encoding = Encoding::Float;
    bool isSrgbEncoded() const { return encoding != Encoding::Float; }
};

}  // namespace drc
