// Reads OpenEXR files: the first part, scan lines or tiles, any compression.
#pragma once
#include "image/encoded_image.h"
#include "image/exr_writer.h"
#include "image/image_file.h"

namespace drc {

// All channels of the first part's data window, whatever its display window is, and of several levels the largest.
// Channel names are kept, layer by layer and, within each, with "R", "G", "B" ("X", "Y", "Z" of a position) before all
// others, because the file sorts them by name. Integers keep their values: they are identifiers, not colours. Deep
// pictures and channels with fewer pixels than others are refused. Throws Error or an exception of OpenEXR.
ImageFile decodeExr(const EncodedImage& encoded);

// The place of the first part's data window within its display window, whose corner is taken for (0, 0).
ExrWindow decodeExrWindow(const EncodedImage& encoded);

// The string attributes of the first part.
ExrMetadata decodeExrMetadata(const EncodedImage& encoded);

}  // namespace drc
