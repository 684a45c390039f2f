#include "scene/lobes/microfacet_albedo.h"

#include "scene/lobes/layered_lobe.h"
#include "scene/lobes/lobe_testing.h"
#include "scene/lobes/microfacet_dielectric.h"
#include "scene/lobes/microfacet_reflection.h"

namespace drc {
namespace {

using namespace test;

LayeredLobe<MicrofacetReflection> reflection(float alphaX, float alphaY, const Fresnel& fresnel, const Rgb& mean) {
    const TrowbridgeReitz distribution(alphaX, alphaY);
    return {MicrofacetReflection(Rgb(1.f), distribution, fresnel), LayersAbove(),
            MultipleScattering::ofReflection(distribution.meanAlpha(), mean)};
}

TEST(MultipleScattering, LosslessFacetsReflectEverything) {
    for (const float alpha : {0.01f, 0.1f, 0.35f, 0.7f, 1.f})
        for (const float c : {0.05f, 0.2f, 0.5f, 0.8f, 0.99f, -0.5f}) {
            const float all = furnace(reflection(alpha, alpha, Fresnel::none(), Rgb(1.f)), direction(c), 100000).x;
            EXPECT_NEAR(all, 1, 0.01f) << alpha << " " << c;
        }
    // Single scattering loses a third of it.
    EXPECT_LT(singleScatteringAlbedo(1, 0.5f), 0.7f);
    EXPECT_NEAR(singleScatteringAlbedo(0, 0.5f), 1, 1e-6f);
}

TEST(MultipleScattering, AnisotropicFacetsLoseLess) {
    // The tables are those of isotropic facets with the same product of both axes: they give back a part of what is
    // lost, and near the horizon at most 2 % more.
    for (const float c : {0.1f, 0.3f, 0.6f, 0.9f})
        for (const float phi : {0.f, 0.8f, 1.57f}) {
            const TrowbridgeReitz brushed(0.8f, 0.08f);
            const MicrofacetReflection once(Rgb(1.f), brushed, Fresnel::none());
            const float all = furnace(reflection(0.8f, 0.08f, Fresnel::none(), Rgb(1.f)), direction(c, phi)).x;
            EXPECT_LE(all, 1.02f) << c << " " << phi;
            EXPECT_GE(all, furnace(once, direction(c, phi)).x) << c << " " << phi;
        }
}

TEST(MultipleScattering, LightPathsAreAdjointToCameraPaths) {
    const Fresnel dielectric = Fresnel::tinted(Rgb(0.04f, 0.02f, 0.01f), 1.5f, Fresnel::Of::Coat);
    const auto lobe = reflection(0.6f, 0.3f, dielectric, meanDielectricFresnel(1.5f, Rgb(0.04f)));
    std::mt19937 rng(1);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 wo = randomDirection(rng), wi = randomDirection(rng);
        expectClose(lobe.f(wo, wi), lobe.f(wi, wo, TransportMode::Importance), 1e-3f, "adjoint");
    }
    checkSampling(lobe);
}

TEST(MultipleScattering, AbsorbingFacetsDarkenAndSaturate) {
    // By the geometric series: one bounce of single scattering keeps E, and each further one F times what is left.
    const float alpha = 0.8f, f = 0.5f;
    const auto grey = reflection(alpha, alpha, Fresnel::none(), Rgb(f));
    float mean = 0;
    constexpr int kSteps = 40;
    for (int i = 0; i < kSteps; ++i) {
        const float c = (float(i) + 0.5f) / kSteps;
        mean += 2 * c * singleScatteringAlbedo(alpha, c) / kSteps;
    }
    const float again = f * mean / (1 - f * (1 - mean));
    const float c = 0.7f, single = singleScatteringAlbedo(alpha, c);
    EXPECT_NEAR(furnace(grey, direction(c), 100000).x, single + again * (1 - single), 0.005f);
}

TEST(MultipleScattering, GlassLosesNothing) {
    for (const float eta : {1.1f, 1.5f, 2.4f, 1 / 1.5f})
        for (const float alpha : {0.05f, 0.3f, 0.8f}) {
            const TrowbridgeReitz distribution(alpha, alpha);
            const LayeredLobe glass(MicrofacetDielectric(Rgb(1.f), Rgb(1.f), distribution, eta), LayersAbove(),
                                    MultipleScattering::ofBoundary(alpha, eta, Rgb(1.f)));
            for (const float c : {0.1f, 0.4f, 0.9f, -0.1f, -0.4f, -0.9f})
                EXPECT_NEAR(furnace(glass, direction(c), 40000).x, 1, 0.02f) << eta << " " << alpha << " " << c;
        }
}

TEST(DielectricAlbedo, IsThatOfTheLobe) {
    for (const float eta : {1.05f, 1.5f, 2.2f})
        for (const float alpha : {0.03f, 0.25f, 1.f})
            for (const float tint : {1.f, 0.3f}) {
                const float atNormal = sqr((eta - 1) / (eta + 1)) * tint;
                const auto lobe = reflection(alpha, alpha, Fresnel::tinted(Rgb(atNormal), eta, Fresnel::Of::Coat),
                                             meanDielectricFresnel(eta, Rgb(atNormal)));
                const CosineCurve curve = dielectricAlbedo(alpha, eta, atNormal);
                for (const float c : {0.05f, 0.3f, 0.9f})
                    EXPECT_NEAR(curve.at(c), furnace(lobe, direction(c), 40000).x, 0.006f)
                        << eta << " " << alpha << " " << c;
            }
}

TEST(DielectricAlbedo, OfASmoothSurfaceIsFresnels) {
    const CosineCurve curve = dielectricAlbedo(0, 1.5f, 0.04f);
    for (const float c : {0.02f, 0.1f, 0.35f, 0.8f, 1.f})
        EXPECT_NEAR(curve.at(c), fresnelDielectric(c, 1, 1.5f), 0.003f);
    EXPECT_NEAR(meanDielectricFresnel(1.5f, Rgb(0.04f)).x, 0.0918f, 3e-4f);  // of eta 1.5, by quadrature
    EXPECT_NEAR(curve.mean(), 0.0918f, 3e-4f);
}

}  // namespace
}  // namespace drc
