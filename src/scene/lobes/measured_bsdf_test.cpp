#include "scene/lobes/measured_bsdf.h"

#include "scene/lobes/lambert_reflection.h"
#include "scene/lobes/lobe_testing.h"
#include "scene/lobes/measured_testing.h"
#include "scene/lobes/microfacet_reflection.h"

namespace drc {
namespace {

using namespace test;

const Fresnel kCopper = Fresnel::conductor(Rgb(0.2f, 0.924f, 1.102f), Rgb(3.912f, 2.452f, 2.142f));
const TrowbridgeReitz kRound(0.3f, 0.3f), kBrushed(0.5f, 0.25f);
const MicrofacetReflection kMetal(Rgb(1.f), kRound, kCopper), kBrushedMetal(Rgb(1.f), kBrushed, kCopper);

const MeasuredTable& metalTable() {
    static const MeasuredTable table(measuredDataOfLobe(kMetal, kRound, {.theta = 16}));
    return table;
}
const MeasuredTable& brushedTable() {
    static const MeasuredTable table(measuredDataOfLobe(kBrushedMetal, kBrushed, {.theta = 14, .phi = 25}));
    return table;
}
// Matte, measured with a parameterization that does not suit it.
const MeasuredTable& matteTable() {
    static const MeasuredTable table(
        measuredDataOfLobe(LambertReflection(Rgb(0.6f, 0.5f, 0.3f)), TrowbridgeReitz(0.8f, 0.8f), {.theta = 16}));
    return table;
}

TEST(MeasuredBsdf, Sampling) {
    checkSampling(MeasuredBsdf(metalTable()));
    checkSampling(MeasuredBsdf(brushedTable()));
    checkSampling(MeasuredBsdf(matteTable()));
}

// Mean error of f cos, relative to its mean.
template <typename L>
double errorOf(const MeasuredBsdf& lobe, const L& truth) {
    std::mt19937 rng(1);
    double error = 0, sum = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 wo = randomDirection(rng), wi = randomDirection(rng);
        if (!sameHemisphere(wo, wi)) {
            EXPECT_TRUE(isBlack(lobe.f(wo, wi)));
            EXPECT_EQ(lobe.pdf(wo, wi), 0);
            continue;
        }
        for (int c = 0; c < 3; ++c) {
            error += std::abs(lobe.f(wo, wi)[c] - truth.f(wo, wi)[c]) * absCosTheta(wi);
            sum += truth.f(wo, wi)[c] * absCosTheta(wi);
        }
    }
    return error / sum;
}

TEST(MeasuredBsdf, IsWhatWasMeasured) {
    EXPECT_LT(errorOf(MeasuredBsdf(metalTable()), kMetal), 0.02);
    EXPECT_LT(errorOf(MeasuredBsdf(brushedTable()), kBrushedMetal), 0.03);
    EXPECT_LT(errorOf(MeasuredBsdf(matteTable()), LambertReflection(Rgb(0.6f, 0.5f, 0.3f))), 0.02);
}

template <typename L>
void checkAlbedos(const MeasuredTable& table, const L& truth, float tolerance) {
    const MeasuredBsdf lobe(table);
    for (const float c : {1.f, 0.8f, 0.4f, 0.15f, -0.6f})
        for (const float phi : {0.7f, -2.f}) {
            SCOPED_TRACE(c);
            const Vec3 wo = direction(c, phi);
            expectClose(furnace(lobe, wo, 100000), furnace(truth, wo, 100000), tolerance, "furnace");
            expectClose(lobe.albedo(wo), furnace(lobe, wo, 100000), 0.02f, "albedo");
        }
}

TEST(MeasuredBsdf, Albedo) {
    checkAlbedos(metalTable(), kMetal, 0.01f);
    checkAlbedos(brushedTable(), kBrushedMetal, 0.02f);
    checkAlbedos(matteTable(), LambertReflection(Rgb(0.6f, 0.5f, 0.3f)), 0.02f);
}

TEST(MeasuredBsdf, EnergyAndReciprocity) {
    const MicrofacetReflection white(Rgb(1.f), kRound, Fresnel::none());
    const MeasuredTable table(measuredDataOfLobe(white, kRound, {.theta = 16}));
    checkEnergy(MeasuredBsdf(table));
    for (const MeasuredTable* measured : {&metalTable(), &brushedTable()}) {
        const MeasuredBsdf lobe(*measured);
        std::mt19937 rng(5);
        double difference = 0, sum = 0;
        for (int i = 0; i < 20000; ++i) {
            const Vec3 wo = randomDirection(rng), wi = randomDirection(rng);
            if (std::min(absCosTheta(wo), absCosTheta(wi)) < 0.1f) continue;
            const Rgb there = lobe.f(wo, wi), back = lobe.f(wi, wo);
            difference += std::abs(luminance(there - back));
            sum += luminance(there);
        }
        // As far as different places of the table agree.
        EXPECT_LT(difference, 0.02 * sum);
    }
}

// A half or a quarter of the circle is enough for a surface with symmetries.
TEST(MeasuredBsdf, Symmetries) {
    for (const int symmetries : {2, 4}) {
        const MeasuredTable part(measuredDataOfLobe(
            kBrushedMetal, kBrushed, {.theta = 14, .phi = 24 / symmetries + 1, .symmetries = symmetries}));
        checkSampling(MeasuredBsdf(part), {0.6f, -0.3f});
        EXPECT_LT(errorOf(MeasuredBsdf(part), kBrushedMetal), 0.03) << symmetries;
    }
}

TEST(MeasuredBsdf, AnisotropicSurfacesTurn) {
    const MeasuredBsdf brushed(brushedTable()), round(metalTable());
    const Vec3 alongX = brushed.f(direction(0.8f, 0), direction(0.8f, kPi - 0.6f)),
               alongY = brushed.f(direction(0.8f, 0.5f * kPi), direction(0.8f, 1.5f * kPi - 0.6f));
    EXPECT_GT(std::abs(alongX.x - alongY.x), 0.1f * alongX.x);
    EXPECT_NEAR(round.f(direction(0.8f, 0), direction(0.5f, 2)).x,
                round.f(direction(0.8f, 1.3f), direction(0.5f, 3.3f)).x, 1e-3f);
}

// Files may have f |cos| itself.
TEST(MeasuredBsdf, WithoutJacobian) {
    MeasuredData data = measuredDataOf(
        [](const Vec3& wo, const Vec3& wi) {
            const Vec3 wm = normalize(wo + wi);
            // measuredDataOf() multiplies by 4 sigma / D.
            return kMetal.f(wo, wi) * (kRound.d(wm) * kRound.g1OverCosine(wo) / 4);
        },
        kRound, {.theta = 16, .light = 64});
    data.jacobian = false;
    const MeasuredTable table(std::move(data));
    EXPECT_LT(errorOf(MeasuredBsdf(table), kMetal), 0.05);
}

TEST(MeasuredBsdf, Alpha) {
    for (const float alpha : {0.15f, 0.3f, 0.5f}) {
        const TrowbridgeReitz microfacets(alpha, alpha);
        const MeasuredTable table(
            measuredDataOfLobe(MicrofacetReflection(Rgb(1.f), microfacets, kCopper), microfacets));
        EXPECT_NEAR(table.alpha(), alpha, 0.2f * alpha);
    }
    EXPECT_GT(matteTable().alpha(), 1.5f);
}

}  // namespace
}  // namespace drc
