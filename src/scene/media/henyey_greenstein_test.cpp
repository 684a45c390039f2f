#include "scene/media/henyey_greenstein.h"

#include <gtest/gtest.h>

#include "scene/chi_square.h"

namespace drc {
namespace {

constexpr float kCosines[] = {-0.9f, -0.3f, -1e-4f, 0, 1e-4f, 0.5f, 0.95f};
const Vec3 kOutgoing = normalize(Vec3(0.3f, -0.5f, 0.8f));

TEST(HenyeyGreenstein, SamplesFollowTheirDensity) {
    for (const float g : kCosines) {
        const auto sample = [&](std::mt19937& rng) -> std::optional<Vec3> {
            std::uniform_real_distribution<float> u(0, 1);
            const float x = u(rng);
            return sampleHenyeyGreenstein(g, kOutgoing, {x, u(rng)});
        };
        const auto pdf = [&](const Vec3& wi) { return phaseHenyeyGreenstein(g, kOutgoing, wi); };
        const test::ChiSquare result = test::chiSquareTest(sample, pdf, 200'000, 7);
        EXPECT_NEAR(result.pdfIntegral, 1, 1e-4) << g;
        EXPECT_GT(result.pValue, test::kChiSquareLevel) << g;
    }
}

// g is the mean cosine of the angle between a direction and the one in which light goes on.
TEST(HenyeyGreenstein, HasItsMeanCosine) {
    for (const float g : kCosines) {
        const auto deflection = [&](const Vec3& wi) {
            return -dot(wi, kOutgoing) * phaseHenyeyGreenstein(g, kOutgoing, wi);
        };
        EXPECT_NEAR(test::integrateSphere(deflection), g, 2e-4);
    }
}

TEST(HenyeyGreenstein, IsFiniteWhereItIsNarrow) {
    for (const float g : {-0.99999f, 0.99999f}) {
        for (const float u : {0.f, 0.5f, 0x1.fffffep-1f}) {
            const Vec3 wi = sampleHenyeyGreenstein(g, kOutgoing, {u, 0.25f});
            EXPECT_NEAR(length(wi), 1, 1e-5f);
            const float phase = phaseHenyeyGreenstein(g, kOutgoing, wi);
            EXPECT_TRUE(std::isfinite(phase) && phase > 0) << g << " " << u;
        }
    }
    // Straight on: (1 + g) / (4 pi (1 - g)^2).
    EXPECT_NEAR(phaseHenyeyGreenstein(0.9f, kOutgoing, -kOutgoing) * 4 * kPi, 190, 0.1);
}

}  // namespace
}  // namespace drc
