#include "image/image_layers.h"

#include <gmock/gmock.h>

#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

// Channel c of the only pixel is c.
Image picture(const std::vector<std::string>& channels) {
    Image image(1, 1, channels);
    for (size_t c = 0; c < channels.size(); ++c) image.data()[c] = float(c);
    return image;
}

const Image kRender = picture({"R", "G", "B", "Denoising Depth.Z", "direct.R", "direct.G", "direct.B", "v.1.x"});

TEST(ImageLayers, AreNamedByWhatStandsBeforeTheLastDot) {
    EXPECT_THAT(layerNames(kRender), ElementsAre("", "Denoising Depth", "direct", "v.1"));
    EXPECT_EQ(layerList(kRender), "the beauty, Denoising Depth, direct, v.1");
    EXPECT_THAT(layerOf(kRender, "direct")->channelNames(), ElementsAre("R", "G", "B"));
    EXPECT_THAT(layerOf(kRender, "direct")->data(), ElementsAre(4, 5, 6));
    EXPECT_THAT(layerOf(kRender, "v.1")->channelNames(), ElementsAre("x"));
    EXPECT_FALSE(layerOf(kRender, "v"));
}

TEST(ImageLayers, GiveColours) {
    EXPECT_EQ(rgbOfLayer(kRender, "").rgb(0, 0), Rgb(0, 1, 2));
    EXPECT_EQ(rgbOfLayer(kRender, "direct").rgb(0, 0), Rgb(4, 5, 6));
    EXPECT_EQ(rgbOfLayer(kRender, "Denoising Depth").rgb(0, 0), Rgb(3.f));
    EXPECT_EQ(rgbOfLayer(picture({"B", "G", "R"}), "").rgb(0, 0), Rgb(2, 1, 0));
    EXPECT_EQ(rgbOfLayer(picture({"A", "Y"}), "").rgb(0, 0), Rgb(1.f));
    EXPECT_EQ(rgbOfLayer(picture({"n.X", "n.Y", "n.Z"}), "n").rgb(0, 0), Rgb(0, 1, 2));
    EXPECT_EQ(
        errorOf([] { rgbOfLayer(kRender, "Direct"); }),
        "it has no layer or channel \"Direct\"; its layers are: the beauty (R, G, B), Denoising Depth (Z), direct "
        "(R, G, B), v.1 (x); did you mean 'direct'?");
    EXPECT_THAT(errorOf([] { rgbOfLayer(picture({"R", "G", "a.B"}), ""); }), HasSubstr("no channels R, G and B"));
}

TEST(ImageLayers, ChannelsAreFoundByName) {
    EXPECT_EQ(rgbOfLayer(kRender, "G").rgb(0, 0), Rgb(1.f));
    EXPECT_EQ(rgbOfLayer(kRender, "Denoising Depth.Z").rgb(0, 0), Rgb(3.f));
    EXPECT_EQ(rgbOfLayer(kRender, "direct.B").rgb(0, 0), Rgb(6.f));
    EXPECT_EQ(rgbOfLayer(picture({"A"}), "A").rgb(0, 0), Rgb(0.f));
    // A layer goes before a channel of the same name.
    EXPECT_EQ(rgbOfLayer(picture({"Z", "Z.far", "Z.near"}), "Z").rgb(0, 0), Rgb(1.f));
    EXPECT_THAT(partOfLayer(kRender, "direct.B").channelNames(), ElementsAre("direct.B"));
    EXPECT_THAT(partOfLayer(kRender, "direct").channelNames(), ElementsAre("direct.R", "direct.G", "direct.B"));
    EXPECT_THAT(errorOf([] { rgbOfLayer(kRender, "direct.X"); }),
                AllOf(HasSubstr("no layer or channel \"direct.X\""), HasSubstr("direct (R, G, B)"),
                      HasSubstr("did you mean 'direct.R'?")));
    EXPECT_EQ(errorOf([] { rgbOfLayer(picture({"A"}), ""); }),
              "it has no channels R, G and B; its layers are: the beauty (A)");
}

TEST(ImageLayers, TheBeautyIsColoursAndAlpha) {
    EXPECT_THAT(beautyOf(picture({"A", "B", "G", "R", "Z"})).data(), ElementsAre(3, 2, 1, 0));
    EXPECT_THAT(beautyOf(picture({"A", "N.X", "N.Y", "Y"})).channelNames(), ElementsAre("Y", "A"));
    EXPECT_THAT(beautyOf(picture({"N.X", "N.Y"})).channelNames(), ElementsAre("N.X", "N.Y"));
}

TEST(ImageLayers, AreReplacedAndRemoved) {
    Image image = kRender;
    Image rgb(1, 1);
    rgb.setRgb(0, 0, Rgb(7, 8, 9));
    setRgbOfLayer(image, "", rgb);
    EXPECT_THAT(image.data(), ElementsAre(7, 8, 9, 3, 4, 5, 6, 7));
    setRgbOfLayer(image, "direct", rgb);
    EXPECT_THAT(image.data(), ElementsAre(7, 8, 9, 3, 7, 8, 9, 7));
    EXPECT_EQ(errorOf([&] { setRgbOfLayer(image, "v.1", rgb); }), "v.1 has one channel, not three");
    EXPECT_THAT(withoutLayers(image, {"direct", "none", "v.1"}).data(), ElementsAre(7, 8, 9, 3));
    EXPECT_NE(errorOf([] { withoutLayers(picture({"R"}), {""}); }), "");
}

}  // namespace
}  // namespace drc
