#include "scene/bsdf_testing.h"
#include "scene/material_glass.h"
#include "scene/material_matte.h"
#include "scene/material_metal.h"
#include "scene/material_mirror.h"
#include "scene/material_mix.h"
#include "scene/material_plastic.h"
#include "scene/material_substrate.h"
#include "scene/material_translucent.h"
#include "scene/material_uber.h"

namespace drc {
namespace {

using namespace test;

constexpr LobeFlags kSpecular = LobeFlags::Specular | LobeFlags::Reflection | LobeFlags::Transmission;

RgbTexturePtr colour(float r, float g, float b) { return std::make_shared<ConstantTexture<Rgb>>(Rgb(r, g, b)); }
FloatTexturePtr number(float x) { return std::make_shared<ConstantTexture<float>>(x); }

Bsdf bsdfOf(const MaterialPtr& material, const Rgb& weight = Rgb(1.f)) {
    const Frame frame = Frame::fromNormal(normalize(Vec3(-0.2f, 0.6f, 0.4f)));
    Bsdf bsdf(frame, frame.n);
    material->addLobes(TextureContext{}, weight, bsdf);
    return bsdf;
}

void checkMaterial(const MaterialPtr& material) {
    const Bsdf bsdf = bsdfOf(material);
    ASSERT_GT(bsdf.size(), 0);
    if (bsdf.hasNonSpecular()) {
        checkBsdf(bsdf, LobeFlags::NonSpecular, {0.9f, -0.3f});
        checkUnbiased(bsdf);
    }
    if (bsdf.hasNonSpecular() && bsdf.hasSpecular()) checkBsdf(bsdf, LobeFlags::All, {0.6f});
    checkBsdfEnergy(bsdf);
    // A weight scales everything.
    const Vec3 wo = bsdf.frame().toWorld(direction(0.7f));
    expectClose(meanWeight(bsdfOf(material, Rgb(0.5f)), wo).value, meanWeight(bsdf, wo).value * 0.5f, 1e-4f, "weight");
}

float weightAtNormal(const MaterialPtr& material, LobeFlags mask = LobeFlags::All) {
    const Bsdf bsdf = bsdfOf(material);
    return meanWeight(bsdf, bsdf.frame().n, mask).value.x;
}

TEST(Matte, Bsdf) {
    checkMaterial(makeMatte({}));
    checkMaterial(makeMatte({.kd = colour(0.2f, 0.5f, 0.8f), .sigma = number(25), .bump = {}}));
    EXPECT_NEAR(weightAtNormal(makeMatte({})), 0.5f, 1e-5f);
    EXPECT_EQ(bsdfOf(makeMatte({.kd = colour(0, 0, 0), .sigma = {}, .bump = {}})).size(), 0);
}

TEST(Plastic, Bsdf) {
    PlasticParams p;
    checkMaterial(makePlastic(p));
    EXPECT_EQ(bsdfOf(makePlastic(p)).size(), 2);
    p.ks = colour(0, 0, 0);
    EXPECT_EQ(bsdfOf(makePlastic(p)).size(), 1);
    // The highlight is total beyond the critical angle, as pbrt has it.
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
    EXPECT_TRUE(bsdfOf(makeGlass(p)).hasWideTransmission());
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
    EXPECT_TRUE(bsdf.hasWideTransmission());
    constexpr LobeFlags kDiffuse = LobeFlags::Diffuse | LobeFlags::Transmission;
    EXPECT_NEAR(meanWeight(bsdf, bsdf.frame().n, kDiffuse).value.x, 0.125f, 1e-5f);
}

TEST(Mix, Bsdf) {
    MixParams p;
    p.first = makeMatte({});
    p.second = makeMirror({});
    checkMaterial(makeMix(p));
    p.amount = colour(0.25f, 0.25f, 0.25f);
    EXPECT_NEAR(weightAtNormal(makeMix(p), LobeFlags::NonSpecular), 0.125f, 1e-5f);
    EXPECT_NEAR(weightAtNormal(makeMix(p), kSpecular), 0.675f, 1e-5f);
    p.amount = colour(1.5f, 1.5f, 1.5f);  // the rest is clamped, the amount is not
    EXPECT_NEAR(weightAtNormal(makeMix(p)), 0.75f, 1e-5f);
}

TEST(Material, BumpBelongsToTheFirstOfAMix) {
    const FloatTexturePtr bump = number(1);
    MixParams p;
    p.first = makeMatte({.kd = {}, .sigma = {}, .bump = bump});
    p.second = makeMirror({});
    EXPECT_EQ(makeMix(p)->bump(), bump.get());
    EXPECT_EQ(makeGlass({})->bump(), nullptr);
}

struct VaryingColour final : RgbTexture {
    Rgb eval(const TextureContext& at) const override { return Rgb(at.uv.x); }
};
struct VaryingNumber final : FloatTexture {
    float eval(const TextureContext& at) const override { return at.uv.x; }
};

// Constant as it is, and not with any one of these parameters varied.
template <typename Params, typename... Members>
void checkConstancy(MaterialPtr (*make)(Params), const Params& params, Members... members) {
    EXPECT_TRUE(make(params)->isConstant());
    int i = 0;
    const auto vary = [&](auto member) {
        Params varied = params;
        if constexpr (requires { varied.*member = std::make_shared<VaryingColour>(); })
            varied.*member = std::make_shared<VaryingColour>();
        else
            varied.*member = std::make_shared<VaryingNumber>();
        EXPECT_FALSE(make(varied)->isConstant()) << "parameter " << i;
        ++i;
    };
    (vary(members), ...);
    // A bump map turns the frame and leaves the lobes.
    if constexpr (requires { params.bump; }) {
        Params bumpy = params;
        bumpy.bump = std::make_shared<VaryingNumber>();
        EXPECT_TRUE(make(bumpy)->isConstant());
    }
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
    const MaterialPtr plain = makeMatte({});
    const MaterialPtr textured = makeMatte({.kd = std::make_shared<VaryingColour>(), .sigma = {}, .bump = {}});
    checkConstancy<MixParams>(makeMix, {plain, plain, {}}, &MixParams::amount);
    EXPECT_FALSE(makeMix({plain, textured, {}})->isConstant());
    EXPECT_FALSE(makeMix({textured, plain, {}})->isConstant());
}

}  // namespace
}  // namespace drc
