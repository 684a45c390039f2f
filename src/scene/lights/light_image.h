// The image of an environment, projection or goniometric light.
#pragma once
#include <vector>

#include "math/vec.h"

namespace drc {

struct LightImage {
    int width = 0, height = 0;
    std::vector<Rgb> texels;  // row-major; the kind of light defines where row 0 is
    bool repeats = false;     // repeats beyond all edges, whatever lookup() is told

    bool empty() const { return width <= 0 || height <= 0 || texels.size() < size_t(width) * size_t(height); }
    // Replaces non-finite texels by black and negative values by zero: in an image file both are defects.
    void mend() {
        for (Rgb& c : texels) c = isFinite(c) ? clampNonNegative(c) : Rgb(0.f);
    }
    // Bilinear lookup at (u, v) in [0,1]^2, where (0,0) is the corner of row 0. Beyond its edges the image repeats
    // along a row if `wraps`; otherwise, and across rows, the edge texels are extended, unless `repeats` is set.
    Rgb lookup(const Vec2& uv, bool wraps) const {
        const float x = uv.x * float(width) - 0.5f, y = uv.y * float(height) - 0.5f;
        const float x0 = std::floor(x), y0 = std::floor(y);
        const int i = index(int(x0), width, wraps || repeats), next = index(int(x0) + 1, width, wraps || repeats);
        const int j = index(int(y0), height, repeats), below = index(int(y0) + 1, height, repeats);
        return lerp(y - y0, lerp(x - x0, at(i, j), at(next, j)), lerp(x - x0, at(i, below), at(next, below)));
    }
    const Rgb& at(int x, int y) const { return texels[size_t(y) * size_t(width) + size_t(x)]; }

  private:
    static int index(int i, int count, bool wraps) {
        return wraps ? (i % count + count) % count : std::clamp(i, 0, count - 1);
    }
};

}  // namespace drc
