// OpenEXR files: the first part, scan lines or tiles, of any compression.
#pragma once
#include "image/encoded_image.h"
#include "image/exr_writer.h"
#include "image/image_file.h"

namespace drc {

// All channels of the first part's data window, whatever its display window is; of several levels, the largest. Channel
// names as stored, layer by layer and, within each, "R", "G", "B" ("X", "Y", "Z" of a position) before all others, for
// the file itself sorts them by name. Integers are numbers as they are: identifiers, no colours. Deep pictures and
// channels of fewer pixels than others are refused. Throws Error or an exception of OpenEXR's.
ImageFile decodeExr(const EncodedImage& encoded);

// The string attributes of the first part.
ExrMetadata decodeExrMetadata(const EncodedImage& encoded);

}  // namespace drc
