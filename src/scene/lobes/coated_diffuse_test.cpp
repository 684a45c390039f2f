#include "scene/lobes/coated_diffuse.h"

#include "scene/lobes/lobe_testing.h"
#include "scene/lobes/random_walk_testing.h"

namespace drc {
namespace {

using namespace test;

TEST(CoatedDiffuse, Sampling) {
    checkSampling(CoatedDiffuse(Rgb(0.8f), DielectricCoat(1.5f, 0.2f, 0.1f)), {0.7f, -0.3f});
}

TEST(CoatedDiffuse, IsSeparable) {
    checkSeparable(CoatedDiffuse(Rgb(0.8f, 0.2f, 0.5f), DielectricCoat(1.5f, 0.3f, 0.2f)));
}

TEST(CoatedDiffuse, EnergyReciprocityAndAlbedo) {
    for (const float eta : {1.f, 1.5f, 2.f})
        for (const float alpha : {0.f, 0.1f, 0.5f, 1.f}) {
            const DielectricCoat coat(eta, alpha, 0);
            const CoatedDiffuse lobe(Rgb(1.f, 0.5f, 0.1f), coat);
            checkReciprocity(lobe);
            for (const float c : {0.1f, 0.5f, 1.f, -0.7f}) {
                const Rgb total = furnace(lobe, direction(c), 10000);
                expectClose(total, lobe.albedo(direction(c)), 0.02f);
                // A white base returns all light that the coat transmits.
                EXPECT_NEAR(lobe.albedo(direction(c)).x, coat.transmittance(std::abs(c)), 3e-4f);
            }
        }
}

Bsdf face(float eta, float alpha) {
    Bsdf bsdf(Frame(), Vec3(0, 0, 1));
    if (alpha == 0) {
        bsdf.add(FresnelSpecular(Rgb(1.f), Rgb(1.f), 1, eta));
    } else {
        bsdf.add(MicrofacetReflection(Rgb(1.f), TrowbridgeReitz(alpha, alpha), Fresnel::dielectric(1, eta)));
        bsdf.add(MicrofacetTransmission(Rgb(1.f), TrowbridgeReitz(alpha, alpha), 1, eta));
    }
    return bsdf;
}

// Albedo of coat and base together; the reflection off a rough interface is estimated by sampling.
double closedAlbedo(float reflectance, float eta, float alpha, float depth, const Vec3& wo) {
    const double base = CoatedDiffuse(Rgb(reflectance), DielectricCoat(eta, alpha, depth)).albedo(wo).x;
    if (alpha == 0) return base + fresnelDielectric(wo.z, 1, eta);
    return base +
           furnace(MicrofacetReflection(Rgb(1.f), TrowbridgeReitz(alpha, alpha), Fresnel::coat(eta)), wo, 20000).x;
}

TEST(CoatedDiffuse, SmoothIsTheRandomWalk) {
    for (const float reflectance : {0.2f, 0.8f})
        for (const float depth : {0.f, 0.2f})
            for (const float c : {0.95f, 0.3f}) {
                const Vec3 wo = direction(c);
                const double walked =
                    walkedAlbedo(face(1.5f, 0), LambertReflection(Rgb(reflectance)), wo, depth, 0, 40000);
                EXPECT_NEAR(closedAlbedo(reflectance, 1.5f, 0, depth, wo), walked, 0.01) << reflectance << " " << depth;
            }
}

// The errors stated in docs/layered-materials.md against a lossless walk. The result must not be below that of a walk
// that loses energy at the interface.
TEST(CoatedDiffuse, RoughIsNearTheRandomWalk) {
    for (const float alpha : {0.1f, 0.3f, 0.6f})
        for (const float reflectance : {0.2f, 0.8f})
            for (const float c : {0.95f, 0.3f}) {
                const Vec3 wo = direction(c);
                const LambertReflection base{Rgb(reflectance)};
                const double closed = closedAlbedo(reflectance, 1.5f, alpha, 0, wo);
                const double lossy = walkedAlbedo(face(1.5f, alpha), base, wo, 0, 0, 10000);
                const double lossless = walkedAlbedo(face(1.5f, alpha), base, wo, 0, 0, 10000, Face::Lossless);
                EXPECT_NEAR(closed, lossless, 0.07) << alpha << " " << reflectance << " " << c;
                EXPECT_GT(closed, lossy - 0.03) << alpha << " " << reflectance << " " << c;
            }
}

}  // namespace
}  // namespace drc
