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

}  // namespace
}  // namespace drc
