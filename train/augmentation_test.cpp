#include "augmentation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace drc {
namespace {

constexpr int kSize = 16;

struct Direction {
    double x, y, z;
};

// The direction of a texel's centre.
Direction texelDirection(Projection projection, int u, int v) {
    using std::numbers::pi;
    if (projection == Projection::LatLong) {
        const double theta = pi * (v + 0.5) / kSize, phi = pi * (u + 0.5) / kSize;
        return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
    }
    const double a = 2 * (u + 0.5) / kSize - 1, b = 2 * (v + 0.5) / kSize - 1;
    const bool wide = std::abs(a) > std::abs(b);
    const double r = wide ? a : b, phi = wide ? pi / 4 * (b / a) : pi / 2 - pi / 4 * (a / b);
    const double s = std::sqrt(2 - r * r);
    return {r * std::cos(phi) * s, r * std::sin(phi) * s, 1 - r * r};
}

// The radiance of a scene without any symmetry.
double light(const Direction& d, int channel) {
    return 2 + d.x + 0.5 * d.y * d.z + 0.3 * channel * d.y - 0.2 * d.x * d.y;
}
Direction surface(const Direction& d) { return {-d.x + 0.2 * d.y, -d.y + 0.1, -d.z + 0.3 * d.x}; }
double depth(const Direction& d) { return 3 + d.x - 0.4 * d.y; }

Direction turn(const Augmentation& a, Direction d) {
    if (a.transpose) std::swap(d.x, d.y);
    if (a.negateX) d.x = -d.x;
    if (a.negateY) d.y = -d.y;
    return d;
}

Direction turnBack(const Augmentation& a, Direction d) {
    if (a.negateY) d.y = -d.y;
    if (a.negateX) d.x = -d.x;
    if (a.transpose) std::swap(d.x, d.y);
    return d;
}

// The map of the scene transformed by `a`: its radiance in direction d is that of the scene in the direction that `a`
// maps to d.
Example mapOf(Projection projection, const Augmentation& a) {
    Example e;
    e.resize(kSize);
    e.albedo.resize(e.radiance.size());
    e.direct.resize(e.radiance.size());
    constexpr size_t kTexels = kSize * kSize;
    for (int v = 0; v < kSize; ++v)
        for (int u = 0; u < kSize; ++u) {
            const size_t i = size_t(v) * kSize + u;
            const Direction d = turnBack(a, texelDirection(projection, u, v));
            for (int c = 0; c < 3; ++c) {
                e.radiance[size_t(c) * kTexels + i] = float(light(d, a.colours[size_t(c)]));
                e.target[size_t(c) * kTexels + i] = float(2 * light(d, a.colours[size_t(c)]));
                e.albedo[size_t(c) * kTexels + i] = float(0.1 * light(d, a.colours[size_t(c)]));
                e.direct[size_t(c) * kTexels + i] = float(0.3 * light(d, a.colours[size_t(c)]));
            }
            const Direction n = turn(a, surface(d));
            e.normal[i] = float(n.x);
            e.normal[kTexels + i] = float(n.y);
            e.normal[2 * kTexels + i] = float(n.z);
            e.distance[i] = float(depth(d));
        }
    return e;
}

void expectNear(const std::vector<float>& a, const std::vector<float>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i], 1e-5);
}

void expectCommutes(Projection projection, const Augmentation& a) {
    Example changed;
    a.apply(mapOf(projection, Augmentation()), changed);
    const Example expected = mapOf(projection, a);
    expectNear(changed.radiance, expected.radiance);
    expectNear(changed.target, expected.target);
    expectNear(changed.normal, expected.normal);
    expectNear(changed.distance, expected.distance);
    expectNear(changed.albedo, expected.albedo);
    expectNear(changed.direct, expected.direct);
}

TEST(Augmentation, ChangingTheMapIsTheMapOfAChangedScene) {
    for (Projection projection : {Projection::EqualArea, Projection::LatLong}) {
        for (int s = 0; s < Augmentation::symmetries(projection); ++s)
            expectCommutes(projection, Augmentation::symmetry(s));
        for (uint64_t bits = 0; bits < 6 * 256; bits += 37)
            expectCommutes(projection, Augmentation::random(projection, bits));
    }
}

TEST(Augmentation, SymmetriesAreDifferent) {
    std::vector<std::vector<float>> seen;
    for (int s = 0; s < 8; ++s) {
        Example e;
        Augmentation::symmetry(s).apply(mapOf(Projection::EqualArea, Augmentation()), e);
        for (const auto& other : seen) EXPECT_NE(e.radiance, other);
        seen.push_back(e.radiance);
    }
}

TEST(Augmentation, LatLongKeepsItsAxes) {
    for (uint64_t bits = 0; bits < 5000; ++bits)
        EXPECT_FALSE(Augmentation::random(Projection::LatLong, bits).transpose);
}

}  // namespace
}  // namespace drc
