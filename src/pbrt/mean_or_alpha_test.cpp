#include "pbrt/mean_or_alpha.h"

#include <gtest/gtest.h>

#include "image/color.h"
#include "image/image_io.h"
#include "pbrt/test_scenes.h"
#include "pbrt/texture_files.h"

namespace drc::pbrt {
namespace {

// The number that a texture makes of a pixel.
float numberOf(std::vector<std::string> channels, const std::vector<float>& pixel, TexelEncoding encoding) {
    Image image(2, 2, std::move(channels));
    for (int i = 0; i < 4; ++i)
        for (size_t c = 0; c < pixel.size(); ++c) image.at(i % 2, i / 2, int(c)) = pixel[c];
    const Image numbers = meanOrAlpha(image, encoding);
    return FloatPyramid(numbers, encoding).lookup(Vec2(.5f, .5f), 0, ImageWrap::Repeat);
}

TEST(MeanOrAlpha, IsTheMeanOfDecodedColoursOrTheAlpha) {
    const std::vector<std::string> rgb = {"R", "G", "B"}, rgba = {"R", "G", "B", "A"};
    EXPECT_NEAR(numberOf(rgb, {.2f, .4f, .9f}, TexelEncoding::Linear), .5f, 1e-5f);
    EXPECT_NEAR(numberOf(rgb, {.2f, .4f, .9f}, TexelEncoding::Srgb),
                (srgbToLinear(.2f) + srgbToLinear(.4f) + srgbToLinear(.9f)) / 3, 1e-4f);
    EXPECT_NEAR(numberOf(rgb, {.6f, .6f, .6f}, TexelEncoding::Srgb), srgbToLinear(.6f), 1e-5f);
    EXPECT_NEAR(numberOf(rgba, {.2f, .4f, .9f, 1}, TexelEncoding::Linear), .5f, 1e-5f);
    EXPECT_NEAR(numberOf(rgba, {.2f, .4f, .9f, .25f}, TexelEncoding::Linear), .25f, 1e-5f);
    EXPECT_NEAR(numberOf({"Y"}, {.3f}, TexelEncoding::Linear), .3f, 1e-5f);
    EXPECT_NEAR(numberOf({"Y", "A"}, {.3f, .5f}, TexelEncoding::Linear), .3f, 1e-5f);
    EXPECT_NEAR(numberOf({"A", "B", "G", "R"}, {.25f, .9f, .4f, .2f}, TexelEncoding::Linear), .25f, 1e-5f);
    EXPECT_NEAR(numberOf({"A", "B", "G", "R"}, {1, .9f, .4f, .2f}, TexelEncoding::Linear), .5f, 1e-5f) << "EXR's order";
}

// pbrt-v3 takes the luminance, and no notice of alpha.
TEST(MeanOrAlpha, DiffersBetweenTheDialects) {
    const TemporaryFolder folder;
    Image image(2, 2);
    for (int i = 0; i < 4; ++i) image.setRgb(i % 2, i / 2, Rgb(1, .5f, 0));
    folder.write("c.png", encodePng(image));
    const float encoded = std::round(srgbEncode(.5f) * 255) / 255;
    const auto alphaOf = [&](bool v4, const std::string& encoding) {
        const std::string world = "Texture \"t\" \"float\" \"imagemap\" \"string filename\" \"c.png\" " + encoding +
                                  "\nShape \"sphere\" \"texture alpha\" \"t\"\n";
        const auto scene = v4 ? loadWorldV4(world, folder.path()) : loadWorld(world, folder.path());
        return scene->primitives.at(0).alpha->eval({});
    };
    EXPECT_NEAR(alphaOf(false, ""), srgbToLinear(luminance(Rgb(1, encoded, 0))), 2e-3f) << "of what is stored";
    EXPECT_NEAR(alphaOf(true, ""), .5f, 2e-3f);
    EXPECT_NEAR(alphaOf(true, "\"string encoding\" \"linear\""), (1 + encoded) / 3, 1e-4f);
    EXPECT_NEAR(alphaOf(true, "\"string encoding\" \"gamma 2\""), (1 + encoded * encoded) / 3, 1e-4f);
}

}  // namespace
}  // namespace drc::pbrt
