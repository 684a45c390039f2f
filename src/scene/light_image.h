// The picture that an environment, a projector or a goniometric diagram is made of.
#pragma once
#include <vector>

#include "math/vec.h"

namespace drc {

struct LightImage {
    int width = 0, height = 0;
    std::vector<Rgb> texels;  // row-major; what row 0 is, the light says
    bool repeats = false;     // beyond all edges, whatever a lookup says

    bool empty() const { return width <= 0 || height <= 0 || texels.size() < size_t(width) * size_t(height); }
    // Not finite becomes black, negative zero: in pictures both are damage.
    void mend() {
        for (Rgb& c : texels) c = isFinite(c) ? clampNonNegative(c) : Rgb(0.f);
    }
    // Bilinear, at (u, v) in [0,1]^2 with (0,0) the corner of row 0. Beyond the edges the picture repeats along a row
    // if `wraps`; else, and across rows, its edge goes on, unless it repeats both ways.
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
