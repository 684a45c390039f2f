// Checks that every material must pass.
#pragma once
#include "scene/lobes/bsdf_testing.h"
#include "scene/materials/material.h"

namespace drc::test {

inline constexpr LobeFlags kSpecular = LobeFlags::Specular | LobeFlags::Reflection | LobeFlags::Transmission;

inline RgbTexturePtr colour(float r, float g, float b) { return std::make_shared<ConstantTexture<Rgb>>(Rgb(r, g, b)); }
inline FloatTexturePtr number(float x) { return std::make_shared<ConstantTexture<float>>(x); }

inline Bsdf bsdfOf(const MaterialPtr& material, const Rgb& weight = Rgb(1.f)) {
    const Frame frame = Frame::fromNormal(normalize(Vec3(-0.2f, 0.6f, 0.4f)));
    Bsdf bsdf(frame, frame.n);
    material->addLobes(TextureContext{}, weight, bsdf);
    return bsdf;
}

inline void checkMaterial(const MaterialPtr& material, Furnace furnace = Furnace::OfImportance) {
    const Bsdf bsdf = bsdfOf(material);
    ASSERT_GT(bsdf.size(), 0);
    EXPECT_LE(bsdf.size(), material->maxLobes());
    if (bsdf.hasNonSpecular()) {
        checkBsdf(bsdf, LobeFlags::NonSpecular, {0.9f, -0.3f});
        checkUnbiased(bsdf);
    }
    if (bsdf.hasNonSpecular() && bsdf.hasSpecular()) checkBsdf(bsdf, LobeFlags::All, {0.6f});
    checkBsdfEnergy(bsdf, furnace);
    checkBsdfReciprocity(bsdf);
    checkSpecularReciprocity(bsdf);
    checkSeparableLobes(bsdf);
    // The weight must scale everything.
    const Vec3 wo = bsdf.frame().toWorld(direction(0.7f));
    expectClose(meanWeight(bsdfOf(material, Rgb(0.5f)), wo).value, meanWeight(bsdf, wo).value * 0.5f, 1e-4f, "weight");
}

inline float weightAtNormal(const MaterialPtr& material, const LobeMask& mask = LobeFlags::All) {
    const Bsdf bsdf = bsdfOf(material);
    return meanWeight(bsdf, bsdf.frame().n, mask).value.x;
}

struct VaryingColour final : RgbTexture {
    Rgb eval(const TextureContext& at) const override { return Rgb(at.uv.x); }
};
struct VaryingNumber final : FloatTexture {
    float eval(const TextureContext& at) const override { return at.uv.x; }
};

// Checks isConstant(): true for the given parameters, and false if any one of the listed members varies.
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
    // A bump map changes the frame but not the lobes.
    if constexpr (requires { params.relief; }) {
        Params bumpy = params;
        bumpy.relief = Relief(std::make_shared<VaryingNumber>());
        EXPECT_TRUE(make(bumpy)->isConstant());
    }
}

}  // namespace drc::test
