#include "scene/materials/conductor_textures.h"
#include "scene/materials/material_disney.h"
#include "scene/materials/material_glass.h"
#include "scene/materials/material_hair.h"
#include "scene/materials/material_matte.h"
#include "scene/materials/material_metal.h"
#include "scene/materials/material_mirror.h"
#include "scene/materials/material_mix.h"
#include "scene/materials/material_plastic.h"
#include "scene/materials/material_substrate.h"
#include "scene/materials/material_testing.h"
#include "scene/materials/material_translucent.h"
#include "scene/materials/material_uber.h"

namespace drc {
namespace {

using namespace test;

TEST(Matte, Bsdf) {
    checkMaterial(makeMatte({}));
    checkMaterial(makeMatte({.kd = colour(0.2f, 0.5f, 0.8f), .sigma = number(25), .relief = {}}));
    EXPECT_NEAR(weightAtNormal(makeMatte({})), 0.5f, 1e-5f);
    EXPECT_EQ(bsdfOf(makeMatte({.kd = colour(0, 0, 0), .sigma = {}, .relief = {}})).size(), 0);
}

TEST(Plastic, Bsdf) {
    PlasticParams p;
    checkMaterial(makePlastic(p));
    EXPECT_EQ(bsdfOf(makePlastic(p)).size(), 2);
    p.ks = colour(0, 0, 0);
    EXPECT_EQ(bsdfOf(makePlastic(p)).size(), 1);
    // As in pbrt, the highlight is totally reflecting beyond the critical angle.
    p.kd = colour(0, 0, 0);
    p.ks = colour(0.5f, 0.5f, 0.5f);
    p.roughness = number(0.01f);
    p.remapRoughness = false;
    const Bsdf bsdf = bsdfOf(makePlastic(p));
    EXPECT_NEAR(meanWeight(bsdf, bsdf.frame().toWorld(direction(0.5f))).value.x, 0.5f, 2e-3f);
}

TEST(Metal, Bsdf) {
    MetalParams p;
    checkMaterial(makeMetal(p));
    p.uRoughness = number(0.5f);
    p.vRoughness = number(0.1f);
    checkMaterial(makeMetal(p));
    MetalParams smooth;
    smooth.roughness = number(0.001f);
    smooth.remapRoughness = false;
    const Bsdf bsdf = bsdfOf(makeMetal(smooth));
    expectClose(meanWeight(bsdf, bsdf.frame().n).value, fresnelConductor(1, kCopperEta, kCopperK), 2e-3f);
}

TEST(Mirror, Bsdf) {
    checkMaterial(makeMirror({}));
    EXPECT_NEAR(weightAtNormal(makeMirror({})), 0.9f, 1e-5f);
    EXPECT_FALSE(bsdfOf(makeMirror({})).hasNonSpecular());
}

TEST(Glass, Smooth) {
    const MaterialPtr glass = makeGlass({});
    checkMaterial(glass);
    EXPECT_NEAR(weightAtNormal(glass), 1, 1e-5f);
    EXPECT_NEAR(weightAtNormal(glass, kSpecular), 1, 1e-5f);
    EXPECT_FALSE(bsdfOf(glass).hasNonSpecular());
}

TEST(Glass, Rough) {
    GlassParams p;
    p.uRoughness = number(0.05f);
    p.vRoughness = number(0.2f);
    checkMaterial(makeGlass(p));
    EXPECT_TRUE(bsdfOf(makeGlass(p)).has(LobeFlags::Transmission, broadLobes(0.2f)));
    p.eta = number(1);
    EXPECT_NEAR(weightAtNormal(makeGlass(p)), 1, 1e-5f);
}

TEST(Uber, Bsdf) {
    UberParams p;
    checkMaterial(makeUber(p));
    p.kr = colour(0.2f, 0.2f, 0.2f);
    p.kt = colour(0.3f, 0.3f, 0.3f);
    p.opacity = colour(0.6f, 0.7f, 0.8f);
    p.uRoughness = number(0.3f);
    checkMaterial(makeUber(p));
    EXPECT_EQ(bsdfOf(makeUber(p)).size(), 5);
}

TEST(Uber, AnIndexOfOneReflectsNothing) {
    UberParams p;
    p.kr = colour(0.5f, 0.5f, 0.5f);
    EXPECT_EQ(bsdfOf(makeUber(p)).size(), 3);
    p.eta = number(1);
    EXPECT_EQ(bsdfOf(makeUber(p)).size(), 1);  // the diffuse base
}

TEST(Uber, OpacityPassesStraightThrough) {
    UberParams p;
    p.opacity = colour(0.25f, 0.25f, 0.25f);
    const Bsdf bsdf = bsdfOf(makeUber(p));
    const Vec3 wo = bsdf.frame().toWorld(direction(0.4f));
    const auto s = bsdf.sample(wo, 0.1f, Vec2(0.5f, 0.5f), kSpecular);
    ASSERT_TRUE(s);
    EXPECT_LT(length(s->wi + wo), 1e-5f);
    EXPECT_EQ(s->eta, 1);
    EXPECT_NEAR(s->f.x * absDot(s->wi, bsdf.frame().n) / s->pdf, 0.75f, 1e-5f);
    // The diffuse lobe alone: kd times opacity.
    EXPECT_NEAR(meanWeight(bsdf, wo, LobeFlags::Reflection | LobeFlags::Diffuse).value.x, 0.0625f, 1e-5f);
    p.opacity = colour(0, 0, 0);
    EXPECT_EQ(bsdfOf(makeUber(p)).size(), 1);
}

TEST(Substrate, Bsdf) {
    checkMaterial(makeSubstrate({}));
    SubstrateParams p;
    p.kd = colour(0.1f, 0.3f, 0.6f);
    p.ks = colour(0.04f, 0.04f, 0.04f);
    p.uRoughness = number(0.001f);
    p.vRoughness = number(0.2f);
    checkMaterial(makeSubstrate(p));
}

TEST(Translucent, Bsdf) {
    checkMaterial(makeTranslucent({}));
    const Bsdf bsdf = bsdfOf(makeTranslucent({}));
    EXPECT_EQ(bsdf.size(), 4);
    EXPECT_TRUE(bsdf.has(LobeFlags::Transmission, broadLobes(0.2f)));
    constexpr LobeFlags kDiffuse = LobeFlags::Diffuse | LobeFlags::Transmission;
    EXPECT_NEAR(meanWeight(bsdf, bsdf.frame().n, kDiffuse).value.x, 0.125f, 1e-5f);
}

TEST(Disney, Bsdf) {
    checkMaterial(makeDisney({}));
    EXPECT_EQ(bsdfOf(makeDisney({})).size(), 3);
    DisneyParams p;
    p.color = colour(0.7f, 0.3f, 0.2f);
    p.metallic = number(0.3f);
    p.specularTint = number(0.5f);
    p.anisotropic = number(0.8f);
    p.sheen = number(0.5f);
    p.clearcoat = number(1);
    p.clearcoatGloss = number(0.2f);
    p.specTrans = number(0.4f);
    checkMaterial(makeDisney(p));
    EXPECT_EQ(bsdfOf(makeDisney(p)).size(), 5);
    p.thin = true;
    p.flatness = number(0.5f);
    checkMaterial(makeDisney(p));
    EXPECT_EQ(bsdfOf(makeDisney(p)).size(), 6);
    EXPECT_EQ(makeDisney(p)->maxLobes(), 6);
}

TEST(Disney, Limits) {
    // A metal of that colour.
    DisneyParams p;
    p.color = colour(0.9f, 0.6f, 0.3f);
    p.metallic = number(1);
    p.roughness = number(0.1f);
    const Bsdf metal = bsdfOf(makeDisney(p));
    EXPECT_EQ(metal.size(), 1);
    expectClose(meanWeight(metal, metal.frame().n).value, Rgb(0.9f, 0.6f, 0.3f), 5e-3f);
    // Glass: the square root of the colour at each boundary.
    p.metallic = number(0);
    p.specTrans = number(1);
    p.roughness = number(0.05f);
    const Bsdf glass = bsdfOf(makeDisney(p));
    EXPECT_EQ(glass.size(), 2);
    EXPECT_NEAR(meanWeight(glass, glass.frame().n).value.x, 0.04f + 0.96f * std::sqrt(0.9f), 3e-3f);
    p.eta = number(1);
    EXPECT_NEAR(weightAtNormal(makeDisney(p), kSpecular), std::sqrt(0.9f), 1e-4f);
    // A thin sheet splits its diffuse light between both sides.
    DisneyParams sheet;
    sheet.thin = true;
    sheet.roughness = number(0);
    sheet.diffTrans = number(0.5f);
    const Bsdf paper = bsdfOf(makeDisney(sheet));
    constexpr LobeFlags kThrough = LobeFlags::Diffuse | LobeFlags::Transmission;
    constexpr LobeFlags kBack = LobeFlags::Diffuse | LobeFlags::Reflection;
    EXPECT_NEAR(meanWeight(paper, paper.frame().n, kThrough).value.x, 0.125f, 1e-4f);
    EXPECT_NEAR(meanWeight(paper, paper.frame().n, kBack).value.x, 0.375f * 41 / 42, 1e-3f);
}

TEST(Disney, WhiteGainsLittleAtGrazingAngles) {
    // Burley's sum of fits does not conserve energy. This is how far it goes, and where.
    for (const float roughness : {0.1f, 0.5f, 1.f}) {
        DisneyParams p;
        p.color = colour(1, 1, 1);
        p.roughness = number(roughness);
        const Bsdf bsdf = bsdfOf(makeDisney(p));
        for (const float c : {0.05f, 0.2f, 0.5f, 0.8f, 1.f}) {
            const float total = meanWeight(bsdf, bsdf.frame().toWorld(direction(c))).value.x;
            EXPECT_LE(total, c >= 0.5f ? 1.1f : 1.6f) << roughness << " " << c;
        }
    }
}

TEST(Hair, Bsdf) {
    const auto at = [](const HairParams& p, float v) {
        const Frame frame = Frame::fromNormal(normalize(Vec3(-0.2f, 0.6f, 0.4f)));
        Bsdf bsdf(frame, frame.n);
        TextureContext context;
        context.uv = Vec2(0.5f, v);
        makeHair(p)->addLobes(context, Rgb(1.f), bsdf);
        return bsdf;
    };
    HairParams clear;
    clear.sigmaA = colour(0, 0, 0);
    for (const float v : {0.1f, 0.5f}) {
        const Bsdf bsdf = at(clear, v);
        checkBsdf(bsdf, LobeFlags::NonSpecular, {0.8f, -0.3f});
        EXPECT_NEAR(meanWeight(bsdf, bsdf.frame().n).value.x, 1, 1e-3f) << v;
    }
    // The offset runs from one edge of the fibre to the other. At the edges, no light enters the fibre.
    const Bsdf middle = at({}, 0.5f), edge = at({}, 0.00001f);
    EXPECT_GT(meanWeight(middle, middle.frame().n).value.x, meanWeight(middle, middle.frame().n).value.z);
    EXPECT_GT(meanWeight(edge, edge.frame().n).value.z, 0.8f);
}

TEST(Hair, Absorption) {
    expectClose(hairAbsorptionOfPigments(1.3f, 0), Rgb(0.5447f, 0.9061f, 1.781f), 1e-5f);
    expectClose(hairAbsorptionOfPigments(0, 2), Rgb(0.374f, 0.8f, 2.1f), 1e-5f);
    // At betaN = 0: (ln c / 5.969)^2; white absorbs nothing.
    EXPECT_NEAR(hairAbsorptionOfColor(Rgb(0.5f), 0).x, sqr(0.6931472f / 5.969f), 1e-7f);
    EXPECT_EQ(hairAbsorptionOfColor(Rgb(1.f), 0.3f), Rgb(0.f));
    EXPECT_TRUE(isFinite(hairAbsorptionOfColor(Rgb(0.f), 0.3f)));
    // At betaN = 1 the coefficients add up to 3.375.
    EXPECT_NEAR(hairAbsorptionOfColor(Rgb(0.5f), 1).x, sqr(0.6931472f / 3.375f), 1e-6f);
}

TEST(Mix, Bsdf) {
    MixParams p;
    p.first = makeMatte({});
    p.second = makeMirror({});
    checkMaterial(makeMix(p));
    p.amount = colour(0.25f, 0.25f, 0.25f);
    EXPECT_NEAR(weightAtNormal(makeMix(p), LobeFlags::NonSpecular), 0.125f, 1e-5f);
    EXPECT_NEAR(weightAtNormal(makeMix(p), kSpecular), 0.675f, 1e-5f);
    p.amount = colour(1.5f, 1.5f, 1.5f);  // the amount itself is not clamped, the rest (1 - amount) is
    EXPECT_NEAR(weightAtNormal(makeMix(p)), 0.75f, 1e-5f);
}

TEST(Material, BumpBelongsToTheFirstOfAMix) {
    const FloatTexturePtr bump = number(1);
    MixParams p;
    p.first = makeMatte({.kd = {}, .sigma = {}, .relief = bump});
    p.second = makeMirror({});
    EXPECT_EQ(makeMix(p)->relief().heights, bump);
    EXPECT_EQ(makeGlass({})->relief().heights, nullptr);
}

TEST(Material, IsConstantUnlessATextureVaries) {
    checkConstancy<MatteParams>(makeMatte, {}, &MatteParams::kd, &MatteParams::sigma);
    checkConstancy<PlasticParams>(makePlastic, {}, &PlasticParams::kd, &PlasticParams::ks, &PlasticParams::roughness);
    checkConstancy<MetalParams>(makeMetal, {}, &MetalParams::eta, &MetalParams::k, &MetalParams::roughness,
                                &MetalParams::uRoughness, &MetalParams::vRoughness);
    checkConstancy<MirrorParams>(makeMirror, {}, &MirrorParams::kr);
    checkConstancy<GlassParams>(makeGlass, {}, &GlassParams::kr, &GlassParams::kt, &GlassParams::eta,
                                &GlassParams::uRoughness, &GlassParams::vRoughness);
    checkConstancy<UberParams>(makeUber, {}, &UberParams::kd, &UberParams::ks, &UberParams::kr, &UberParams::kt,
                               &UberParams::opacity, &UberParams::roughness, &UberParams::uRoughness,
                               &UberParams::vRoughness, &UberParams::eta);
    checkConstancy<SubstrateParams>(makeSubstrate, {}, &SubstrateParams::kd, &SubstrateParams::ks,
                                    &SubstrateParams::uRoughness, &SubstrateParams::vRoughness);
    checkConstancy<TranslucentParams>(makeTranslucent, {}, &TranslucentParams::kd, &TranslucentParams::ks,
                                      &TranslucentParams::reflect, &TranslucentParams::transmit,
                                      &TranslucentParams::roughness);
    checkConstancy<DisneyParams>(makeDisney, {}, &DisneyParams::color, &DisneyParams::metallic, &DisneyParams::eta,
                                 &DisneyParams::roughness, &DisneyParams::specularTint, &DisneyParams::anisotropic,
                                 &DisneyParams::sheen, &DisneyParams::sheenTint, &DisneyParams::clearcoat,
                                 &DisneyParams::clearcoatGloss, &DisneyParams::specTrans, &DisneyParams::flatness,
                                 &DisneyParams::diffTrans);
    EXPECT_FALSE(makeHair({})->isConstant());
    const MaterialPtr plain = makeMatte({});
    const MaterialPtr textured = makeMatte({.kd = std::make_shared<VaryingColour>(), .sigma = {}, .relief = {}});
    checkConstancy<MixParams>(makeMix, {plain, plain, {}}, &MixParams::amount);
    EXPECT_FALSE(makeMix({plain, textured, {}})->isConstant());
    EXPECT_FALSE(makeMix({textured, plain, {}})->isConstant());
}

}  // namespace
}  // namespace drc
