// What OpenEXR takes on trust of an EXR's headers, checked before it reads them.
#pragma once
#include "image/encoded_image.h"

namespace drc {

// OpenEXR takes as much memory for an attribute as the file says that it has, and goes on reading where the value of a
// known type ends, whatever size stands before it. Throws Error unless each attribute lies within the file and has the
// size of its type. Source: "OpenEXR File Layout", of its documentation.
void requireSoundExrHeaders(const EncodedImage& encoded);

}  // namespace drc
