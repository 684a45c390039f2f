#include "scene/shapes/parallelogram.h"

namespace drc {
namespace {

// Tolerance relative to the largest coordinate: a few units in the last place, the rounding errors of transformations.
constexpr float kRounding = 8 * 0x1p-23f;

float largest(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

}  // namespace

std::optional<Parallelogram> parallelogramOf(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
    for (size_t i = 0; i < 3; ++i) {
        const Vec3 &corner = a[i], &next = a[(i + 1) % 3], &last = a[(i + 2) % 3];
        for (size_t j = 0; j < 3; ++j) {
            // With equal winding, the shared side is traversed in opposite directions.
            if (b[(j + 1) % 3] != last || b[(j + 2) % 3] != next) continue;
            const Parallelogram whole{corner, next - corner, last - corner};
            const float scale = std::max({largest(corner), largest(next), largest(last), largest(b[j])});
            if (largest(b[j] - (next + whole.side1)) <= kRounding * scale) return whole;
        }
    }
    return {};
}

}  // namespace drc
