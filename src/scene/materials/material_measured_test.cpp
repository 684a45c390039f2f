#include "scene/materials/material_measured.h"

#include "scene/lobes/measured_testing.h"
#include "scene/lobes/microfacet_reflection.h"
#include "scene/materials/material_testing.h"

namespace drc {
namespace {

using namespace test;

TEST(Measured, Bsdf) {
    const TrowbridgeReitz microfacets(0.4f, 0.4f);
    const MicrofacetReflection metal(Rgb(0.9f, 0.7f, 0.5f), microfacets, Fresnel::none());
    const MaterialPtr material =
        makeMeasured(std::make_shared<const MeasuredTable>(measuredDataOfLobe(metal, microfacets, {.theta = 16})), {});
    const Bsdf bsdf = bsdfOf(material);
    checkBsdf(bsdf, LobeFlags::NonSpecular, {0.9f, -0.3f});
    checkUnbiased(bsdf);
    checkBsdfEnergy(bsdf);
    EXPECT_FALSE(bsdf.has(LobeFlags::Transmission));
    EXPECT_TRUE(bsdf.hasWithin(broadLobes(0.3f)));
    EXPECT_FALSE(bsdf.hasWithin(broadLobes(0.5f)));
    EXPECT_TRUE(material->isConstant());
    EXPECT_EQ(material->maxLobes(), 1);
}

}  // namespace
}  // namespace drc
