#include "scene/textures/texture_mix.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

FloatTexturePtr number(float x) { return constantTexture(x); }

struct U final : FloatTexture {
    float eval(const TextureContext& at) const override { return at.uv.x; }
};

TEST(MixTexture, Blends) {
    EXPECT_NEAR(makeMixTexture<float>(number(1), number(5), number(0.25f))->eval({}), 2, 1e-6f);
    const RgbTexturePtr red = constantTexture(Rgb(1, 0, 0)), blue = constantTexture(Rgb(0, 0, 1));
    EXPECT_EQ(makeMixTexture<Rgb>(red, blue, number(0.25f))->eval({}), Rgb(0.75f, 0, 0.25f));
    TextureContext at;
    at.uv = Vec2(0.75f, 0);
    const FloatTexturePtr u = std::make_shared<U>();
    EXPECT_NEAR(makeMixTexture<float>(number(2), number(4), u)->eval(at), 3.5f, 1e-6f);
    EXPECT_NEAR(makeMixTexture<float>(u, number(1), number(0.5f))->eval(at), 0.875f, 1e-6f);
}

TEST(MixTexture, IsAsSimpleAsItsParts) {
    const FloatTexturePtr u = std::make_shared<U>();
    EXPECT_TRUE(makeMixTexture<float>(number(1), number(5), number(0.25f))->isConstant());
    EXPECT_TRUE(makeMixTexture<float>(number(5), number(5), u)->isConstant());
    EXPECT_FALSE(makeMixTexture<float>(number(1), number(5), u)->isConstant());
    EXPECT_FALSE(makeMixTexture<float>(u, number(5), number(0.25f))->isConstant());
    EXPECT_EQ(makeMixTexture<float>(u, number(5), number(0)), u);
    EXPECT_EQ(makeMixTexture<float>(number(5), u, number(1)), u);
}

}  // namespace
}  // namespace drc
