// Colours and alpha: the share of a pixel that is covered, in a channel of its own, "A".
#pragma once
#include "image/image.h"

namespace drc {

// The colours of what covers the pixels, from colours that are multiplied by alpha (its first channel); black where
// nothing does. The images have one size.
Image unpremultiplied(const Image& colours, const Image& alpha);
// The colours with a further channel "A".
Image withAlpha(const Image& colours, const Image& alpha);

}  // namespace drc
