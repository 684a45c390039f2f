#include "scene/lobes/fourier_bsdf.h"

#include "scene/lobes/fourier_testing.h"
#include "scene/lobes/lambert_reflection.h"
#include "scene/lobes/lambert_transmission.h"
#include "scene/lobes/lobe_testing.h"
#include "scene/lobes/microfacet_reflection.h"
#include "scene/lobes/microfacet_transmission.h"

namespace drc {
namespace {

using namespace test;

const Fresnel kCopper = Fresnel::conductor(Rgb(0.2f, 0.924f, 1.102f), Rgb(3.912f, 2.452f, 2.142f));

MicrofacetReflection conductor(float alpha) {
    return MicrofacetReflection(Rgb(1.f), TrowbridgeReitz(alpha, alpha), kCopper);
}
// Rough glass, both its reflection and its transmission.
struct RoughGlass {
    static constexpr float kEta = 1.5f;
    MicrofacetReflection reflection{Rgb(1.f), TrowbridgeReitz(0.4f, 0.4f), Fresnel::dielectric(1, kEta)};
    MicrofacetTransmission transmission{Rgb(1.f), TrowbridgeReitz(0.4f, 0.4f), 1, kEta};
    Rgb f(const Vec3& wo, const Vec3& wi, TransportMode mode) const {
        return sameHemisphere(wo, wi) ? reflection.f(wo, wi) : transmission.f(wo, wi, mode);
    }
};

const FourierTable& lambertTable() {
    static const FourierTable table(
        fourierSeriesOfLobe(LambertReflection(Rgb(0.8f, 0.5f, 0.2f)), fourierCosines(8), 3));
    return table;
}
const FourierTable& conductorTable() {
    static const FourierTable table(fourierSeriesOfLobe(conductor(0.35f), fourierCosines(32), 3));
    return table;
}
const FourierTable& glassTable() {
    static const FourierTable table(fourierSeriesOfLobe(RoughGlass(), fourierCosines(32), 1, RoughGlass::kEta, 64));
    return table;
}
// A table that no surface has: coarse, cut off after few orders, so that it is negative in places.
const FourierTable& ringingTable() {
    static const FourierTable table(fourierSeriesOfLobe(conductor(0.15f), fourierCosines(8), 1, 1, 6));
    return table;
}

TEST(FourierBsdf, Sampling) {
    checkSampling(FourierBsdf(lambertTable()));
    checkSampling(FourierBsdf(conductorTable()));
    checkSampling(FourierBsdf(glassTable()));
}

// The density is never negative, and is that of the samples, although the series is negative here and there.
TEST(FourierBsdf, SamplingOfATableThatIsNegativeInPlaces) {
    const FourierBsdf lobe(ringingTable());
    int negative = 0;
    for (float azimuth = 0; azimuth < kPi; azimuth += 0.05f)
        negative += isBlack(lobe.f(direction(0.3f, 0), direction(0.35f, azimuth)));
    EXPECT_GT(negative, 5);
    checkSampling(lobe);
}

TEST(FourierBsdf, IsTheLambertianThatItWasMadeOf) {
    const FourierBsdf lobe(lambertTable());
    const Rgb albedo(0.8f, 0.5f, 0.2f);
    std::mt19937 rng(1);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 wo = randomDirection(rng), wi = randomDirection(rng);
        expectClose(lobe.f(wo, wi), sameHemisphere(wo, wi) ? albedo * kInvPi : Rgb(0.f), 1e-4f);
    }
    for (const float c : {1.f, 0.5f, 0.03f, -0.2f}) {
        expectClose(lobe.albedo(direction(c)), albedo, 1e-4f);
        // Samples are spread in proportion to f cos, but for half a per cent.
        expectClose(furnace(lobe, direction(c), 100000), albedo, 3e-3f);
    }
    EXPECT_EQ(lobe.flags(), LobeFlags::Reflection | LobeFlags::Glossy);
    EXPECT_GT(lobe.alpha(), 4);
}

TEST(FourierBsdf, IsTheConductorThatItWasMadeOf) {
    const FourierBsdf lobe(conductorTable());
    const MicrofacetReflection truth = conductor(0.35f);
    std::mt19937 rng(2);
    double error = 0, sum = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vec3 wo = randomDirection(rng), wi = randomDirection(rng);
        if (!sameHemisphere(wo, wi)) {
            EXPECT_TRUE(isBlack(lobe.f(wo, wi)));
            continue;
        }
        error += std::abs(luminance(lobe.f(wo, wi) - truth.f(wo, wi))) * absCosTheta(wi);
        sum += luminance(truth.f(wo, wi)) * absCosTheta(wi);
    }
    EXPECT_LT(error, 0.01 * sum);
    for (const float c : {1.f, 0.7f, 0.3f, 0.1f, -0.5f}) {
        expectClose(furnace(lobe, direction(c), 200000), furnace(truth, direction(c), 200000), 0.01f);
        expectClose(lobe.albedo(direction(c)), furnace(lobe, direction(c), 200000), 0.01f);
    }
}

TEST(FourierBsdf, IsTheGlassThatItWasMadeOf) {
    const FourierBsdf lobe(glassTable());
    const RoughGlass truth;
    for (const float c : {1.f, 0.6f, -0.9f, -0.4f}) {
        const Vec3 wo = direction(c);
        const Rgb whole = furnace(truth.reflection, wo, 200000) + furnace(truth.transmission, wo, 200000);
        expectClose(furnace(lobe, wo, 200000), whole, 0.02f);
        std::mt19937 rng(3);
        int through = 0;
        constexpr int kSamples = 20000;
        for (int i = 0; i < kSamples; ++i) {
            const float uLobe = uniform(rng);
            const LobeSample s = lobe.sample(wo, uLobe, uniform2(rng), TransportMode::Radiance);
            if (!(s.pdf > 0)) continue;
            const bool crosses = !sameHemisphere(wo, s.wi);
            through += crosses;
            EXPECT_EQ(s.flags, (crosses ? LobeFlags::Transmission : LobeFlags::Reflection) | LobeFlags::Glossy);
            EXPECT_FLOAT_EQ(s.eta, !crosses ? 1 : c > 0 ? 1.5f : 1 / 1.5f);
        }
        EXPECT_NEAR(float(through) / kSamples, furnace(truth.transmission, wo).x / whole.x, 0.02f) << c;
    }
    EXPECT_EQ(lobe.flags(), LobeFlags::Reflection | LobeFlags::Transmission | LobeFlags::Glossy);
}

TEST(FourierBsdf, RefractionScalesRadianceAlone) {
    const FourierBsdf lobe(glassTable());
    std::mt19937 rng(4);
    int crossed = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 wo = randomDirection(rng), wi = randomDirection(rng);
        const Rgb radiance = lobe.f(wo, wi), importance = lobe.f(wo, wi, TransportMode::Importance);
        const float eta = wo.z > 0 ? 1.5f : 1 / 1.5f;
        expectClose(radiance * (sameHemisphere(wo, wi) ? 1 : eta * eta), importance, 1e-5f);
        crossed += !sameHemisphere(wo, wi) && !isBlack(radiance);
        EXPECT_EQ(lobe.pdf(wo, wi), lobe.evaluate(wo, wi, TransportMode::Importance).pdf);
    }
    EXPECT_GT(crossed, 300);
}

TEST(FourierBsdf, EnergyAndReciprocity) {
    for (const FourierTable* table : {&lambertTable(), &conductorTable(), &glassTable()}) {
        const FourierBsdf lobe(*table);
        checkEnergy(lobe);
        std::mt19937 rng(5);
        double difference = 0, sum = 0;
        for (int i = 0; i < 4000; ++i) {
            const Vec3 wo = randomDirection(rng), wi = randomDirection(rng);
            if (std::min(absCosTheta(wo), absCosTheta(wi)) < 0.1f) continue;
            const Rgb there = lobe.f(wo, wi), back = lobe.f(wi, wo, TransportMode::Importance);
            difference += std::abs(luminance(there - back));
            sum += luminance(there);
        }
        // As far as interpolation in two different cosines, one of them times f, is the same.
        EXPECT_LT(difference, 0.01 * sum);
    }
}

// The alpha of a table of microfacets is about that of the microfacets; a sharp gloss over a diffuse base counts
// as sharp, a faint and blurred one as broad.
TEST(FourierBsdf, AlphaIsAboutThatOfMicrofacets) {
    for (const float alpha : {0.2f, 0.35f, 0.5f}) {
        const FourierTable table(fourierSeriesOfLobe(conductor(alpha), fourierCosines(32)));
        EXPECT_NEAR(table.alpha(), alpha, 0.15f * alpha);
    }
    const auto coated = [](float alpha, float weight) {
        const MicrofacetReflection coat(Rgb(weight), TrowbridgeReitz(alpha, alpha), Fresnel::none());
        return FourierTable(fourierSeriesOf(
            [&](const Vec3& wo, const Vec3& wi) {
                return sameHemisphere(wo, wi) ? Rgb((1 - weight) * kInvPi) + coat.f(wo, wi) : Rgb(0.f);
            },
            fourierCosines(48)));
    };
    EXPECT_LT(coated(0.06f, 0.1f).alpha(), 0.2f);
    EXPECT_GT(coated(0.35f, 0.1f).alpha(), 0.8f);
}

TEST(FourierBsdf, OneSideOnlyAndBlackTables) {
    // Lit and seen from above alone.
    const FourierTable above(
        fourierSeriesOf([](const Vec3& wo, const Vec3& wi) { return Rgb(wo.z > 0 && wi.z > 0 ? 0.5f * kInvPi : 0.f); },
                        fourierCosines(6)));
    const FourierBsdf lobe(above);
    EXPECT_NEAR(furnace(lobe, direction(0.5f), 100000).x, 0.5f, 3e-3f);
    EXPECT_TRUE(isBlack(furnace(lobe, direction(-0.5f))));
    EXPECT_EQ(lobe.sample(direction(-0.5f), 0.5f, Vec2(0.5f, 0.5f), TransportMode::Radiance).pdf, 0);
    const FourierTable through(fourierSeriesOf(
        [](const Vec3& wo, const Vec3& wi) { return Rgb(sameHemisphere(wo, wi) ? 0.f : kInvPi); }, fourierCosines(6)));
    EXPECT_EQ(FourierBsdf(through).flags(), LobeFlags::Transmission | LobeFlags::Glossy);
    checkSampling(FourierBsdf(through), {0.7f, -0.2f});
    const FourierTable black(fourierSeriesOf([](const Vec3&, const Vec3&) { return Rgb(0.f); }, fourierCosines(3)));
    EXPECT_FALSE(black.reflects() || black.transmits());
    EXPECT_FALSE(black.sample(0.5f, 0.5f, Vec2(0.5f, 0.5f)));
}

}  // namespace
}  // namespace drc
