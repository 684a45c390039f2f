#include "scene/materials/material_fourier.h"

#include "scene/lobes/fourier_testing.h"
#include "scene/lobes/lambert_reflection.h"
#include "scene/lobes/microfacet_reflection.h"
#include "scene/materials/material_testing.h"

namespace drc {
namespace {

using namespace test;

std::shared_ptr<const FourierTable> table(FourierSeries series) {
    return std::make_shared<const FourierTable>(std::move(series));
}

TEST(Fourier, Bsdf) {
    checkMaterial(
        makeFourier(table(fourierSeriesOfLobe(LambertReflection(Rgb(0.2f, 0.5f, 0.8f)), fourierCosines(8), 3)), {}));
    const MicrofacetReflection metal(Rgb(1.f), TrowbridgeReitz(0.4f, 0.4f), Fresnel::none());
    const MaterialPtr conductor = makeFourier(table(fourierSeriesOfLobe(metal, fourierCosines(24))), {});
    const Bsdf bsdf = bsdfOf(conductor);
    checkBsdf(bsdf, LobeFlags::NonSpecular, {0.9f, -0.3f});
    checkUnbiased(bsdf);
    checkBsdfEnergy(bsdf);
    EXPECT_FALSE(bsdf.has(LobeFlags::Transmission));
    EXPECT_TRUE(bsdf.hasWithin(broadLobes(0.3f)));
    EXPECT_FALSE(bsdf.hasWithin(broadLobes(0.5f)));
    EXPECT_TRUE(conductor->isConstant());
}

TEST(Fourier, Black) {
    const auto black = table(fourierSeriesOf([](const Vec3&, const Vec3&) { return Rgb(0.f); }, fourierCosines(3)));
    EXPECT_EQ(bsdfOf(makeFourier(black, {})).size(), 0);
}

}  // namespace
}  // namespace drc
