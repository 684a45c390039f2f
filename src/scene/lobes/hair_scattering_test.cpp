#include "scene/lobes/hair_scattering.h"

#include "scene/lobes/fresnel.h"
#include "scene/lobes/lobe_testing.h"

namespace drc {
namespace {

using namespace test;

HairScattering hair(float h, float absorption, float betaM, float betaN, float alpha = 2) {
    return HairScattering(h, Rgb(absorption), {.eta = 1.55f, .betaM = betaM, .betaN = betaN, .alphaDegrees = alpha});
}

TEST(HairScattering, Sampling) {
    checkSampling(hair(0.3f, 0.5f, 0.3f, 0.3f), {0.9f, 0.1f, -0.5f});
    checkSampling(hair(-0.8f, 0, 0.6f, 0.5f), {0.6f});
    checkSampling(hair(0.f, 2, 1, 1, 8), {0.6f});
    checkSampling(hair(0.95f, 0.1f, 0.2f, 0.9f, 0), {0.2f});
}

TEST(HairScattering, DensityIntegratesToOne) {
    for (const float beta : {0.15f, 0.5f, 1.f})
        for (const float h : {-0.9f, 0.f, 0.5f}) {
            const HairScattering lobe = hair(h, 0.3f, beta, beta);
            const Vec3 wo = direction(0.6f);
            EXPECT_NEAR(integrateSphere([&](const Vec3& wi) { return lobe.pdf(wo, wi); }, 1e-5), 1, 4e-3)
                << beta << " " << h;
        }
}

TEST(HairScattering, NothingIsLostWithoutAbsorption) {
    for (const float beta : {0.05f, 0.3f, 1.f})
        for (const float h : {-0.99f, -0.4f, 0.f, 0.7f})
            for (const float c : {0.95f, 0.3f, -0.5f}) {
                const HairScattering lobe = hair(h, 0, beta, beta);
                expectClose(furnace(lobe, direction(c), 3000), Rgb(1.f), 1e-3f);
                expectClose(lobe.albedo(direction(c)), Rgb(1.f), 1e-4f);
            }
}

TEST(HairScattering, AlbedoIsExact) {
    const HairScattering lobe(0.4f, Rgb(0.1f, 0.5f, 3.f), {});
    checkAlbedo(lobe, 5e-3f);
    // As sigma_a grows, the surface's reflection alone is left.
    const Vec3 wo = direction(1);
    const float expected = fresnelDielectric(1, 1, 1.55f);
    EXPECT_NEAR(hair(0, 1000, 0.3f, 0.3f).albedo(wo).x, expected, 1e-5f);
    // Through the middle of the fibre the way is two radii long: 1 - R enters, exp(-2 sigma) arrives, and so on.
    const float r = expected, t = std::exp(-2 * 0.7f);
    EXPECT_NEAR(hair(0, 0.7f, 0.3f, 0.3f).albedo(wo).x, r + sqr(1 - r) * t / (1 - r * t), 1e-5f);
}

TEST(HairScattering, LobesLieWhereTheCylinderSendsThem) {
    // Smooth, without scales, met in the middle: R goes back, mirrored along the fibre; TT straight through.
    const HairScattering lobe = hair(0, 0, 0.05f, 0.05f, 0);
    const Vec3 wo(0.5f, 0, std::sqrt(0.75f));
    const Vec3 back(-0.5f, 0, wo.z), through(-0.5f, 0, -wo.z), aside(-0.5f, wo.z, 0.001f);
    EXPECT_GT(lobe.pdf(wo, through), 20 * lobe.pdf(wo, back));
    EXPECT_GT(lobe.pdf(wo, back), 20 * lobe.pdf(wo, aside));
    // Scales of 5 degrees turn the reflection by 10 degrees towards the root.
    const HairScattering leaning = hair(0, 1000, 0.05f, 0.05f, 5);
    const auto reflected = [&](float degrees) {
        const float theta = degrees * kPi / 180;
        return leaning.pdf(wo, Vec3(std::sin(theta), 0, std::cos(theta)));
    };
    EXPECT_GT(reflected(-20), 10 * reflected(-30));
    EXPECT_GT(reflected(-20), 10 * reflected(-10));
}

TEST(HairScattering, DensityOfOneDirectionByHand) {
    // h = 0, wo = (0, 0, 1), black inside: R alone, with variance v and scale s; along the mirror direction itself
    //   exp(-1/v) I0(1/v) / (2 v sinh(1/v))  times  1 / (4 s)  (the cut of the logistic is beyond rounding).
    const float m = 0.6f, n = 0.3f;
    const double root = 0.726 * m + 0.812 * m * m + 3.7 * std::pow(m, 20), v = root * root;
    const double s = std::sqrt(std::numbers::pi / 8) * (0.265 * n + 1.194 * n * n + 5.372 * std::pow(n, 22));
    double bessel = 0, term = 1;
    for (int k = 1; k < 60; ++k) {
        bessel += term;
        term *= 0.25 / (v * v) / (double(k) * k);
    }
    const double expected = bessel / (2 * v * std::sinh(1 / v)) / (4 * s);
    const Vec3 w(0, 0, 1);
    EXPECT_NEAR(hair(0, 1000, m, n, 0).pdf(w, w), expected, 1e-4 * expected);
}

TEST(HairScattering, NothingIsScatteredByWhatTakesEverything) {
    const HairScattering lobe(0.2f, Rgb(1000.f), {.eta = 1});
    const Vec3 wo = direction(0.6f), wi = direction(0.3f);
    EXPECT_EQ(lobe.pdf(wo, wi), 0);
    EXPECT_EQ(lobe.f(wo, wi), Rgb(0.f));
    EXPECT_EQ(lobe.sample(wo, 0.5f, Vec2(0.5f, 0.5f), TransportMode::Radiance).pdf, 0);
}

TEST(HairScattering, IsNeverBroad) {
    for (const float beta : {0.f, 0.3f, 1.f}) {
        const HairScattering lobe = hair(0.2f, 0.5f, beta, beta);
        EXPECT_FALSE(broadLobes(1e-3f).has(lobe.flags(), lobe.alpha()));
        EXPECT_TRUE(glossyLobes(1e-3f).has(lobe.flags(), lobe.alpha()));
    }
}

TEST(HairScattering, ExtremesStayFinite) {
    for (const float h : {-1.f, 0.f, 1.f})
        for (const float beta : {0.f, 1.f})
            for (const Vec3& wo : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, -1), direction(0.01f)})
                for (const float u : {0.f, 0.5f, kOneMinusEpsilon}) {
                    const HairScattering lobe = hair(h, 0.5f, beta, beta);
                    const LobeSample s = lobe.sample(wo, u, Vec2(u, u), TransportMode::Radiance);
                    EXPECT_TRUE(s.pdf >= 0 && std::isfinite(s.pdf) && isFinite(s.f)) << h << " " << beta << " " << u;
                }
}

}  // namespace
}  // namespace drc
