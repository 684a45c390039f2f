#include "scene/textures/texture_noise.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

TextureContext contextAt(const Vec3& p, float width = 0) {
    TextureContext at;
    at.p = p;
    at.dpdx = Vec3(width, 0, 0);
    at.dpdy = Vec3(0, width, 0);
    return at;
}

const Vec3 kPoint(1.3f, 0.4f, -2.2f);
const Vec3 kNone(0.f);

TEST(NoiseTextures, LookUpInTheTexturesSpaceWithTheFootprintThere) {
    const Mapping3D twice(Transform::scale(2, 2, 2));
    const NoiseSum sum{4, 0.6f};
    const Vec3 dx(0.1f, 0, 0), dy(0, 0.1f, 0);
    EXPECT_EQ(makeFbmTexture<float>(sum, twice)->eval(contextAt(kPoint, 0.05f)), fbm(kPoint * 2.f, dx, dy, sum));
    EXPECT_EQ(makeWrinkledTexture<float>(sum, twice)->eval(contextAt(kPoint, 0.05f)),
              turbulence(kPoint * 2.f, dx, dy, sum));
    EXPECT_EQ(makeFbmTexture<Rgb>(sum, twice)->eval(contextAt(kPoint)), Rgb(fbm(kPoint * 2.f, kNone, kNone, sum)));
    EXPECT_FALSE(makeFbmTexture<Rgb>(sum, twice)->isConstant());
}

TEST(NoiseTextures, WindyIsWavesTimesWind) {
    const float wind = std::abs(fbm(kPoint * 0.1f, kNone, kNone, {3, 0.5f}));
    EXPECT_EQ(makeWindyTexture<float>(Mapping3D())->eval(contextAt(kPoint)),
              wind * fbm(kPoint, kNone, kNone, {6, 0.5f}));
    EXPECT_GT(wind, 0);
}

}  // namespace
}  // namespace drc
