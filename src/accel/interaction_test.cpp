#include "accel/interaction.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

// A texture with the height 0.6 u - 0.8 v.
class Slope final : public FloatTexture {
  public:
    float eval(const TextureContext& at) const override { return 0.6f * at.uv.x - 0.8f * at.uv.y; }
};

TEST(SurfaceInteraction, BumpsGoAlongTheTangentsOfTheMesh) {
    SurfaceInteraction hit;
    hit.ng = hit.ns = Vec3(0, 0, 1);
    hit.dpdu = hit.tangent = Vec3(2, 0, 0);
    hit.dpdv = Vec3(0, 4, 0);
    const Frame shading = Frame::fromNormalAndTangent(hit.ns, hit.tangent);
    // The height changes by 0.6 per half unit of u per metre, and by -0.8 per quarter unit of v per metre.
    const Vec3 right = hit.withRelief(shading, Relief(std::make_shared<Slope>()), hit.textureContext()).n;
    EXPECT_LT(length(right - normalize(Vec3(-0.3f, 0.2f, 1))), 1e-4f);
    // As in pbrt-v3: in the opposite direction, with the slopes 0.6 and 0.8.
    hit.bumpTangents = BumpTangents::OppositeUnit;
    const Vec3 inverted = hit.withRelief(shading, Relief(std::make_shared<Slope>()), hit.textureContext()).n;
    EXPECT_LT(length(inverted - normalize(Vec3(0.6f, -0.8f, 1))), 1e-4f);
}

// A texture that averages out when the footprint is larger than its details.
class FineSlope final : public FloatTexture {
  public:
    float eval(const TextureContext& at) const override {
        const bool sharp = at.footprint == 0 && at.duvdx == Vec2(0, 0) && at.dpdy == Vec3(0, 0, 0);
        return sharp ? at.uv.x : 0;
    }
};

TEST(SurfaceInteraction, BumpsAreNotAveragedOverWideCones) {
    SurfaceInteraction hit;
    hit.ng = hit.ns = hit.wo = Vec3(0, 0, 1);
    hit.dpdu = hit.tangent = Vec3(1, 0, 0);
    hit.dpdv = Vec3(0, 1, 0);
    hit.footprint = 0.3f;
    const Frame shading;
    hit.coneSpread = 0.01f;
    EXPECT_EQ(hit.withRelief(shading, Relief(std::make_shared<FineSlope>()), hit.textureContext()).n, shading.n);
    hit.coneSpread = 0.1f;
    EXPECT_LT(length(hit.withRelief(shading, Relief(std::make_shared<FineSlope>()), hit.textureContext()).n -
                     normalize(Vec3(-1, 0, 1))),
              1e-3f);
}

class White final : public Material {
  public:
    void addLobes(const TextureContext&, const Rgb& weight, Bsdf& bsdf) const override {
        bsdf.add(LambertReflection(Rgb(1.f)), weight);
    }
    bool isConstant() const override { return true; }
    int maxLobes() const override { return 1; }
};

// By the normals of the mesh and by relief; with lobes computed in advance or not.
TEST(SurfaceInteraction, NormalsAreBentForViewsBelowThem) {
    SurfaceInteraction hit;
    hit.ng = Vec3(0, 0, 1);
    hit.dpdu = hit.tangent = Vec3(1, 0, 0);
    hit.dpdv = Vec3(0, 1, 0);
    const Vec3 leaning = normalize(Vec3(0.6f, 0, 0.8f));
    for (const bool relief : {false, true})
        for (const bool inAdvance : {false, true}) {
            const auto white = std::make_shared<White>();
            if (relief) white->setRelief(Relief(std::make_shared<Slope>()));
            Primitive primitive;
            primitive.material = white;
            hit.primitive = &primitive;
            Bsdf lobes;
            white->addLobes({}, Rgb(1.f), lobes);
            hit.lobes = inAdvance ? &lobes : nullptr;
            hit.ns = relief ? hit.ng : leaning;
            const float side = relief ? 1.f : -1.f;  // the relief leans by -0.6, 0.8
            hit.wo = normalize(Vec3(side, 0, 0.05f));
            EXPECT_TRUE(hit.bsdf().bentForView());
            EXPECT_GT(dot(hit.bsdf().frame().n, hit.wo), 0);
            EXPECT_GT(luminance(hit.bsdf().f(hit.wo, hit.ng)), 0);
            hit.wo = normalize(Vec3(side, 0, 2));
            EXPECT_FALSE(hit.bsdf().bentForView());
            if (relief) continue;
            EXPECT_EQ(hit.bsdf().frame().n, leaning);
        }
}

}  // namespace
}  // namespace drc
