#include "scene/textures/texture_imagemap.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

// A point with a round footprint of the given width in uv.
TextureContext at(float u, float v, float width = 0) {
    TextureContext c;
    c.uv = Vec2(u, v);
    c.duvdx = Vec2(width, 0);
    c.duvdy = Vec2(0, width);
    return c;
}

Image rowOf(const std::vector<Rgb>& texels) {
    Image image(int(texels.size()), 1);
    for (int x = 0; x < image.width(); ++x) image.setRgb(x, 0, texels[size_t(x)]);
    return image;
}

const auto kStripes =
    std::make_shared<RgbPyramid>(rowOf({Rgb(0.f), Rgb(1.f), Rgb(0.f), Rgb(1.f)}), TexelEncoding::Linear);

TEST(ImageMap, MappingAndScale) {
    ImageMapParams p;
    p.mapping = UvMapping{0.5f, 1, 0.25f, 0};
    p.scale = 3;
    // s = 0.5 * 0.25 + 0.25 = 0.375, the centre of texel 1.
    EXPECT_EQ(makeImageMap(kStripes, p)->eval(at(0.25f, 0.5f)), Rgb(3.f));
}

TEST(ImageMap, FootprintIsScaledWithTheMapping) {
    ImageMapParams p;
    EXPECT_NEAR(makeImageMap(kStripes, p)->eval(at(0.375f, 0.5f, 0.25f)).x, 1, 1e-5f);
    p.trilinear = true;
    EXPECT_NEAR(makeImageMap(kStripes, p)->eval(at(0.375f, 0.5f, 0.25f)).x, 0.5f, 1e-3f);
    p.trilinear = false;
    p.mapping = UvMapping{8, 1, 0, 0};
    EXPECT_NEAR(makeImageMap(kStripes, p)->eval(at(0.375f / 8, 0.5f, 0.25f)).x, 0.5f, 0.02f);
    // A footprint elongated along the stripes must not blur them.
    TextureContext alongStripes = at(0.375f, 0.5f, 0);
    alongStripes.duvdx = Vec2(0, 4);
    EXPECT_NEAR(makeImageMap(kStripes, ImageMapParams())->eval(alongStripes).x, 1, 1e-5f);
}

TEST(ImageMap, Float) {
    const auto pyramid = std::make_shared<FloatPyramid>(rowOf({Rgb(1, 0.5f, 0.25f)}), TexelEncoding::Linear);
    EXPECT_NEAR(makeImageMap(pyramid, {})->eval(at(0, 0)), luminance(Rgb(1, 0.5f, 0.25f)), 1e-6f);
}

}  // namespace
}  // namespace drc
