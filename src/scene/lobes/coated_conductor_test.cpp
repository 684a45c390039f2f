#include "scene/lobes/coated_conductor.h"

#include "scene/lobes/lobe_testing.h"
#include "scene/lobes/random_walk_testing.h"

namespace drc {
namespace {

using namespace test;

const Fresnel kCopper =
    Fresnel::conductor(Rgb(0.2004f, 0.924f, 1.102f) * (1 / 1.5f), Rgb(3.913f, 2.453f, 2.142f) * (1 / 1.5f));

TEST(CoatedConductor, Sampling) {
    checkSampling(CoatedConductor(DielectricCoat(1.5f, 0, 0.1f), 0, TrowbridgeReitz(0.3f, 0.1f), kCopper),
                  {0.9f, 0.3f, -0.5f});
    checkSampling(CoatedConductor(DielectricCoat(1.3f, 0.5f, 0), 0.5f, TrowbridgeReitz(0.1f, 0.1f), kCopper), {0.6f});
}

TEST(CoatedConductor, EnergyAndReciprocity) {
    for (const float eta : {1.f, 1.3f, 1.5f, 2.f})
        for (const float coatAlpha : {0.f, 0.3f, 1.f})
            for (const float alpha : {0.001f, 0.05f, 0.1f, 0.2f, 0.4f, 1.f}) {
                SCOPED_TRACE(std::to_string(eta) + " " + std::to_string(coatAlpha) + " " + std::to_string(alpha));
                const DielectricCoat coat(eta, coatAlpha, 0);
                const CoatedConductor lobe(coat, coatAlpha, TrowbridgeReitz(alpha, alpha), Fresnel::none());
                for (const float c : {0.05f, 0.3f, 0.6f, 0.95f})
                    EXPECT_LE(furnace(lobe, direction(c), 4000).x + coat.reflectance(c), 1.02f) << c;
                if (alpha >= 0.1f) checkReciprocity(lobe);
            }
}

TEST(CoatedConductor, WithoutACoatIsAMicrofacetReflection) {
    const TrowbridgeReitz distribution(0.3f, 0.2f);
    const CoatedConductor lobe(DielectricCoat(1, 0, 0), 0, distribution, kCopper);
    const MicrofacetReflection bare(Rgb(1.f), distribution, kCopper);
    std::mt19937 rng(3);
    for (int i = 0; i < 200; ++i) {
        const Vec3 wo = randomDirection(rng), wi = randomDirection(rng);
        if (!sameHemisphere(wo, wi)) continue;
        expectClose(lobe.f(wo, wi), bare.f(wo, wi), 1e-3f);
        EXPECT_NEAR(lobe.pdf(wo, wi), bare.pdf(wo, wi), 1e-3f * bare.pdf(wo, wi));
    }
}

// The errors stated in docs/layered-materials.md. Grey, so one channel is enough.
TEST(CoatedConductor, IsNearTheRandomWalk) {
    const Fresnel grey = Fresnel::conductor(Rgb(1.f), Rgb(3.f));
    for (const float coatAlpha : {0.f, 0.2f})
        for (const float alpha : {0.05f, 0.2f, 0.4f})
            for (const float c : {0.95f, 0.4f}) {
                const Vec3 wo = direction(c);
                const TrowbridgeReitz base(alpha, alpha), top(coatAlpha, coatAlpha);
                Bsdf face(Frame(), Vec3(0, 0, 1));
                double closed =
                    furnace(CoatedConductor(DielectricCoat(1.5f, coatAlpha, 0), coatAlpha, base, grey), wo).x;
                if (coatAlpha == 0) {
                    face.add(FresnelSpecular(Rgb(1.f), Rgb(1.f), 1, 1.5f));
                    closed += fresnelDielectric(c, 1, 1.5f);
                } else {
                    const MicrofacetReflection reflection(Rgb(1.f), top, Fresnel::dielectric(1, 1.5f));
                    face.add(reflection);
                    face.add(MicrofacetTransmission(Rgb(1.f), top, 1, 1.5f));
                    closed += furnace(reflection, wo).x;
                }
                const MicrofacetReflection metal(Rgb(1.f), base, grey);
                const double lossless = walkedAlbedo(face, metal, wo, 0, 0, 8000, Face::Lossless);
                EXPECT_NEAR(closed, lossless, coatAlpha == 0 ? 0.06 : 0.15) << coatAlpha << " " << alpha << " " << c;
            }
}

TEST(CoatedConductor, AlbedoEstimate) {
    for (const float alpha : {0.05f, 0.3f, 0.8f})
        checkAlbedo(CoatedConductor(DielectricCoat(1.5f, 0, 0), 0, TrowbridgeReitz(alpha, alpha), kCopper), 0.15f);
}

TEST(CoatedMirror, IsTheSeries) {
    const DielectricCoat coat(1.5f, 0, 0.1f);
    const CoatedMirror lobe(coat, kCopper);
    for (const float c : {0.9f, 0.2f, -0.6f}) {
        const float r = fresnelDielectric(std::abs(c), 1, 1.5f), inside = coat.cosineInside(std::abs(c));
        const Rgb base = kCopper.eval(inside) * std::exp(-0.2f / inside);
        for (int k = 0; k < 3; ++k) {
            double sum = r, bounce = sqr(1 - r) * base[k];
            for (int i = 0; i < 100; ++i, bounce *= r * base[k]) sum += bounce;
            EXPECT_NEAR(lobe.albedo(direction(c))[k], sum, 1e-4);
        }
        const LobeSample s = lobe.sample(direction(c), 0.5f, Vec2(0.5f, 0.5f), TransportMode::Radiance);
        EXPECT_EQ(s.wi, Vec3(-direction(c).x, -direction(c).y, c));
        expectClose(furnace(lobe, direction(c), 1), lobe.albedo(direction(c)), 1e-4f);
    }
}

}  // namespace
}  // namespace drc
