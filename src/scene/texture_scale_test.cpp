#include "scene/texture_scale.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

TEST(ScaleTexture, Multiplies) {
    const RgbTexturePtr a = std::make_shared<ConstantTexture<Rgb>>(Rgb(1, 2, 3));
    const RgbTexturePtr t = makeScaleTexture<Rgb>(a, std::make_shared<ConstantTexture<Rgb>>(Rgb(2, 0.5f, 0)));
    EXPECT_EQ(t->eval({}), Rgb(2, 1, 0));
    EXPECT_TRUE(t->isConstant());
}

}  // namespace
}  // namespace drc
