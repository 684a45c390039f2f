#include "scene/materials/material_principled.h"

#include "scene/materials/material_testing.h"

namespace drc {
namespace {

using namespace test;

PrincipledParams white() {
    PrincipledParams p;
    p.baseColor = colour(1, 1, 1);
    return p;
}

struct Case {
    const char* name;
    PrincipledParams params;
};
std::vector<Case> cases() {
    std::vector<Case> all;
    const auto add = [&](const char* name, auto&& change) {
        PrincipledParams p = white();
        change(p);
        all.push_back({name, p});
    };
    add("plastic", [](PrincipledParams& p) { p.baseColor = colour(0.8f, 0.3f, 0.1f); });
    add("rough metal", [](PrincipledParams& p) {
        p.metallic = number(1);
        p.roughness = number(1);
    });
    add("brushed gold", [](PrincipledParams& p) {
        p.baseColor = colour(1, 0.7f, 0.3f);
        p.metallic = number(1);
        p.specularTint = colour(0.6f, 0.8f, 1);
        p.anisotropic = number(0.6f);
        p.anisotropicRotation = number(0.15f);
        p.roughness = number(0.4f);
    });
    add("mirror", [](PrincipledParams& p) {
        p.metallic = number(1);
        p.roughness = number(0);
    });
    add("frosted glass", [](PrincipledParams& p) {
        p.transmission = number(1);
        p.roughness = number(0.6f);
    });
    add("clear tinted glass", [](PrincipledParams& p) {
        p.transmission = number(1);
        p.roughness = number(0);
        p.specularTint = colour(0.5f, 1, 1);
    });
    add("frosted pane", [](PrincipledParams& p) {
        p.transmission = number(1);
        p.roughness = number(0.6f);
        p.thinWall = true;
    });
    add("clear glass with red reflections", [](PrincipledParams& p) {
        p.transmission = number(1);
        p.roughness = number(0);
        p.reflectionTint = colour(1, 1, 0.3f);
    });
    add("frosted glass with red reflections", [](PrincipledParams& p) {
        p.transmission = number(1);
        p.roughness = number(0.5f);
        p.reflectionTint = colour(0.9f, 1, 0.3f);
    });
    add("rough base", [](PrincipledParams& p) {
        p.diffuseRoughness = number(1);
        p.roughness = number(0.6f);
    });
    add("rough plaster", [](PrincipledParams& p) {
        p.diffuseRoughness = number(0.7f);
        p.specularLevel = number(0);
    });
    add("clear pane", [](PrincipledParams& p) {
        p.transmission = number(1);
        p.roughness = number(0);
        p.thinWall = true;
    });
    add("paper", [](PrincipledParams& p) {
        p.subsurface = number(1);
        p.thinWall = true;
    });
    add("car paint", [](PrincipledParams& p) {
        p.metallic = number(0.5f);
        p.coat = number(1);
        p.coatTint = colour(0.9f, 0.5f, 0.4f);
    });
    add("rough coat on rough metal", [](PrincipledParams& p) {
        p.metallic = number(1);
        p.roughness = number(0.8f);
        p.coat = number(1);
        p.coatRoughness = number(0.5f);
        p.coatIor = number(2);
    });
    add("velvet", [](PrincipledParams& p) {
        p.sheen = number(1);
        p.sheenRoughness = number(0.4f);
        p.roughness = number(0.9f);
    });
    add("everything", [](PrincipledParams& p) {
        p.metallic = number(0.3f);
        p.transmission = number(0.4f);
        p.coat = number(0.5f);
        p.coatRoughness = number(0.3f);
        p.sheen = number(0.7f);
        p.roughness = number(0.5f);
        p.specularLevel = number(1);
        p.thinWall = true;
        p.subsurface = number(0.5f);
    });
    return all;
}

TEST(Principled, Bsdf) {
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        checkMaterial(makePrincipled(c.params), Furnace::OfRadiance);
    }
}

// All light that a white surface does not absorb comes back, from every direction of view. Glossy lobes below layers
// lose a little (see LayersAbove), and a rough pane most, near the horizon:
// its two lobes see facets of different widths.
TEST(Principled, WhiteLosesLittle) {
    const auto least = [](const std::string& name) {
        if (name == "rough metal" || name == "mirror" || name == "paper" || name == "velvet" || name == "clear pane")
            return 0.99f;
        return name == "frosted pane" ? 0.77f : 0.87f;
    };
    for (const Case& c : cases()) {
        const std::string name = c.name;
        if (name == "plastic" || name == "brushed gold" || name == "car paint") continue;  // not white
        const Bsdf bsdf = bsdfOf(makePrincipled(c.params));
        for (const float cosine : {0.1f, 0.3f, 0.7f, 0.98f}) {
            const Mean all = albedoBySamples(bsdf, bsdf.frame().toWorld(direction(cosine)), Furnace::OfRadiance,
                                             LobeFlags::All, 60000);
            EXPECT_GE(all.value.y, least(name) - 3 * all.error) << name << " " << cosine;
        }
    }
}

TEST(Principled, HandComputed) {
    // A dielectric of index 1.5 reflects 4 % along the normal, whatever its roughness; the base gets the rest.
    PrincipledParams p;
    p.baseColor = colour(0.6f, 0.3f, 0);
    p.roughness = number(0);
    EXPECT_NEAR(weightAtNormal(makePrincipled(p), kSpecular), 0.04f, 1e-4f);
    EXPECT_NEAR(weightAtNormal(makePrincipled(p), LobeFlags::NonSpecular), 0.96f * 0.6f, 1e-3f);
    // Twice the level, twice the reflectance; a level of 0 leaves a Lambertian base.
    p.specularLevel = number(1);
    EXPECT_NEAR(weightAtNormal(makePrincipled(p), kSpecular), 0.08f, 1e-4f);
    p.specularLevel = number(0);
    EXPECT_EQ(bsdfOf(makePrincipled(p)).size(), 1);
    EXPECT_NEAR(weightAtNormal(makePrincipled(p)), 0.6f, 1e-4f);
    // A coat of index 1.5 and the tint below: 4 %, and of the rest the tint.
    p.coat = number(1);
    p.coatRoughness = number(0);
    p.coatTint = colour(0.5f, 1, 1);
    EXPECT_NEAR(weightAtNormal(makePrincipled(p), kSpecular), 0.04f, 1e-4f);
    const Bsdf coated = bsdfOf(makePrincipled(p));
    const Rgb f = coated.f(coated.frame().n, coated.frame().n);
    EXPECT_NEAR(f.x / f.y, 0.5f * 2, 1e-4f);
    // Metal: the base colour along the normal; the edge's tint at a cosine of 1/7.
    PrincipledParams metal;
    metal.baseColor = colour(0.9f, 0.6f, 0.3f);
    metal.metallic = number(1);
    metal.roughness = number(0);
    metal.specularTint = colour(1, 0.5f, 0);
    const Bsdf gold = bsdfOf(makePrincipled(metal));
    expectClose(meanWeight(gold, gold.frame().n).value, Rgb(0.9f, 0.6f, 0.3f), 1e-4f);
    const Rgb schlick = fresnelSchlick(1.f / 7, Rgb(0.9f, 0.6f, 0.3f));
    expectClose(meanWeight(gold, gold.frame().toWorld(direction(1.f / 7))).value, schlick * Rgb(1, 0.5f, 0), 1e-4f,
                "edge", 1e-2f);
    // Smooth glass, with the root of its colour for each boundary.
    PrincipledParams glass;
    glass.baseColor = colour(0.25f, 0.25f, 0.25f);
    glass.transmission = number(1);
    glass.roughness = number(0);
    EXPECT_NEAR(weightAtNormal(makePrincipled(glass)), 0.04f + 0.96f * 0.5f, 1e-3f);
    // Its reflections may be tinted.
    glass.reflectionTint = colour(0.5f, 0.5f, 0.5f);
    EXPECT_NEAR(weightAtNormal(makePrincipled(glass)), 0.02f + 0.96f * 0.5f, 1e-3f);
    // A pane: both faces reflect, 2 R / (1 + R), and light crosses it once, with the whole colour.
    glass.thinWall = true;
    EXPECT_NEAR(weightAtNormal(makePrincipled(glass)), 0.08f / 1.04f + (1 - 0.08f / 1.04f) * 0.25f, 1e-3f);
}

TEST(Principled, SubsurfaceLeavesAThinWallOnBothSides) {
    PrincipledParams p = white();
    p.thinWall = true;
    p.specularLevel = number(0);
    constexpr LobeFlags kThrough = LobeFlags::Diffuse | LobeFlags::Transmission;
    EXPECT_EQ(weightAtNormal(makePrincipled(p), kThrough), 0);
    p.subsurface = number(0.6f);
    EXPECT_NEAR(weightAtNormal(makePrincipled(p), kThrough), 0.3f, 1e-3f);
    EXPECT_NEAR(weightAtNormal(makePrincipled(p)), 1, 1e-3f);
}

TEST(Principled, ARoughBaseAloneIsRoughDiffuse) {
    PrincipledParams p;
    p.baseColor = colour(0.6f, 0.3f, 0.1f);
    p.specularLevel = number(0);
    p.diffuseRoughness = number(0.8f);
    const Bsdf bsdf = bsdfOf(makePrincipled(p));
    for (const float azimuth : {0.f, 1.f, 3.f}) {
        const Vec3 wo = direction(0.2f), wi = direction(0.4f, azimuth);
        Rgb expected(0.f);
        for (const DiffusePart part : {DiffusePart::Separable, DiffusePart::Rest})
            expected += RoughDiffuse(Rgb(0.6f, 0.3f, 0.1f), 0.8f, part).f(wo, wi);
        expectClose(bsdf.f(bsdf.frame().toWorld(wo), bsdf.frame().toWorld(wi)), expected, 1e-5f);
    }
}

TEST(Principled, AnisotropyTurnsWithItsRotation) {
    PrincipledParams p = white();
    p.metallic = number(1);
    p.anisotropic = number(0.9f);
    const auto f = [&](float rotation, float phi) {
        p.anisotropicRotation = number(rotation);
        const Bsdf bsdf = bsdfOf(makePrincipled(p));
        return bsdf.f(bsdf.frame().n, bsdf.frame().toWorld(direction(0.8f, phi))).x;
    };
    // Highlights are long along the tangent, s.
    EXPECT_GT(f(0, 0), 2 * f(0, kPi / 2));
    EXPECT_NEAR(f(0, 0.3f), f(0.125f, 0.3f + kPi / 4), 1e-4f);
}

TEST(Principled, ParametersOutOfRangeAreTakenAsTheNearestInRange) {
    PrincipledParams wild = white(), tame = white();
    wild.baseColor = colour(2, -1, 0.5f);
    tame.baseColor = colour(1, 0, 0.5f);
    wild.coat = number(3);
    tame.coat = number(1);
    wild.sheen = number(-1);
    const Bsdf a = bsdfOf(makePrincipled(wild)), b = bsdfOf(makePrincipled(tame));
    const Vec3 wo = a.frame().toWorld(direction(0.4f));
    EXPECT_EQ(a.f(wo, a.frame().n), b.f(wo, b.frame().n));
    EXPECT_EQ(a.size(), b.size());
}

TEST(Principled, CountsItsLobes) {
    PrincipledParams p;
    EXPECT_EQ(makePrincipled(p)->maxLobes(), 2);
    p.metallic = number(1);
    EXPECT_EQ(makePrincipled(p)->maxLobes(), 1);
    p.metallic = std::make_shared<VaryingNumber>();
    p.transmission = number(0.5f);
    p.coat = number(0.5f);
    p.sheen = number(0.5f);
    EXPECT_EQ(makePrincipled(p)->maxLobes(), 6);
    p.specularTint = colour(0.5f, 1, 1);
    EXPECT_EQ(makePrincipled(p)->maxLobes(), 7);  // smooth tinted glass reflects and refracts in two lobes
}

TEST(Principled, IsConstantUnlessATextureVaries) {
    using P = PrincipledParams;
    checkConstancy<P>(makePrincipled, {}, &P::baseColor, &P::metallic, &P::roughness, &P::diffuseRoughness, &P::ior,
                      &P::specularLevel, &P::specularTint, &P::anisotropic, &P::anisotropicRotation, &P::transmission,
                      &P::reflectionTint, &P::coat, &P::coatRoughness, &P::coatIor, &P::coatTint, &P::sheen,
                      &P::sheenRoughness, &P::sheenTint, &P::subsurface);
}

}  // namespace
}  // namespace drc
