#include "scene/lights/light_reach.h"

#include <gtest/gtest.h>

#include <vector>

#include "math/frame.h"
#include "math/rng.h"
#include "math/warp.h"

namespace drc {
namespace {

LightReach cone(const Vec3& axis, float spread, float falloff, bool twoSided = false) {
    LightReach r;
    r.bounds.extend(Vec3(0, 0, 0));
    r.axis = normalize(axis);
    r.spread = spread;
    r.falloff = falloff;
    r.twoSided = twoSided;
    r.intensity = 1;
    return r;
}

// Whether directions d of emitted light are within the bounds.
bool holds(const LightReach& r, const Vec3& d) {
    const float cosine = r.twoSided ? absDot(r.axis, d) : dot(r.axis, d);
    return std::acos(std::clamp(cosine, -1.f, 1.f)) <= r.spread + r.falloff + 1e-3f;
}

TEST(LightReach, MergedHoldsBoth) {
    Pcg32 rng(1);
    for (int i = 0; i < 300; ++i) {
        LightReach a = cone(sampleUniformSphere(rng.nextVec2()), 2 * rng.nextFloat() * rng.nextFloat(), rng.nextFloat(),
                            rng.nextFloat() < 0.3f);
        LightReach b = cone(sampleUniformSphere(rng.nextVec2()), 2 * rng.nextFloat() * rng.nextFloat(), rng.nextFloat(),
                            rng.nextFloat() < 0.3f);
        b.bounds.extend(Vec3(1, 2, 3));
        const LightReach m = merged(a, b);
        EXPECT_EQ(m.intensity, 2);
        EXPECT_EQ(m.bounds.max, Vec3(1, 2, 3));
        for (int k = 0; k < 50; ++k) {
            const Vec3 d = sampleUniformSphere(rng.nextVec2());
            if (holds(a, d) || holds(b, d)) {
                EXPECT_TRUE(holds(m, d));
            }
        }
    }
}

TEST(LightReach, MergedIsNoWiderThanNeeded) {
    const LightReach m = merged(cone(Vec3(1, 0, 0), 0, kPi / 2), cone(Vec3(0, 1, 0), 0, kPi / 4));
    EXPECT_NEAR(m.spread, kPi / 4, 1e-3);
    EXPECT_EQ(m.falloff, kPi / 2);
    EXPECT_LT(length(m.axis - normalize(Vec3(1, 1, 0))), 1e-4f);
    // One cone inside the other.
    EXPECT_NEAR(merged(cone(Vec3(1, 0, 0), 1, 1), cone(Vec3(1, 0.1f, 0), 0.1f, 1)).spread, 1, 1e-6);
    // A two-sided panel may be turned over before merging; a one-sided one may not.
    EXPECT_LT(merged(cone(Vec3(0, 0, 1), 0, 1, true), cone(Vec3(0, 0, -1), 0, 1, true)).spread, 0.01f);
    EXPECT_LT(merged(cone(Vec3(0, 0, 1), 0, 1), cone(Vec3(0, 0, -1), 0, 1, true)).spread, 0.01f);
    EXPECT_EQ(merged(cone(Vec3(0, 0, 1), 0, 1), cone(Vec3(0, 0, -1), 0, 1)).spread, kPi);
}

TEST(LightReach, OrientationMeasureOfTheBook) {
    // For a flat emitter it is pi, the integral of the cosine over the hemisphere; for all directions 4 pi.
    EXPECT_NEAR(orientationMeasure(cone(Vec3(0, 0, 1), 0, kPi / 2)), kPi, 1e-4);
    EXPECT_NEAR(orientationMeasure(cone(Vec3(0, 0, 1), kPi, kPi / 2)), 4 * kPi, 1e-4);
    EXPECT_NEAR(orientationMeasure(cone(Vec3(0, 0, 1), 0, kPi / 2, true)), 2 * kPi, 1e-4);
}

TEST(LightBound, IrradianceOfPointsAndPanels) {
    const LightBound point(cone(Vec3(0, 0, 1), kPi, kPi / 2));
    EXPECT_NEAR(point.irradiance(Vec3(0, 0, -2)), 0.25f, 1e-6);
    EXPECT_TRUE(std::isfinite(point.irradiance(Vec3(0, 0, 0))));
    const LightBound panel(cone(Vec3(0, 0, 1), 0, kPi / 2));
    EXPECT_NEAR(panel.irradiance(Vec3(3, 0, 3)), std::sqrt(0.5f) / 18, 1e-5);
    EXPECT_EQ(panel.irradiance(Vec3(3, 0, -0.1f)), 0);
    EXPECT_GT(LightBound(cone(Vec3(0, 0, 1), 0, kPi / 2, true)).irradiance(Vec3(3, 0, -3)), 0);
}

// For any position of a part within the bounds and any axis within the spread, the estimate must not be zero if light
// arrives.
TEST(LightBound, NeverDeniesWhatArrives) {
    Pcg32 rng(2);
    for (int i = 0; i < 2000; ++i) {
        LightReach r = cone(sampleUniformSphere(rng.nextVec2()), kPi * rng.nextFloat() * rng.nextFloat(), kPi / 2,
                            rng.nextFloat() < 0.2f);
        r.bounds.extend(Vec3(1, 0.5f, 0.2f));
        const LightBound bound(r);
        const auto inBounds = [&] { return Vec3(rng.nextFloat(), 0.5f * rng.nextFloat(), 0.2f * rng.nextFloat()); };
        const Vec3 part = inBounds();
        const Frame frame = Frame::fromNormal(r.axis);
        const Vec3 normal = frame.toWorld(sampleUniformCone(rng.nextVec2(), std::cos(r.spread)));
        const Vec3 p = part + sampleUniformSphere(rng.nextVec2()) * (3 * rng.nextFloat());
        const float cosine = dot(normal, normalize(p - part));
        if (cosine > 0 || r.twoSided) {
            EXPECT_GT(bound.irradiance(p), 0);
        }
    }
}

TEST(LightBounds, AreEachWhatItIsAlone) {
    Pcg32 rng(3);
    for (int round = 0; round < 50; ++round) {
        std::vector<LightBound> alone;
        LightBounds together;
        for (int i = 0; i < 5; ++i) {
            LightReach r = cone(sampleUniformSphere(rng.nextVec2()), kPi * rng.nextFloat(), kPi / 2, i % 2 == 0);
            r.bounds.extend(sampleUniformSphere(rng.nextVec2()));
            r.intensity = 0.5f + rng.nextFloat();
            together.set(i, alone.emplace_back(r));
        }
        for (int k = 0; k < 20; ++k) {
            const Vec3 p = sampleUniformSphere(rng.nextVec2()) * (4 * rng.nextFloat());
            float values[LightBounds::kCount];
            together.irradiance(p, values);
            for (int i = 0; i < 5; ++i) {
                const float expected = alone[size_t(i)].irradiance(p);
                EXPECT_NEAR(values[i], expected, 1e-3f * expected);
            }
            for (int i = 5; i < LightBounds::kCount; ++i) EXPECT_EQ(values[i], 0);
        }
    }
}

}  // namespace
}  // namespace drc
