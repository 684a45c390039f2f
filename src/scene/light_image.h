// The picture that an environment, a projector or a goniometric diagram is made of.
#pragma once
#include <vector>

#include "math/vec.h"

namespace drc {

struct LightImage {
    int width = 0, height = 0;
    std::vector<Rgb> texels;  // row-major; what row 0 is, the light says

    bool empty() const { return width <= 0 || height <= 0 || texels.size() < size_t(width) * size_t(height); }
    // Not finite becomes black, negative zero: in pictures both are damage.
    void mend() {
        for (Rgb& c : texels) c = isFinite(c) ? clampNonNegative(c) : Rgb(0.f);
    }
    // Bilinear, at (u, v) in [0,1]^2 with (0,0) the corner of row 0. Beyond the edges the picture repeats along a row
    // if `wraps`; else, and across rows, its edge goes on.
    Rgb lookup(const Vec2& uv, bool wraps) const {
        const float x = uv.x * float(width) - 0.5f, y = uv.y * float(height) - 0.5f;
        const float x0 = std::floor(x), y0 = std::floor(y);
        const int i = column(int(x0), wraps), next = column(int(x0) + 1, wraps);
        const int j = std::clamp(int(y0), 0, height - 1), below = std::clamp(int(y0) + 1, 0, height - 1);
        return lerp(y - y0, lerp(x - x0, at(i, j), at(next, j)), lerp(x - x0, at(i, below), at(next, below)));
    }
    const Rgb& at(int x, int y) const { return texels[size_t(y) * size_t(width) + size_t(x)]; }

  private:
    int column(int x, bool wraps) const { return wraps ? (x % width + width) % width : std::clamp(x, 0, width - 1); }
};

}  // namespace drc
