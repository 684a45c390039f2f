#include "scene/lobes/microfacet.h"

#include <gtest/gtest.h>

#include "scene/lobes/lobe_testing.h"

namespace drc {
namespace {

using namespace test;

TEST(TrowbridgeReitz, RoughnessToAlpha) {
    EXPECT_NEAR(roughnessToAlpha(1), 1.62142f, 1e-6f);
    // x = ln 0.1 = -2.302585: 1.62142 - 1.888016 + 0.919349 - 0.209004 + 0.018010
    EXPECT_NEAR(roughnessToAlpha(0.1f), 0.461759f, 2e-6f);
    EXPECT_NEAR(roughnessToAlpha(0), roughnessToAlpha(1e-3f), 1e-6f);
}

TEST(TrowbridgeReitz, HandComputed) {
    const TrowbridgeReitz d(0.5f, 0.5f);
    EXPECT_NEAR(d.d(Vec3(0, 0, 1)), 1 / (kPi * 0.25f), 1e-5f);
    // tan = 1: lambda = (sqrt(1 + 0.25) - 1) / 2 = 0.0590170, and g1 = 1 / (1 + lambda)
    EXPECT_NEAR(d.g1OverCosine(direction(std::sqrt(0.5f))), 1 / 1.0590170f / std::sqrt(0.5f), 1e-6f);
    // At the horizon g1 goes to zero like the cosine: lambda = (sqrt(1 + 0.25 tan^2) - 1) / 2, about tan / 4.
    EXPECT_NEAR(d.g1OverCosine(Vec3(1, 0, 0)), 4, 1e-5f);
}

TEST(TrowbridgeReitz, Masking) {
    // lambda = 0.0590170 at 45 degrees, as above.
    const Vec3 w = direction(std::sqrt(0.5f));
    // g over 4 cos^2
    EXPECT_NEAR(TrowbridgeReitz(0.5f, 0.5f).visibility(w, w), 1 / 1.118034f / 2, 1e-6f);
    const TrowbridgeReitz separable(0.5f, 0.5f, TrowbridgeReitz::Masking::Separable);
    EXPECT_NEAR(separable.visibility(w, w), 1 / sqr(1.0590170f) / 2, 1e-6f);
}

TEST(TrowbridgeReitz, Widened) {
    const TrowbridgeReitz wide = TrowbridgeReitz(0.3f, 0.6f).widened(0.4f);
    EXPECT_NEAR(wide.meanAlpha(), std::sqrt(0.5f * std::sqrt(0.52f)), 1e-6f);
    EXPECT_NEAR(wide.d(Vec3(0, 0, 1)), 1 / (kPi * 0.5f * std::sqrt(0.52f)), 1e-5f);
}

TEST(TrowbridgeReitz, ProjectedAreaIsOne) {
    for (const auto& [ax, ay] : {std::pair(0.1f, 0.1f), std::pair(0.6f, 0.2f), std::pair(1.f, 1.f)}) {
        const TrowbridgeReitz d(ax, ay);
        EXPECT_NEAR(integrateSphere([&](const Vec3& w) { return std::max(0.f, w.z) * d.d(w); }), 1, 1e-3);
    }
}

TEST(TrowbridgeReitz, VisibleNormals) {
    for (const auto& [ax, ay] : {std::pair(0.15f, 0.15f), std::pair(0.6f, 0.2f), std::pair(1.f, 1.f)})
        for (const float c : {0.999f, 0.5f, 0.1f, -0.4f}) {
            const TrowbridgeReitz d(ax, ay);
            const Vec3 wo = direction(c);
            const auto pdf = [&](const Vec3& wh) { return wh.z * wo.z > 0 && dot(wo, wh) > 0 ? d.pdf(wo, wh) : 0.f; };
            const auto sample = [&](std::mt19937& rng) { return std::optional(d.sample(wo, uniform2(rng))); };
            const ChiSquare r = chiSquareTest(sample, pdf, 60000, 5);
            EXPECT_NEAR(r.pdfIntegral, 1, 1e-3);
            EXPECT_GT(r.pValue, kChiSquareLevel) << ax << " " << ay << " " << c;
        }
}

}  // namespace
}  // namespace drc
