#include "scene/lobes/half_space_albedo.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "scene/lobes/fresnel.h"
#include "scene/lobes/half_space_testing.h"

namespace drc {
namespace {

using namespace test;

// Van de Hulst's fit of the albedo under diffuse light, without a boundary, is within .003.
TEST(HalfSpaceAlbedo, WithoutABoundaryIsThatOfTheBooks) {
    for (const float g : {0.f, 0.5f, 0.8f}) {
        const HalfSpaceAlbedo share(g, 1);
        for (float albedo = 0; albedo <= 1; albedo += 0.05f) {
            const float s = std::sqrt((1 - albedo) / (1 - g * albedo));
            EXPECT_NEAR(share(albedo), (1 - s) * (1 - 0.139f * s) / (1 + 1.17f * s), 0.003f) << g << " " << albedo;
        }
    }
    // Chandrasekhar, "Radiative Transfer", 1950: 1 - 2 sqrt(1 - albedo) times the first moment of H, which is 1.1542
    // for a medium that absorbs nothing; in the limit of that.
    const HalfSpaceAlbedo share(0, 1);
    EXPECT_NEAR((1 - share(0.9996f)) / 0.02f, 2 * 1.1547f, 0.08f);
}

// Within one per cent, of the share itself, of random walks.
TEST(HalfSpaceAlbedo, IsTheRandomWalk) {
    for (const float g : {0.f, 0.8f, -0.4f})
        for (const float eta : {1.f, 1.33f, 1.8f}) {
            const HalfSpaceAlbedo share(g, eta);
            const auto walked = walkedShares(g, eta, std::nullopt, 40000);
            for (size_t k = 0; k < kWalkedAlbedos.size(); ++k)
                EXPECT_NEAR(share(kWalkedAlbedos[k]), walked[k].mean, 0.01f * walked[k].mean + 4 * walked[k].error)
                    << "g " << g << ", eta " << eta << ", albedo " << kWalkedAlbedos[k];
        }
}

TEST(HalfSpaceAlbedo, Limits) {
    for (const float g : {-0.99f, 0.f, 0.95f, 0.99f})
        for (const float eta : {1.f, 1.5f, 3.f}) {
            const HalfSpaceAlbedo share(g, eta);
            EXPECT_EQ(share(1), 1);
            EXPECT_NEAR(share(0), 0, 1e-6f);
            float before = 0;
            for (float albedo = 0; albedo < 1; albedo += 0.01f) {
                EXPECT_GE(share(albedo), before - 1e-4f);
                before = share(albedo);
            }
        }
}

}  // namespace
}  // namespace drc
