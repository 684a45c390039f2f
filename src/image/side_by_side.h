// Combines pictures of several renders in one, for comparison by eye.
#pragma once
#include <vector>

#include "image/image.h"

namespace drc {

// Pixels [x0, x1) x [y0, y1).
struct PixelRect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

// A picture of the same size as each of the n images, divided into n strips from left to right or, with `rows`, from
// top to bottom. Strip i shows its part of images[i]. White lines, `line` pixels wide, separate the strips. images: RGB
// or grey. Throws Error if there are none, if they differ in size, or if there are more strips than pixels.
Image strips(const std::vector<Image>& images, bool rows = false, int line = 2);

// Parts cut out of the images, with a row for each part and a column for each image. Each pixel becomes a square of
// zoom x zoom pixels, and `gap` white pixels separate the cut-outs. Throws Error if the pictures differ in size, or if
// a part is empty, reaches outside or differs in size from the first.
Image cutOuts(const std::vector<Image>& images, const std::vector<PixelRect>& parts, int zoom = 1, int gap = 4);

}  // namespace drc
