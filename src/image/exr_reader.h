// Reads OpenEXR files: all parts, scan lines or tiles, any compression.
#pragma once
#include "image/encoded_image.h"
#include "image/image_file.h"

namespace drc {

// All channels of all parts, under the names that exr_channels.h gives, within the smallest window that holds the data
// windows of all parts; of several levels the largest. Where a part has no data, its channels are zero. Colours of
// other primaries become Rec. 709's (exr_primaries.h). Integers keep their values: they are identifiers, not colours; a
// warning tells if one has more digits than a float. Deep parts are left out with a warning, and refused if there is no
// other; channels with fewer pixels than others are refused. Throws Error or an exception of OpenEXR.
ImageFile decodeExr(const EncodedImage& encoded);

// The string attributes of the part that is the beauty, and those of the others where they differ, as "part.name".
ExrMetadata decodeExrMetadata(const EncodedImage& encoded);

}  // namespace drc
