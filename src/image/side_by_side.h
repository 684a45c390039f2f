// Pictures of several renders in one, so that they can be compared by eye.
#pragma once
#include <vector>

#include "image/image.h"

namespace drc {

// Pixels [x0, x1) x [y0, y1).
struct PixelRect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

// A picture of the size of one, of which each of n pictures shows its own n-th part, from left to right, or with `rows`
// from top to bottom. White lines of `line` pixels stand on the borders. RGB or grey pictures of one size; throws Error
// if they are not, or if there are more of them than pixels.
Image strips(const std::vector<Image>& images, bool rows = false, int line = 2);

// A row for each part that is cut out, with a column for each picture; each pixel becomes a square of `zoom` pixels,
// and `gap` white pixels stand between them. Throws Error if the pictures differ in size, or if a part is empty,
// reaches outside or differs in size from the first.
Image cutOuts(const std::vector<Image>& images, const std::vector<PixelRect>& parts, int zoom = 1, int gap = 4);

}  // namespace drc
