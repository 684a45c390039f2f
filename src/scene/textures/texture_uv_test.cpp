#include "scene/textures/texture_uv.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

TEST(UvTexture, ShowsTheFractions) {
    TextureContext at;
    at.uv = Vec2(0.75f, -0.25f);
    EXPECT_EQ(makeUvTexture(UvMapping{})->eval(at), Rgb(0.75f, 0.75f, 0));
    EXPECT_EQ(makeUvTexture(UvMapping{2, 1, 0, 0.5f})->eval(at), Rgb(0.5f, 0.25f, 0));
}

}  // namespace
}  // namespace drc
