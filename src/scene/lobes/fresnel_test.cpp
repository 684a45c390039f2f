#include "scene/lobes/fresnel.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

TEST(Fresnel, DielectricAtNormalIncidence) {
    // ((1.5 - 1) / (1.5 + 1))^2, from either side.
    EXPECT_NEAR(fresnelDielectric(1, 1, 1.5f), 0.04f, 1e-7f);
    EXPECT_NEAR(fresnelDielectric(-1, 1, 1.5f), 0.04f, 1e-7f);
}

TEST(Fresnel, DielectricAtSixtyDegrees) {
    // cos t = sqrt(1 - 0.75 / 2.25) = 0.8164966; parallel = (0.75 - 0.8164966) / (0.75 + 0.8164966) = -0.0424493;
    // perpendicular = (0.5 - 1.2247449) / (0.5 + 1.2247449) = -0.4202041; mean of squares 0.0891867.
    EXPECT_NEAR(fresnelDielectric(0.5f, 1, 1.5f), 0.0891867f, 1e-6f);
    // The same boundary from within, along the refracted direction.
    EXPECT_NEAR(fresnelDielectric(-0.81649658f, 1, 1.5f), 0.0891867f, 1e-6f);
}

TEST(Fresnel, DielectricAtBrewstersAngle) {
    // tan theta = 1.5: only the perpendicular part, ((2.25 - 1) / (2.25 + 1))^2 = 0.1479290.
    EXPECT_NEAR(fresnelDielectric(1 / std::sqrt(3.25f), 1, 1.5f), 0.5f * 0.1479290f, 1e-6f);
}

TEST(Fresnel, DielectricLimits) {
    EXPECT_EQ(fresnelDielectric(-0.5f, 1, 1.5f), 1);  // beyond the critical angle, 41.8 degrees
    EXPECT_LT(fresnelDielectric(-0.7465f, 1, 1.5f), 1);
    EXPECT_NEAR(fresnelDielectric(0, 1, 1.5f), 1, 1e-6f);
    for (const float c : {1.f, 0.4f, 0.05f, -0.3f}) EXPECT_NEAR(fresnelDielectric(c, 1.3f, 1.3f), 0, 1e-6f);
}

TEST(Fresnel, ConductorAtNormalIncidence) {
    // ((eta - 1)^2 + k^2) / ((eta + 1)^2 + k^2).
    const Rgb eta(0.2f, 0.924f, 1.102f), k(3.912f, 2.452f, 2.142f);
    const Rgb f = fresnelConductor(1, eta, k);
    EXPECT_NEAR(f.x, (0.64 + 15.303744) / (1.44 + 15.303744), 1e-5);
    EXPECT_NEAR(f.y, (0.005776 + 6.012304) / (3.701776 + 6.012304), 1e-5);
    EXPECT_NEAR(f.z, (0.010404 + 4.588164) / (4.418404 + 4.588164), 1e-5);
    EXPECT_EQ(fresnelConductor(-0.3f, eta, k), fresnelConductor(0.3f, eta, k));
    EXPECT_NEAR(fresnelConductor(0, eta, k).x, 1, 1e-6f);
}

TEST(Fresnel, ConductorWithoutAbsorptionIsADielectric) {
    for (const float c : {1.f, 0.7f, 0.5f, 0.1f, 0.01f})
        EXPECT_NEAR(fresnelConductor(c, Rgb(1.5f), Rgb(0.f)).x, fresnelDielectric(c, 1, 1.5f), 2e-6f) << c;
    EXPECT_TRUE(isFinite(fresnelConductor(0, Rgb(1.f), Rgb(0.f))));
}

TEST(Fresnel, Schlick) {
    EXPECT_EQ(fresnelSchlick(1, Rgb(0.04f)), Rgb(0.04f));
    EXPECT_NEAR(fresnelSchlick(0.5f, Rgb(0.04f)).x, 0.04f + 0.96f / 32, 1e-7f);
}

TEST(Fresnel, Kinds) {
    EXPECT_EQ(Fresnel::none().eval(0.3f), Rgb(1.f));
    EXPECT_EQ(Fresnel::dielectric(1, 1.5f).eval(0.3f).y, fresnelDielectric(0.3f, 1, 1.5f));
    EXPECT_EQ(Fresnel::conductor(Rgb(0.2f), Rgb(3.f)).eval(0.3f), fresnelConductor(0.3f, Rgb(0.2f), Rgb(3.f)));
}

TEST(Fresnel, CoatLooksTheSameFromBothSides) {
    EXPECT_EQ(Fresnel::coat(1.5f).eval(0.3f).x, fresnelDielectric(0.3f, 1, 1.5f));
    EXPECT_EQ(Fresnel::coat(1.5f).eval(-0.3f).x, fresnelDielectric(0.3f, 1, 1.5f));
}

TEST(Fresnel, MetallicBlendsTheTwoModels) {
    const Rgb r0(0.9f, 0.6f, 0.3f);
    for (const float c : {1.f, 0.6f, 0.1f}) {
        EXPECT_EQ(Fresnel::metallic(r0, 0, 1.5f).eval(c), Rgb(fresnelDielectric(c, 1, 1.5f)));
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(Fresnel::metallic(r0, 1, 1.5f).eval(c)[k], fresnelSchlick(c, r0)[k], 1e-6f);
            EXPECT_NEAR(Fresnel::metallic(r0, 0.25f, 1.5f).eval(c)[k],
                        0.75f * fresnelDielectric(c, 1, 1.5f) + 0.25f * fresnelSchlick(c, r0)[k], 1e-6f);
        }
        const float inside = fresnelDielectric(-c, 1, 1.5f), outside = fresnelDielectric(c, 1, 1.5f);
        EXPECT_NEAR(Fresnel::metallic(r0, 0, 1.5f, 0.25f).eval(-c).x, 0.75f * outside + 0.25f * inside, 1e-6f);
        EXPECT_NEAR(Fresnel::metallic(r0, 0, 1.5f, 0.25f).eval(c).x, outside, 1e-6f);
        // A metal must look the same from both sides.
        EXPECT_EQ(Fresnel::metallic(r0, 1, 1.5f).eval(-c), Fresnel::metallic(r0, 1, 1.5f).eval(c));
    }
}

}  // namespace
}  // namespace drc
