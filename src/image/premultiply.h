// Conversion of colours that are premultiplied by alpha. Alpha, the covered share of a pixel, is the channel "A".
#pragma once
#include "image/image.h"

namespace drc {

// Divides premultiplied colours by alpha (the first channel of `alpha`); black where alpha is zero. Both images must
// have the same size.
Image unpremultiplied(const Image& colours, const Image& alpha);
// The colours with the first channel of `alpha` as a further channel "A".
Image withAlpha(const Image& colours, const Image& alpha);

}  // namespace drc
