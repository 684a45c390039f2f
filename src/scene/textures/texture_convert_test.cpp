#include "scene/textures/texture_convert.h"

#include <gtest/gtest.h>

#include "scene/textures/texture_uv.h"

namespace drc {
namespace {

TEST(TextureConvert, Inverts) {
    const auto half = std::make_shared<ConstantTexture<float>>(0.25f);
    EXPECT_EQ(makeInvertedTexture<float>(half)->eval({}), 0.75f);
    EXPECT_TRUE(makeInvertedTexture<float>(half)->isConstant());
    const auto color = std::make_shared<ConstantTexture<Rgb>>(Rgb(0.25f, 2, 1));
    EXPECT_EQ(makeInvertedTexture<Rgb>(color)->eval({}), Rgb(0.75f, 0, 0));
    EXPECT_FALSE(makeInvertedTexture<Rgb>(makeUvTexture({}))->isConstant());
}

TEST(TextureConvert, Remainders) {
    const auto remainder = [](float share) {
        return makeRemainderTexture(std::make_shared<ConstantTexture<float>>(share))->eval({});
    };
    EXPECT_EQ(remainder(0.25f), Rgb(0.75f));
    EXPECT_EQ(remainder(-1), Rgb(1.f));
    EXPECT_EQ(remainder(3), Rgb(0.f));
}

TEST(TextureConvert, Greys) {
    EXPECT_EQ(makeGreyTexture(std::make_shared<ConstantTexture<float>>(0.25f))->eval({}), Rgb(0.25f));
}

}  // namespace
}  // namespace drc
