// Checks an EXR's headers before OpenEXR, which trusts them, reads them.
#pragma once
#include <vector>

#include "image/encoded_image.h"
#include "image/exr_storage.h"

namespace drc {

// OpenEXR allocates as much memory for an attribute as the file claims. After an attribute of a known type, it
// continues where the type's value ends, even if the file gives another size. Throws Error unless each attribute lies
// within the file and has the size of its type. Returns the attributes of each part. Source: "OpenEXR File Layout", in
// its documentation.
std::vector<ExrAttributes> requireSoundExrHeaders(const EncodedImage& encoded);

}  // namespace drc
