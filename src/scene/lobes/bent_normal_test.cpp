#include "scene/lobes/bent_normal.h"

#include <gtest/gtest.h>

#include "scene/lobes/lobe_testing.h"

namespace drc {
namespace {

using test::randomDirection;

// A shading normal on the side of ng, and a view on either side.
struct Case {
    Vec3 shading, geometric, wo;
};
Case randomCase(std::mt19937& rng) {
    Case c{randomDirection(rng), randomDirection(rng), randomDirection(rng)};
    c.shading = faceForward(c.shading, c.geometric);
    return c;
}
Vec3 mirrored(const Vec3& wo, const Vec3& n) { return n * (2 * dot(wo, n)) - wo; }

// What is to be kept above its horizon: its sine, on the viewer's side.
float elevation(const Case& c, const Vec3& n, KeepAbove what) {
    const float side = dot(c.wo, c.geometric) < 0 ? -1.f : 1.f;
    return side * (what == KeepAbove::View ? dot(c.wo, n) : dot(mirrored(c.wo, n), c.geometric));
}

TEST(BentNormal, IsBentOnlyWhereItHasToBeAndNoFarther) {
    std::mt19937 rng(1);
    for (const KeepAbove what : {KeepAbove::View, KeepAbove::MirroredView}) {
        int bent = 0;
        for (int i = 0; i < 20000; ++i) {
            const Case c = randomCase(rng);
            const float least = std::min(0.01f, 0.9f * absDot(c.wo, c.geometric));
            const auto n = bentNormal(c.shading, c.geometric, c.wo, what);
            ASSERT_EQ(n.has_value(), elevation(c, c.shading, what) < least) << i;
            if (!n) continue;
            ++bent;
            EXPECT_NEAR(length(*n), 1, 1e-5f);
            EXPECT_NEAR(elevation(c, *n, what), least, 2e-5f) << i;
            // On the arc from the shading normal to the geometric one.
            EXPECT_GT(dot(*n, c.geometric), dot(c.shading, c.geometric));
            EXPECT_NEAR(dot(*n, cross(c.shading, c.geometric)), 0, 1e-5f);
            EXPECT_GT(dot(cross(c.geometric, *n), cross(c.geometric, c.shading)), -1e-6f);
        }
        EXPECT_GT(bent, 2000);
    }
}

TEST(BentNormal, KeepsTheViewAboveWhereItKeepsTheMirroredView) {
    std::mt19937 rng(2);
    for (int i = 0; i < 20000; ++i) {
        const Case c = randomCase(rng);
        if (bentNormal(c.shading, c.geometric, c.wo, KeepAbove::View)) {
            EXPECT_TRUE(bentNormal(c.shading, c.geometric, c.wo, KeepAbove::MirroredView));
        }
        const auto n = bentNormal(c.shading, c.geometric, c.wo, KeepAbove::MirroredView);
        if (!n) continue;
        EXPECT_GT(elevation(c, *n, KeepAbove::View), 0);
    }
}

// No edge where the bend begins, nor elsewhere: small steps of the view and of the shading normal make small steps.
TEST(BentNormal, IsContinuous) {
    const Vec3 ng(0, 0, 1);
    for (const KeepAbove what : {KeepAbove::View, KeepAbove::MirroredView})
        for (float view = 0.02f; view < 1.5f; view += 0.05f)
            for (float azimuth = 0; azimuth < 3.2f; azimuth += 0.3f) {
                const Vec3 wo(std::cos(view), 0, std::sin(view));
                Vec3 before = ng;
                for (float lean = 0; lean < 1.5f; lean += 1e-3f) {
                    const Vec3 shading(std::sin(lean) * std::cos(azimuth), std::sin(lean) * std::sin(azimuth),
                                       std::cos(lean));
                    const Vec3 n = bentNormal(shading, ng, wo, what).value_or(shading);
                    ASSERT_LT(length(n - before), 2.5e-3f) << view << " " << azimuth << " " << lean;
                    before = n;
                }
            }
}

TEST(BentNormal, FlatSurfacesAreNeverBent) {
    std::mt19937 rng(3);
    for (int i = 0; i < 20000; ++i) {
        const Case c = randomCase(rng);
        // Up to the rounding of normals, at views down to the surface's own horizon.
        const Vec3 grazing = normalize(c.wo - c.geometric * (dot(c.wo, c.geometric) - 1e-6f * float(i % 100)));
        const Vec3 rounded = normalize(c.geometric * (1 + 1e-3f * float(i % 7)));
        for (const Vec3& wo : {c.wo, grazing})
            for (const KeepAbove what : {KeepAbove::View, KeepAbove::MirroredView}) {
                EXPECT_FALSE(bentNormal(c.geometric, c.geometric, wo, what));
                const auto n = bentNormal(rounded, c.geometric, wo, what);
                EXPECT_LT(length(n.value_or(rounded) - c.geometric), 1e-5f);
            }
    }
}

// Relief may lean past the geometric horizon.
TEST(BentNormal, NormalsOnTheWrongSideComeBack) {
    const Vec3 ng(0, 0, 1), shading = normalize(Vec3(-1, 0, -0.2f)), wo = normalize(Vec3(0.3f, 0, 1));
    for (const KeepAbove what : {KeepAbove::View, KeepAbove::MirroredView}) {
        const auto n = bentNormal(shading, ng, wo, what);
        ASSERT_TRUE(n);
        EXPECT_GT(n->z, 0);
        EXPECT_GT(dot(*n, wo), 0);
        EXPECT_EQ(bentNormal(shading, ng, -wo, what), *n) << "seen from the other side";
    }
}

}  // namespace
}  // namespace drc
