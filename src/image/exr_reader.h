// Reads OpenEXR files: all parts, scan lines or tiles, any compression.
#pragma once
#include "image/encoded_image.h"
#include "image/image_file.h"

namespace drc {

// Reads all channels of all parts, with names as in exr_channels.h, within the smallest window that contains the data
// windows of all parts; of several mip levels, the largest. A part's channels are zero outside its data window. Colours
// with other primaries are converted to Rec. 709 (exr_primaries.h). Integers keep their values, because they are
// identifiers, not colours; a warning is logged if a float cannot represent one. Deep parts are left out with a
// warning, and refused if there are no others; subsampled channels are refused. Throws Error or an exception of
// OpenEXR.
ImageFile decodeExr(const EncodedImage& encoded);

// The string attributes of the beauty part and of the others; those of another part whose values differ are named
// "part.name".
ExrMetadata decodeExrMetadata(const EncodedImage& encoded);

}  // namespace drc
