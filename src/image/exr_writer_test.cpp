#include "image/exr_writer.h"

#include <Imath/ImathBox.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/folder_testing.h"
#include "image/image_io.h"

namespace drc {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

using ExrWriterTest = FolderTest;

Image makeImage(int width, int height, float first) {
    Image image(width, height);
    for (size_t i = 0; i < image.data().size(); ++i) image.data()[i] = first + float(i) * 0.37f;
    return image;
}

TEST_F(ExrWriterTest, KeepsLayersAndMetadata) {
    const Image beauty = makeImage(5, 3, -2), direct = makeImage(5, 3, 100);
    Image depth(5, 3, {"Z"});
    depth.at(4, 2, 0) = 1e30f;
    const ExrMetadata metadata = {{"drc:seed", "7"}, {"png:odd name", "a\nb \"c\""}, {"Software", "DRC"}};
    writeExr(path("a.exr"), {{"", &beauty}, {"direct", &direct, true}, {"depth", &depth}}, metadata);

    const ImageFile file = readImageFile(path("a.exr"));
    EXPECT_FALSE(file.isSrgbEncoded());
    EXPECT_THAT(file.image.channelNames(),
                testing::UnorderedElementsAre("R", "G", "B", "direct.R", "direct.G", "direct.B", "depth.Z"));
    EXPECT_EQ(file.image.at(4, 2, file.image.channelIndex("B")), beauty.at(4, 2, 2));
    EXPECT_EQ(file.image.at(4, 2, file.image.channelIndex("depth.Z")), 1e30f);
    EXPECT_NEAR(file.image.at(1, 2, file.image.channelIndex("direct.G")), direct.at(1, 2, 1), 0.04);
    EXPECT_EQ(readLinearRgb(path("a.exr")).data(), beauty.data());
    EXPECT_EQ(readExrMetadata(path("a.exr")), metadata);

    const Imf::InputFile exr(path("a.exr").c_str());
    EXPECT_EQ(exr.header().channels().findChannel("direct.R")->type, Imf::HALF);
    EXPECT_EQ(exr.header().channels().findChannel("R")->type, Imf::FLOAT);
}

TEST_F(ExrWriterTest, HalfClampsAndKeepsNan) {
    Image image(3, 1, {"Y"});
    image.data() = {1e9f, -kInfinity, std::numeric_limits<float>::quiet_NaN()};
    writeExr(path("a.exr"), {{"", &image, true}});
    const Image back = readImage(path("a.exr"));
    EXPECT_EQ(back.data()[0], 65504);
    EXPECT_EQ(back.data()[1], -65504);
    EXPECT_TRUE(std::isnan(back.data()[2]));
}

TEST_F(ExrWriterTest, PartOfAPicture) {
    const Image image = makeImage(4, 3, 1);
    writeExr(path("a.exr"), {{"", &image}}, {}, {10, 20, 640, 480});
    const Imf::InputFile exr(path("a.exr").c_str());
    EXPECT_EQ(exr.header().dataWindow(), Imath::Box2i(Imath::V2i(10, 20), Imath::V2i(13, 22)));
    EXPECT_EQ(exr.header().displayWindow(), Imath::Box2i(Imath::V2i(0, 0), Imath::V2i(639, 479)));
    EXPECT_EQ(readLinearRgb(path("a.exr")).data(), image.data());
}

TEST_F(ExrWriterTest, RefusesLayersThatDoNotFit) {
    const Image a = makeImage(4, 3, 0), b = makeImage(3, 4, 0), empty;
    EXPECT_THAT(errorOf([&] {
                    writeExr(path("a.exr"), {{"", &a}, {"x", &b}});
                }),
                HasSubstr("\"x\" is 3x4, the first is 4x3"));
    EXPECT_THAT(errorOf([&] {
                    writeExr(path("a.exr"), {{"", &a}, {"", &a}});
                }),
                HasSubstr("two channels are called R"));
    EXPECT_THAT(errorOf([&] { writeExr(path("a.exr"), empty); }), HasSubstr("is empty"));
    EXPECT_THAT(errorOf([&] { writeExr(path("a.exr"), a, {{"dataWindow", "x"}}); }), StartsWith("cannot write"));
    EXPECT_TRUE(fs::is_empty(dir_));
}

}  // namespace
}  // namespace drc
