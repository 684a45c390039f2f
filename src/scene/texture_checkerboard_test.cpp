#include "scene/texture_checkerboard.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

TEST(Checkerboard, Alternates) {
    const auto c = [](float x) -> FloatTexturePtr { return std::make_shared<ConstantTexture<float>>(x); };
    const auto at = [&](float u, float v, const UvMapping& mapping) {
        TextureContext context;
        context.uv = Vec2(u, v);
        return makeCheckerboardTexture<float>(c(1), c(0), mapping)->eval(context);
    };
    EXPECT_EQ(at(0.5f, 0.5f, {}), 1);
    EXPECT_EQ(at(1.5f, 0.5f, {}), 0);
    EXPECT_EQ(at(1.5f, 1.5f, {}), 1);
    EXPECT_EQ(at(-0.5f, 0.5f, {}), 0);
    EXPECT_EQ(at(-0.5f, -0.5f, {}), 1);
    EXPECT_EQ(at(0.15f, 0.05f, {10, 10, 0, 0}), 0);
    EXPECT_EQ(at(0.15f, 0.05f, {10, 10, 1, 0}), 1);
}

}  // namespace
}  // namespace drc
