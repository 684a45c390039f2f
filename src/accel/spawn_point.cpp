#include "accel/spawn_point.h"

#include <algorithm>
#include <bit>

namespace drc {
namespace {

// Rotations mix coordinates, so that each has the rounding error of the largest. p is off by up to two units in the
// last place of that, and a ray transformed to the shape's own space by as many again.
constexpr float kShareOfLargest = 8 * 0x1p-23f;

}  // namespace

Vec3 SpawnPoint::towards(const Vec3& d) const {
    constexpr float kOrigin = 1 / 32.f, kFloatScale = 1 / 65536.f, kIntScale = 256.f;
    const Vec3 n = dot(ng, d) < 0 ? -ng : ng;
    Vec3 r;
    for (int i = 0; i < 3; ++i) {
        if (std::abs(p[i]) < kOrigin) {
            r[i] = p[i] + kFloatScale * n[i];
        } else {
            const int offset = int(kIntScale * n[i]);
            r[i] = std::bit_cast<float>(std::bit_cast<int>(p[i]) + (p[i] < 0 ? -offset : offset));
        }
    }
    const float least = kShareOfLargest * std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    return dot(r - p, n) < least ? p + n * least : r;
}

}  // namespace drc
