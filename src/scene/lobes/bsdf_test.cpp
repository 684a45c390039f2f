#include "scene/lobes/bsdf.h"

#include "scene/lobes/bsdf_testing.h"

namespace drc {
namespace {

using namespace test;

const Frame kFrame = Frame::fromNormal(normalize(Vec3(0.3f, -0.5f, 0.8f)));
const TrowbridgeReitz kRough(0.3f, 0.2f);

Bsdf everything() {
    Bsdf bsdf(kFrame, kFrame.n);
    bsdf.add(LambertReflection(Rgb(0.2f, 0.1f, 0.3f)));
    bsdf.add(MicrofacetReflection(Rgb(0.2f), kRough, Fresnel::dielectric(1, 1.5f)));
    bsdf.add(MicrofacetTransmission(Rgb(0.2f), kRough, 1, 1.5f));
    bsdf.add(LambertTransmission(Rgb(0.1f)));
    bsdf.add(SpecularReflection(Rgb(0.1f), Fresnel::none()));
    bsdf.add(FresnelSpecular(Rgb(1.f), Rgb(1.f), 1, 1.5f), Rgb(0.2f));
    return bsdf;
}

TEST(Bsdf, Flags) {
    const Bsdf bsdf = everything();
    EXPECT_EQ(bsdf.size(), 6);
    EXPECT_TRUE(bsdf.hasNonSpecular());
    EXPECT_TRUE(bsdf.hasSpecular());
    EXPECT_TRUE(bsdf.has(LobeFlags::Transmission, broadLobes(0.2f)));
    EXPECT_TRUE(bsdf.has(LobeFlags::Reflection | LobeFlags::Transmission | LobeFlags::Specular));
    EXPECT_FALSE(bsdf.has(LobeFlags::Diffuse | LobeFlags::Glossy));

    Bsdf mirror(kFrame, kFrame.n);
    mirror.add(SpecularTransmission(Rgb(1.f), 1, 1));
    EXPECT_FALSE(mirror.hasNonSpecular());
    EXPECT_FALSE(mirror.has(LobeFlags::Transmission, broadLobes(0.2f)));
    EXPECT_TRUE(mirror.hasSpecular());
}

TEST(Bsdf, SeparableLobesAreThoseOfOneViewFactor) {
    // Lambert's lobes go together, and no microfacets with them, however rough.
    const Bsdf mixed = everything();
    EXPECT_EQ(mixed.separableLobes(), LobeSet(0b1001));
    checkSeparableLobes(mixed);
    Bsdf rough(kFrame, kFrame.n);
    rough.add(MicrofacetReflection(Rgb(0.2f), TrowbridgeReitz(0.9f, 0.9f), Fresnel::none()));
    EXPECT_EQ(rough.separableLobes(), LobeSet(0));
    // Bases under different coats depend on the view each in its own way: the one of the greatest albedo is taken, with
    // those alike.
    const DielectricCoat coat(1.5f, 0.1f, 0), other(1.8f, 0.1f, 0);
    Bsdf coated(kFrame, kFrame.n);
    coated.add(CoatedDiffuse(Rgb(0.3f), coat));
    coated.add(LambertReflection(Rgb(0.05f)));
    coated.add(CoatedDiffuse(Rgb(0.8f, 0, 0), coat), Rgb(0.5f));
    coated.add(CoatedDiffuse(Rgb(0.1f), other));
    EXPECT_EQ(coated.separableLobes(), LobeSet(0b101));
    checkSeparableLobes(coated);
    const Vec3 wo = kFrame.toWorld(direction(0.4f));
    // But for the rounding of wo by the frame.
    const Rgb factor = coated.viewFactor(wo, 0b1), own = CoatedDiffuse(Rgb(0.3f), coat).viewFactor(direction(0.4f));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(factor[c], own[c], 1e-6f * own[c]);
    Bsdf brighter = coated;
    brighter.add(LambertReflection(Rgb(0.9f)));
    EXPECT_EQ(brighter.separableLobes(), LobeSet(0b10010));
}

TEST(Bsdf, MasksTakeLobesByTheirRoughness) {
    Bsdf bsdf(kFrame, kFrame.n);
    bsdf.add(LambertReflection(Rgb(0.1f)));
    bsdf.add(MicrofacetReflection(Rgb(1.f), TrowbridgeReitz(0.1f, 0.3f), Fresnel::none()), Rgb(0.2f));
    bsdf.add(MicrofacetTransmission(Rgb(1.f), TrowbridgeReitz(0.05f, 0.1f), 1, 1.5f), Rgb(0.3f));
    bsdf.add(SpecularReflection(Rgb(0.1f), Fresnel::none()));
    EXPECT_EQ(bsdf.alpha(1), 0.3f);
    EXPECT_EQ(bsdf.alpha(2), 0.1f);
    EXPECT_EQ(bsdf.alpha(3), 0);
    const auto counted = [&](const LobeMask& mask) {
        std::vector<int> lobes;
        for (int i = 0; i < bsdf.size(); ++i)
            if (bsdf.isWithin(i, mask)) lobes.push_back(i);
        return lobes;
    };
    using Lobes = std::vector<int>;
    EXPECT_EQ(counted(LobeFlags::All), (Lobes{0, 1, 2, 3}));
    EXPECT_EQ(counted(LobeFlags::NonSpecular), (Lobes{0, 1, 2}));
    EXPECT_EQ(counted(broadLobes(0.05f)), (Lobes{0, 1, 2}));
    EXPECT_EQ(counted(broadLobes(0.2f)), (Lobes{0, 1}));
    EXPECT_EQ(counted(broadLobes(0.3f)), (Lobes{0, 1}));  // the bound is broad
    EXPECT_EQ(counted(broadLobes(10)), (Lobes{0}));
    EXPECT_EQ(counted(glossyLobes(0.05f)), Lobes{});
    EXPECT_EQ(counted(glossyLobes(0.2f)), Lobes{2});
    EXPECT_EQ(counted(glossyLobes(0.3f)), Lobes{2});
    EXPECT_EQ(counted(glossyLobes(10)), (Lobes{1, 2}));
    EXPECT_TRUE(bsdf.has(LobeFlags::Glossy, broadLobes(0.2f)));
    EXPECT_FALSE(bsdf.has(LobeFlags::Transmission, broadLobes(0.2f)));
    EXPECT_TRUE(bsdf.has(LobeFlags::Transmission, broadLobes(0.1f)));

    // The parts are exact complements, and a copy's are the same.
    const Bsdf copy = bsdf;
    const Vec3 wo = normalize(Vec3(0.3f, 0.1f, 1)), wi = normalize(Vec3(-0.2f, 0, 1));
    const Rgb all = bsdf.f(wo, wi, LobeFlags::NonSpecular);
    for (const float threshold : {0.05f, 0.2f, 10.f}) {
        const Rgb parts = copy.f(wo, wi, broadLobes(threshold)) + copy.f(wo, wi, glossyLobes(threshold));
        EXPECT_NEAR(parts.x, all.x, 1e-6f * all.x);
    }
}

TEST(Bsdf, AddKeepsToItsLimits) {
    Bsdf bsdf;
    bsdf.add(LambertReflection(Rgb(1.f)), Rgb(0.f));
    EXPECT_EQ(bsdf.size(), 0);
    for (int i = 0; i < Bsdf::kMaxLobes + 3; ++i) bsdf.add(LambertReflection(Rgb(1.f)));
    EXPECT_EQ(bsdf.size(), Bsdf::kMaxLobes);
    const Bsdf copy = bsdf;
    EXPECT_EQ(copy.f(Vec3(0, 0, 1), Vec3(0, 0, 1)), bsdf.f(Vec3(0, 0, 1), Vec3(0, 0, 1)));
}

TEST(Bsdf, SamplingUnderEveryMask) {
    const Bsdf bsdf = everything();
    checkBsdf(bsdf, LobeFlags::NonSpecular);
    checkBsdf(bsdf, LobeFlags::All);
    checkBsdf(bsdf, LobeFlags::Reflection | LobeFlags::Diffuse | LobeFlags::Glossy);
    checkBsdf(bsdf, LobeFlags::Transmission | LobeFlags::Diffuse | LobeFlags::Glossy);
    checkUnbiased(bsdf);
    checkUnbiased(bsdf, LobeFlags::Transmission | LobeFlags::Diffuse | LobeFlags::Glossy);
    checkBsdfEnergy(bsdf);
}

TEST(Bsdf, AllIsTheSumOfSpecularAndTheRest) {
    const Bsdf bsdf = everything();
    constexpr LobeFlags kSpecular = LobeFlags::Specular | LobeFlags::Reflection | LobeFlags::Transmission;
    for (const float c : {0.8f, -0.9f}) {
        const Vec3 wo = kFrame.toWorld(direction(c));
        const Mean all = meanWeight(bsdf, wo, LobeFlags::All, 200000);
        const Mean rest = meanWeight(bsdf, wo, LobeFlags::NonSpecular, 200000);
        const Mean specular = meanWeight(bsdf, wo, kSpecular, 200000);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(all.value[k], rest.value[k] + specular.value[k], 8e-3f);
        EXPECT_NEAR(specular.value.x, 0.3f, 4 * specular.error + 1e-5f);
    }
}

TEST(Bsdf, SpecularMaskGivesOnlySpecularSamples) {
    const Bsdf bsdf = everything();
    std::mt19937 rng(1);
    const Vec3 wo = kFrame.toWorld(direction(0.6f));
    double reflected = 0;
    for (int i = 0; i < 1000; ++i) {
        const auto s = bsdf.sample(wo, uniform(rng), Vec2(0.5f, 0.5f),
                                   LobeFlags::Specular | LobeFlags::Reflection | LobeFlags::Transmission);
        ASSERT_TRUE(s);
        EXPECT_TRUE(s->isSpecular());
        reflected += !s->isTransmission();
    }
    EXPECT_GT(reflected, 0);
    // Smooth glass reflects and transmits, and so is out where only one of them is asked for.
    const auto s = bsdf.sample(wo, 0.9f, Vec2(0.5f, 0.5f), LobeFlags::Specular | LobeFlags::Transmission);
    EXPECT_FALSE(s);
}

TEST(Bsdf, GeometricNormalDecidesTheSide) {
    // The shading normal leans so far that wi is above it but below the surface.
    const Vec3 ng(0, 0, 1);
    const Frame shading = Frame::fromNormal(normalize(Vec3(1, 0, 0.3f)));
    Bsdf bsdf(shading, ng);
    bsdf.add(LambertReflection(Rgb(0.5f)));
    const Vec3 wo = normalize(Vec3(0.2f, 0, 1)), wi = normalize(Vec3(1, 0, -0.1f));
    ASSERT_GT(dot(wi, shading.n), 0);
    EXPECT_TRUE(isBlack(bsdf.f(wo, wi)));
    bsdf.add(LambertTransmission(Rgb(0.25f)));
    EXPECT_NEAR(bsdf.f(wo, wi).x, 0.25f * kInvPi, 1e-6f);
    // Nothing that sample() gives crosses the surface without a lobe that transmits.
    Bsdf opaque(shading, ng);
    opaque.add(LambertReflection(Rgb(0.5f)));
    opaque.add(MicrofacetReflection(Rgb(0.5f), kRough, Fresnel::none()));
    std::mt19937 rng(2);
    for (int i = 0; i < 1000; ++i) {
        const float uLobe = uniform(rng);
        const auto s = opaque.sample(wo, uLobe, uniform2(rng));
        EXPECT_TRUE(!s || s->wi.z > 0);
    }
    checkBsdf(opaque, LobeFlags::All, {0.9f});
}

TEST(Bsdf, ALobeOfBothSidesLeaksNoLight) {
    // As above, but with a lobe that reflects and refracts: it may do neither where the two normals disagree.
    const Vec3 ng(0, 0, 1);
    const Frame shading = Frame::fromNormal(normalize(Vec3(1, 0, 0.3f)));
    Bsdf bsdf(shading, ng);
    bsdf.add(MicrofacetDielectric(Rgb(1.f), Rgb(1.f), kRough, 1.5f));
    const Vec3 wo = normalize(Vec3(0.2f, 0, 1)), wi = normalize(Vec3(1, 0, -0.1f));
    ASSERT_GT(dot(wi, shading.n), 0);
    EXPECT_TRUE(isBlack(bsdf.f(wo, wi)));
    std::mt19937 rng(2);
    int reflected = 0, refracted = 0;
    for (int i = 0; i < 2000; ++i) {
        const float uLobe = uniform(rng);
        const auto s = bsdf.sample(wo, uLobe, uniform2(rng));
        if (!s) continue;
        EXPECT_EQ(s->isTransmission(), s->wi.z < 0);
        EXPECT_EQ(s->isTransmission(), dot(s->wi, shading.n) < 0);
        ++(s->isTransmission() ? refracted : reflected);
    }
    EXPECT_GT(reflected, 10);
    EXPECT_GT(refracted, 100);
    checkBsdf(bsdf, LobeFlags::All, {0.9f});
}

// A shading normal that leans so far that the viewer is below its horizon, though above the surface.
struct Leaning {
    Vec3 ng{0, 0, 1}, wo = normalize(Vec3(0.95f, 0.1f, 0.3f));
    Frame shading = Frame::fromNormal(normalize(Vec3(-0.7f, 0.2f, 0.7f)));
    template <class L>
    Bsdf with(const L& lobe) const {
        Bsdf bsdf(shading, ng);
        bsdf.add(lobe);
        bsdf.bendFor(wo);
        return bsdf;
    }
};

TEST(Bsdf, IsBentForViewersBelowItsHorizon) {
    const Leaning leaning;
    ASSERT_LT(dot(leaning.wo, leaning.shading.n), -0.2f);
    const Bsdf matte = leaning.with(LambertReflection(Rgb(1.f)));
    EXPECT_TRUE(matte.bentForView());
    EXPECT_GT(dot(matte.frame().n, leaning.wo), 0);
    // At least the half of the cosine lobe is above the surface, and never more than all of it.
    const Mean albedo = meanWeight(matte, leaning.wo);
    EXPECT_GT(albedo.value.x, 0.95f);
    EXPECT_LE(albedo.value.x, 1);
    Bsdf unbent(leaning.shading, leaning.ng);
    unbent.add(LambertReflection(Rgb(1.f)));
    EXPECT_LT(meanWeight(unbent, leaning.wo).value.x, 0.3f);

    // A mirror shows what is above the surface.
    const Bsdf mirror = leaning.with(SpecularReflection(Rgb(1.f), Fresnel::none()));
    const auto s = mirror.sample(leaning.wo, 0.5f, Vec2(0.5f, 0.5f));
    ASSERT_TRUE(s);
    EXPECT_GT(s->wi.z, 0);
    EXPECT_GT(meanWeight(leaning.with(MicrofacetReflection(Rgb(1.f), kRough, Fresnel::none())), leaning.wo).value.x,
              0.4f);
    // Samples follow the density in the bent frame.
    Bsdf all = leaning.with(LambertReflection(Rgb(0.3f)));
    all.add(LambertTransmission(Rgb(0.2f)));
    all.add(MicrofacetReflection(Rgb(0.5f), kRough, Fresnel::none()));
    all.bendFor(leaning.wo);
    checkBsdf(all, LobeFlags::All, {std::max(0.02f, dot(all.frame().n, leaning.wo))});
}

TEST(Bsdf, StaysAsItIsForOtherViewers) {
    Leaning leaning;
    leaning.wo = normalize(Vec3(-0.3f, 0.1f, 1));
    for (const bool mirrors : {false, true}) {
        Bsdf bsdf(leaning.shading, leaning.ng);
        bsdf.add(LambertReflection(Rgb(1.f)));
        if (mirrors) bsdf.add(MicrofacetReflection(Rgb(0.5f), kRough, Fresnel::none()));
        // Above the horizon of the shading normal, while its mirror image is below the surface.
        const Vec3 low = normalize(Vec3(0.3f, 0, 0.5f));
        for (const Vec3& wo : {leaning.wo, -leaning.wo, low}) {
            bsdf.bendFor(wo);
            EXPECT_EQ(bsdf.bentForView(), mirrors && wo == low);
            EXPECT_EQ(bsdf.frame().n == leaning.shading.n, !bsdf.bentForView());
        }
    }
    // Fibres have no horizon.
    EXPECT_FALSE(Leaning().with(HairScattering(0.2f, Rgb(0.1f), {})).bentForView());
    EXPECT_FALSE(Bsdf(Leaning().shading, Leaning().ng).bentForView());
}

TEST(Bsdf, KnowsHowOthersSeeIt) {
    const Leaning leaning;
    const Bsdf bsdf = leaning.with(LambertReflection(Rgb(1.f)));
    const Vec3 above = normalize(Vec3(-0.3f, 0.1f, 1));
    const Bsdf seen = bsdf.seenFrom(above), copy = bsdf, again = seen.seenFrom(leaning.wo);
    EXPECT_FALSE(seen.bentForView());
    EXPECT_EQ(seen.frame().n, leaning.shading.n);
    EXPECT_EQ(seen.size(), 1);
    EXPECT_TRUE(copy.bentForView());
    EXPECT_EQ(copy.frame().n, bsdf.frame().n);
    EXPECT_TRUE(again.bentForView());
    EXPECT_EQ(again.frame().n, bsdf.frame().n);
    EXPECT_EQ(again.f(leaning.wo, above), bsdf.f(leaning.wo, above));
}

TEST(Bsdf, LobesWithAVanishingEstimateAreStillSampled) {
    // Beyond the critical angle of the smooth surface some facets still refract.
    Bsdf bsdf(kFrame, kFrame.n);
    const TrowbridgeReitz rough(0.6f, 0.6f);
    bsdf.add(MicrofacetReflection(Rgb(1.f), rough, Fresnel::dielectric(1, 1.5f)));
    bsdf.add(MicrofacetTransmission(Rgb(1.f), rough, 1, 1.5f));
    checkBsdf(bsdf, LobeFlags::NonSpecular, {-0.5f});
    const Vec3 wo = kFrame.toWorld(direction(-0.5f));
    EXPECT_GT(meanWeight(bsdf, wo, LobeFlags::Transmission | LobeFlags::Glossy).value.x, 0.01f);
    checkUnbiased(bsdf);
}

TEST(Bsdf, EmptyAndGrazing) {
    const Bsdf empty(kFrame, kFrame.n);
    EXPECT_FALSE(empty.sample(kFrame.n, 0.5f, Vec2(0.5f, 0.5f)));
    EXPECT_EQ(empty.pdf(kFrame.n, kFrame.n), 0);
    Bsdf bsdf(Frame(), Vec3(0, 0, 1));
    bsdf.add(LambertReflection(Rgb(1.f)));
    EXPECT_FALSE(bsdf.sample(Vec3(1, 0, 0), 0.5f, Vec2(0.5f, 0.5f)));
    EXPECT_TRUE(isBlack(bsdf.f(Vec3(1, 0, 0), Vec3(0, 0, 1))));
}

TEST(Bsdf, ExtremeRandomNumbers) {
    const Bsdf bsdf = everything();
    const Vec3 wo = kFrame.toWorld(direction(0.5f));
    for (const float a : {0.f, 0.5f, kOneMinusEpsilon})
        for (const float b : {0.f, 0.5f, kOneMinusEpsilon})
            for (const float c : {0.f, 0.5f, kOneMinusEpsilon}) {
                const auto s = bsdf.sample(wo, a, Vec2(b, c));
                EXPECT_TRUE(!s || (isFinite(s->f) && s->pdf > 0 && std::isfinite(s->pdf)));
            }
}

}  // namespace
}  // namespace drc
