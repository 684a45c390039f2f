#include "scene/textures/texture_bilerp.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

TEST(Bilerp, Interpolates) {
    const auto texture = makeBilerpTexture<float>({1, 2, 3, 6}, UvMapping{});
    const auto at = [&](float s, float t) {
        TextureContext context;
        context.uv = Vec2(s, t);
        return texture->eval(context);
    };
    EXPECT_EQ(at(0, 0), 1);
    EXPECT_EQ(at(0, 1), 2);
    EXPECT_EQ(at(1, 0), 3);
    EXPECT_EQ(at(1, 1), 6);
    EXPECT_NEAR(at(0.5f, 0.5f), 3, 1e-6f);
    EXPECT_NEAR(at(0.25f, 0), 1.5f, 1e-6f);
    EXPECT_FALSE(texture->isConstant());
}

TEST(Bilerp, OfOneValueIsConstant) {
    const Rgb c(1, 2, 3);
    EXPECT_TRUE(makeBilerpTexture<Rgb>({c, c, c, c}, UvMapping{})->isConstant());
    EXPECT_FALSE(makeBilerpTexture<Rgb>({c, c, c, Rgb(0.f)}, UvMapping{})->isConstant());
}

}  // namespace
}  // namespace drc
