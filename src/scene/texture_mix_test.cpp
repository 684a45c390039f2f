#include "scene/texture_mix.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

TEST(MixTexture, Blends) {
    const auto c = [](float x) -> FloatTexturePtr { return std::make_shared<ConstantTexture<float>>(x); };
    EXPECT_NEAR(makeMixTexture<float>(c(1), c(5), c(0.25f))->eval({}), 2, 1e-6f);
    const RgbTexturePtr red = std::make_shared<ConstantTexture<Rgb>>(Rgb(1, 0, 0));
    const RgbTexturePtr blue = std::make_shared<ConstantTexture<Rgb>>(Rgb(0, 0, 1));
    EXPECT_EQ(makeMixTexture<Rgb>(red, blue, c(0.25f))->eval({}), Rgb(0.75f, 0, 0.25f));
}

}  // namespace
}  // namespace drc
