#include "scene/lights/portal.h"

#include <gmock/gmock.h>

#include "math/rng.h"
#include "math/transform.h"
#include "math/warp.h"

namespace drc {
namespace {

using testing::HasSubstr;

// 3 by 2, turned; outward is the image of +y.
std::array<Vec3, 4> window() {
    const Transform t = Transform::translate(Vec3(1, 2, 3)) * Transform::rotate(40, Vec3(1, 2, 0));
    return {t.point(Vec3(0, 0, 0)), t.point(Vec3(3, 0, 0)), t.point(Vec3(3, 0, 2)), t.point(Vec3(0, 0, 2))};
}

TEST(Portal, RectanglesInOrder) {
    EXPECT_EQ(Portal::flawOf(window()), "");
    const Portal portal(window());
    EXPECT_NEAR(portal.area(), 6, 1e-5f);
    for (size_t i = 0; i < 4; ++i) EXPECT_LT(length(portal.corners()[i] - window()[i]), 1e-5f);
    const Vec3 outward = Transform::rotate(40, Vec3(1, 2, 0)).vector(Vec3(0, 1, 0));
    EXPECT_LT(length(portal.outward() - outward), 1e-5f);
}

TEST(Portal, SaysWhatIsWrong) {
    const Vec3 a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0);
    EXPECT_EQ(Portal::flawOf({a, b, c, d}), "");
    EXPECT_THAT(Portal::flawOf({a, a, c, d}), HasSubstr("corners 1 and 2 are at the same place"));
    EXPECT_THAT(Portal::flawOf({a, c, b, d}), HasSubstr("the angle at corner 1 is 45 degrees, not 90"));
    EXPECT_THAT(Portal::flawOf({a, b, Vec3(1.5f, 1, 0), d}), HasSubstr("the angle at corner 2 is 116.6 degrees"));
    EXPECT_THAT(Portal::flawOf({a, b, Vec3(1, 1, 0.5f), d}), HasSubstr("the angle at corner 3"));
    EXPECT_THAT(Portal::flawOf({a, b, Vec3(2, 1, 0), Vec3(1, 1, 0)}), HasSubstr("not 90")) << "a parallelogram";
    EXPECT_THAT(Portal::flawOf({Vec3(NAN), b, c, d}), HasSubstr("the same place"));
}

TEST(Portal, RectifiedCoordinatesCoverTheHemisphere) {
    const Portal portal(window());
    Pcg32 rng(2);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 w = sampleUniformSphere(rng.nextVec2());
        const auto at = portal.rectifiedOf(w);
        EXPECT_EQ(bool(at), dot(w, portal.outward()) > 0);
        if (!at || at->cosine < 0.01f) continue;
        const Portal::Direction back = portal.directionOf(at->at);
        EXPECT_LT(length(back.w - w), 1e-4f);
        EXPECT_NEAR(back.solidAngle, at->solidAngle, 1e-2f * at->solidAngle);
        EXPECT_NEAR(at->cosine, dot(w, portal.outward()), 1e-5f);
    }
    // Integrals of 1 and of the cosine over the hemisphere.
    constexpr int kSide = 600;
    double all = 0, cosine = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
        const auto d = portal.directionOf(Vec2((float(i % kSide) + 0.5f) / kSide, (float(i / kSide) + 0.5f) / kSide));
        all += double(d.solidAngle) / (kSide * kSide);
        cosine += double(d.solidAngle * d.cosine) / (kSide * kSide);
    }
    EXPECT_NEAR(all, 2 * std::numbers::pi, 0.01);
    EXPECT_NEAR(cosine, std::numbers::pi, 1e-3);
    // At the edges of the square too, there is a direction.
    for (const float u : {0.f, 1.f, 0.5f}) {
        EXPECT_TRUE(std::isfinite(portal.directionOf(Vec2(u, 0)).solidAngle));
        EXPECT_NEAR(length(portal.directionOf(Vec2(u, 1)).w), 1, 1e-4f);
    }
}

// A direction is within what a point sees exactly if a ray along it passes the portal.
TEST(Portal, WindowsHoldWhatPasses) {
    const Portal portal(window());
    const Vec3 centre = portal.pointAt(Vec2(0.5f, 0.5f));
    Pcg32 rng(3);
    int passed = 0, edges = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 p = centre + sampleUniformSphere(rng.nextVec2()) * (4 * rng.nextFloat());
        const Vec3 w = normalize(portal.pointAt(rng.nextVec2() * 2.f - Vec2(0.5f)) - p);
        const auto seen = portal.windowFrom(p);
        const auto at = portal.rectifiedOf(w);
        EXPECT_EQ(bool(seen), dot(p - centre, portal.outward()) < 0);
        const bool inWindow = seen && at && seen->contains(at->at);
        edges += inWindow != portal.isPassed(p, w);
        passed += inWindow;
    }
    EXPECT_GT(passed, 1500);
    EXPECT_LE(edges, 5);
}

}  // namespace
}  // namespace drc
