#include "scene/textures/texture_scale.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

struct U final : FloatTexture {
    float eval(const TextureContext& at) const override { return at.uv.x; }
};

TEST(ScaleTexture, Multiplies) {
    const RgbTexturePtr t = makeScaleTexture<Rgb>(constantTexture(Rgb(1, 2, 3)), constantTexture(Rgb(2, 0.5f, 0)));
    EXPECT_EQ(t->eval({}), Rgb(2, 1, 0));
    EXPECT_TRUE(t->isConstant());
    TextureContext at;
    at.uv = Vec2(3, 0);
    const FloatTexturePtr u = std::make_shared<U>(), two = constantTexture(2.f);
    EXPECT_EQ(makeScaleTexture<float>(u, u)->eval(at), 9);
    EXPECT_EQ(makeScaleTexture<float>(u, two)->eval(at), 6);
    EXPECT_EQ(makeScaleTexture<float>(two, u)->eval(at), 6);
    EXPECT_FALSE(makeScaleTexture<float>(two, u)->isConstant());
}

TEST(ScaleTexture, ByOneIsTheOther) {
    const FloatTexturePtr u = std::make_shared<U>(), one = constantTexture(1.f);
    EXPECT_EQ(makeScaleTexture<float>(u, one), u);
    EXPECT_EQ(makeScaleTexture<float>(one, u), u);
}

}  // namespace
}  // namespace drc
