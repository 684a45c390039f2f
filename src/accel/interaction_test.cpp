#include "accel/interaction.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

// Height 0.6 u - 0.8 v.
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
    // 0.6 a half unit of u a metre, -0.8 a quarter of v.
    const Vec3 right = hit.bumped(shading, Slope(), hit.textureContext()).n;
    EXPECT_LT(length(right - normalize(Vec3(-0.3f, 0.2f, 1))), 1e-4f);
    // As pbrt-v3 has it: the other way, by 0.6 and 0.8.
    hit.bumpTangents = BumpTangents::OppositeUnit;
    const Vec3 inverted = hit.bumped(shading, Slope(), hit.textureContext()).n;
    EXPECT_LT(length(inverted - normalize(Vec3(0.6f, -0.8f, 1))), 1e-4f);
}

// What a texture is that is averaged away within a footprint.
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
    EXPECT_EQ(hit.bumped(shading, FineSlope(), hit.textureContext()).n, shading.n);
    hit.coneSpread = 0.1f;
    EXPECT_LT(length(hit.bumped(shading, FineSlope(), hit.textureContext()).n - normalize(Vec3(-1, 0, 1))), 1e-3f);
}

}  // namespace
}  // namespace drc
