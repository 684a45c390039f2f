#include <nlohmann/json.hpp>

#include "app/image_command_testing.h"
#include "base/atomic_file.h"
#include "image/auto_exposure.h"
#include "image/color.h"
#include "image/picture_window.h"
#include "image/test_images.h"
#include "image/view_transform.h"

namespace drc {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

class ImageCommandTest : public ImageCommandFolder {
  protected:
    // a.exr and b.exr have layers, bad.exr has pixels that are no numbers, cut.exr is cut short, hostile.exr claims a
    // size of terabytes.
    void SetUp() override {
        Image depth(48, 40, {"Z"}), variance(48, 40), counts(48, 40, {"X"});
        for (float& v : depth.data()) v = 3;
        const Image a = testing_images::reference(), b = testing_images::changed();
        const std::vector<ExrLayer> others{
            {"depth", &depth}, {"Denoising Variance", &variance}, {"Debug Sample Count", &counts}};
        for (const auto& [name, image] : {std::pair("a.exr", &a), std::pair("b.exr", &b)}) {
            std::vector<ExrLayer> layers{{"", image}};
            layers.insert(layers.end(), others.begin(), others.end());
            writeExr(path(name), layers, {{"drc:seed", name}, {"drc:command", "secret"}}, {10, 20, 640, 480});
        }
        writeExr(path("small.exr"), a.crop(0, 0, 5, 4));
        writeExr(path("depth.exr"), {{"depth", &depth}});
        Image bad = a;
        bad.at(3, 2, 0) = kNan;
        bad.at(4, 2, 1) = kInfinity;
        writeExr(path("bad.exr"), bad);
        const std::string bytes = readFile(path("a.exr"));
        folder_.write("cut.exr", bytes.substr(0, bytes.size() / 2));
        std::string hostile = bytes;
        const size_t window = hostile.find("dataWindow") + 10 + 1 + 6 + 4;
        for (const size_t at : {window + 10, window + 14}) hostile[at] = 0x7f;
        folder_.write("hostile.exr", hostile);
    }
};

TEST_F(ImageCommandTest, ConvertKeepsAllOfAnExr) {
    run({"convert", path("a.exr"), "-o", path("out.exr")});
    const PictureFile from = readPictureFile(path("a.exr")), to = readPictureFile(path("out.exr"));
    EXPECT_EQ(to.image.channelNames(), from.image.channelNames());
    EXPECT_EQ(to.image.data(), from.image.data());
    EXPECT_EQ(to.metadata.at("drc:seed"), "a.exr");
    EXPECT_EQ(to.metadata.count("drc:image_command"), 1u);
    EXPECT_EQ(to.window.x, 10);
    EXPECT_EQ(to.window.fullHeight, 480);
    run({"convert", path("a.exr"), "-o", path("layer.exr"), "--layer", "depth"});
    EXPECT_THAT(readImage(path("layer.exr")).channelNames(), ElementsAre("R", "G", "B"));
    EXPECT_EQ(readImage(path("layer.exr")).at(7, 7, 2), 3);
}

TEST_F(ImageCommandTest, ConvertShowsAPng) {
    run({"convert", path("a.exr"), "-o", path("out.png"), "--auto-exposure", "--exposure", "-1", "--view", "agx"});
    // The part lies at (10, 20) of 640x480.
    const Image radiance = testing_images::reference(), shown = readImage(path("out.png"));
    const float stops = autoExposure(radiance) - 1;
    ASSERT_EQ(sizeString(shown), "640x480");
    for (int x = 0; x < 48; ++x) {
        const Rgb expected = srgbEncode(viewed(radiance.rgb(x, 11) * std::exp2(stops), View::Agx));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(shown.at(x + 10, 11 + 20, c), expected[c], 0.51 / 255);
    }
    EXPECT_LT(shown.at(9, 31, 0), 0.51 / 255);
    const ExrMetadata notes = readMetadata(path("out.png"));
    EXPECT_EQ(notes.at("drc:display_view"), "agx");
    EXPECT_NEAR(std::stof(notes.at("drc:display_exposure")), stops, 1e-3);
    EXPECT_EQ(notes.count("drc:command"), 0u);
    EXPECT_EQ(notes.count("drc:image_command"), 0u);
    // There and back again, PNG to PNG, changes nothing.
    run({"convert", path("out.png"), "-o", path("again.png")});
    EXPECT_EQ(readImage(path("again.png")).data(), shown.data());
}

TEST_F(ImageCommandTest, ConvertCropsThenResizes) {
    run({"convert", path("a.exr"), "-o", path("crop.exr"), "--crop", "4", "20", "6", "14"});
    const PictureFile crop = readPictureFile(path("crop.exr"));
    ASSERT_EQ(sizeString(crop.image), "16x8");
    EXPECT_EQ(crop.image.rgb(2, 3), testing_images::reference().rgb(6, 9));
    EXPECT_EQ(crop.window.x, 14);
    EXPECT_EQ(crop.window.y, 26);
    for (const auto& [size, expected] : std::vector<std::pair<std::string, std::string>>{
             {"8x4", "8x4"}, {"8x", "8x4"}, {"x16", "32x16"}, {"1x", "1x1"}}) {
        run({"convert", path("a.exr"), "-o", path("out.exr"), "--crop", "4", "20", "6", "14", "--resize", size});
        const Image resized = readImage(path("out.exr"));
        EXPECT_EQ(sizeString(resized), expected);
        EXPECT_THAT(resized.channelNames(), ElementsAre("R", "G", "B", "depth.Z"));
        EXPECT_NEAR(resized.at(0, 0, 3), 3, 1e-5);
    }
    for (const char* size : {"8", "x", "0x4", "-1x4", "8x4x2", "70000x", "9999999999x2", "8 x4", "x65536"})
        EXPECT_THAT(complaint({"convert", path("a.exr"), "-o", path("no.exr"), "--resize", size}, "no.exr"),
                    AllOf(HasSubstr("--resize " + std::string(size)), HasSubstr("640x360")));
    EXPECT_THAT(complaint({"convert", path("a.exr"), "-o", path("no.exr"), "--crop", "0", "49", "0", "2"}, "no.exr"),
                AllOf(HasSubstr("--crop"), HasSubstr("a.exr"), HasSubstr("48x40")));
}

TEST_F(ImageCommandTest, BadFilesGetOneLine) {
    const auto convert = [&](const char* name) {
        return complaint({"convert", path(name), "-o", path("out.exr")}, "out.exr");
    };
    EXPECT_THAT(convert("cut.exr"), HasSubstr("cannot read " + path("cut.exr")));
    EXPECT_THAT(convert("hostile.exr"), HasSubstr("cannot read " + path("hostile.exr")));
    EXPECT_THAT(convert("none.exr"), HasSubstr("none.exr: No such file"));
    folder_.write("empty.png", "");
    EXPECT_THAT(convert("empty.png"), HasSubstr("the file is empty"));
    folder_.write("text.exr", "no picture at all");
    EXPECT_THAT(convert("text.exr"), HasSubstr("text.exr"));
    EXPECT_EQ(complaint({"convert", path("depth.exr"), "-o", path("out.png")}, "out.png"),
              path("depth.exr") + ": it has no channels R, G and B; its layers are: depth (Z)");
    EXPECT_EQ(complaint({"convert", path("a.exr"), "-o", path("out.png"), "--layer", "Direct"}, "out.png"),
              path("a.exr") +
                  ": it has no layer or channel \"Direct\"; its layers are: the beauty (R, G, B), Debug Sample Count "
                  "(X), Denoising Variance (R, G, B), depth (Z)");
    EXPECT_EQ(complaint({"convert", path("a.exr"), "-o", path("out.exr"), "--view", "agx"}, "out.exr"),
              "--view: EXR files stay linear and unexposed; give a .png as output");
    EXPECT_THAT(complaint({"convert", path("a.exr"), "-o", path("out.gif")}, "out.gif"),
                HasSubstr("out.gif: pictures are written as .jpg, .jpeg, .hdr, .pic, .pfm, .exr or .png"));
    EXPECT_EQ(complaint({"convert", path("a.exr"), "-o", path("out.hdr"), "--exposure", "1"}, "out.hdr"),
              "--exposure: Radiance HDR files stay linear and unexposed; give a .png or .jpg as output");
    EXPECT_THAT(complaint({"convert", path("a.exr"), "-o", path("out.png"), "--jpeg-quality", "50"}, "out.png"),
                HasSubstr("--jpeg-quality: "));
    EXPECT_THAT(complaint({"convert", path("a.exr"), "-o", path("out.exr"), "--png-bits", "16"}, "out.exr"),
                HasSubstr("--png-bits: "));
    EXPECT_THAT(complaint({"convert", path("a.exr"), "-o", path("no/out.png")}), HasSubstr("there is no folder"));
    EXPECT_THROW(run({"convert", path("a.exr")}), CLI::ParseError);
    EXPECT_THROW(run({}), CLI::ParseError);
}

TEST_F(ImageCommandTest, PixelsThatAreNoNumbersAreBlackWhereTheyAreFiltered) {
    testing::internal::CaptureStderr();
    run({"convert", path("bad.exr"), "-o", path("out.exr"), "--resize", "24x20"});
    EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("bad.exr: 2 pixel(s) are NaN or infinite"));
    const Image resized = readImage(path("out.exr"));
    for (const float v : resized.data()) EXPECT_TRUE(std::isfinite(v));
    run({"convert", path("bad.exr"), "-o", path("out.exr")});
    EXPECT_TRUE(std::isnan(readImage(path("out.exr")).at(3, 2, 0)));
}

TEST_F(ImageCommandTest, ConvertWritesEveryFormat) {
    const Image radiance = testing_images::reference();
    writeExr(path("whole.exr"), radiance);
    const auto convert = [&](const char* name, std::vector<std::string> more = {}) {
        std::vector<std::string> arguments{"convert", path("whole.exr"), "-o", path(name)};
        arguments.insert(arguments.end(), more.begin(), more.end());
        run(arguments);
        return readImageFile(path(name));
    };
    EXPECT_EQ(convert("out.pfm").image.data(), radiance.data());
    const Image hdr = convert("out.HDR").image;
    for (int x = 0; x < 48; ++x)
        for (int c = 0; c < 3; ++c) {
            const Rgb rgb = radiance.rgb(x, 9);
            EXPECT_NEAR(hdr.at(x, 9, c), rgb[c], std::max({rgb.x, rgb.y, rgb.z}) / 250) << x;
        }
    const ImageFile wide = convert("out.png", {"--png-bits", "16"});
    EXPECT_EQ(wide.encoding, Encoding::UInt16);
    EXPECT_NEAR(wide.image.at(7, 9, 1), srgbEncode(clamp01(radiance.at(7, 9, 1))), 1e-5);
    const ImageFile jpeg = convert("out.jpg", {"--jpeg-quality", "100", "--exposure", "-1"});
    EXPECT_EQ(jpeg.encoding, Encoding::UInt8);
    EXPECT_NEAR(jpeg.image.at(7, 9, 1), srgbEncode(clamp01(radiance.at(7, 9, 1) / 2)), .03);
    convert("small.jpeg", {"--jpeg-quality", "20"});
    EXPECT_LT(readFile(path("small.jpeg")).size(), readFile(path("out.jpg")).size());
}

TEST_F(ImageCommandTest, HalvesStayHalves) {
    const Image a = testing_images::reference();
    Image depth(48, 40, {"Z"});
    writeExr(path("half.exr"), {{"", &a, true}, {"depth", &depth}, {"light", &a, true}});
    const auto halvesOf = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments{"convert", path("half.exr"), "-o", path("out.exr")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        run(arguments);
        return readImageFile(path("out.exr")).storage.halfChannels;
    };
    EXPECT_THAT(halvesOf({}), ElementsAre("B", "G", "R", "light.B", "light.G", "light.R"));
    EXPECT_EQ(readImage(path("out.exr")).data(), readImage(path("half.exr")).data());
    EXPECT_THAT(halvesOf({"--layer", "light"}), ElementsAre("B", "G", "R"));
    EXPECT_THAT(halvesOf({"--layer", "depth"}), testing::IsEmpty());
    EXPECT_THAT(run({"info", path("half.exr")}), HasSubstr("values    floats, halves"));
}

TEST_F(ImageCommandTest, SingleChannelsAreLayers) {
    for (const char* name : {"depth.Z", "depth"}) {
        run({"convert", path("a.exr"), "-o", path("out.pfm"), "--layer", name, "--crop", "0", "4", "0", "4"});
        EXPECT_EQ(readImage(path("out.pfm")).rgb(3, 3), Rgb(3.f)) << name;
    }
    run({"convert", path("a.exr"), "-o", path("out.exr"), "--layer", "G"});
    EXPECT_EQ(readImage(path("out.exr")).at(5, 5, 0), testing_images::reference().at(5, 5, 1));
    const std::string info = run({"info", path("a.exr"), "--layer", "depth.Z"});
    EXPECT_THAT(info, AllOf(HasSubstr("depth.Z"), testing::Not(HasSubstr("Variance"))));
    const auto json =
        nlohmann::json::parse(run({"diff", path("a.exr"), path("b.exr"), "--json", "--layer", "depth.Z"}));
    EXPECT_EQ(json["mse"], 0);
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"convert", path("a.exr"), "-o", path("out.png"), "--layer", "dept.Z"},
          {"info", path("a.exr"), "--layer", "dept.Z"},
          {"diff", path("a.exr"), path("b.exr"), "--layer", "dept.Z"}})
        EXPECT_THAT(
            complaint(arguments, "out.png"),
            AllOf(HasSubstr("a.exr: it has no layer or channel \"dept.Z\"; its layers are: the beauty (R, G, B)"),
                  HasSubstr("did you mean 'depth.Z'?")));
}

TEST_F(ImageCommandTest, PartsArePlacedInTheWhole) {
    // 48x40 pixels at (10, 20) of 640x480.
    run({"convert", path("a.exr"), "-o", path("out.pfm")});
    const Image whole = readImage(path("out.pfm"));
    ASSERT_EQ(sizeString(whole), "640x480");
    EXPECT_EQ(whole.rgb(10 + 6, 20 + 9), testing_images::reference().rgb(6, 9));
    EXPECT_EQ(whole.rgb(9, 25), Rgb(0.f));
    run({"convert", path("a.exr"), "-o", path("out.exr"), "--resize", "320x"});
    const PictureFile half = readPictureFile(path("out.exr"));
    EXPECT_EQ(sizeString(half.image), "320x240");
    EXPECT_TRUE(isWhole(half.image, half.window));
    run({"convert", path("a.exr"), "-o", path("out.pfm"), "--crop", "4", "20", "6", "14"});
    EXPECT_EQ(sizeString(readImage(path("out.pfm"))), "16x8");
    // Overscan is cut off.
    const Image a = testing_images::reference();
    writeExr(path("over.exr"), {{"", &a}}, {}, {-4, -3, 40, 34});
    run({"convert", path("over.exr"), "-o", path("out.pfm")});
    EXPECT_EQ(readImage(path("out.pfm")).data(), a.crop(4, 3, 44, 37).data());
    EXPECT_THAT(run({"info", path("over.exr")}), HasSubstr("48 x 40 pixels, at (-4, -3) of 40 x 34"));
}

TEST_F(ImageCommandTest, OtherPlacesAreNotCompared) {
    const Image a = testing_images::reference();
    writeExr(path("moved.exr"), {{"", &a}}, {}, {11, 20, 640, 480});
    writeExr(path("whole.exr"), a);
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"diff", path("a.exr"), path("moved.exr")},
          {"diff", path("a.exr"), path("a.exr"), path("moved.exr")}})
        EXPECT_EQ(complaint(arguments), path("moved.exr") + " is 48x40 at (11, 20) of 640x480, but " + path("a.exr") +
                                            " is 48x40 at (10, 20) of 640x480: only pictures of the same part of one "
                                            "whole can be compared");
    EXPECT_THAT(complaint({"diff", path("whole.exr"), path("moved.exr")}), HasSubstr("of one whole can be compared"));
    EXPECT_THAT(complaint({"average", path("whole.exr"), path("moved.exr"), "-o", path("out.exr")}, "out.exr"),
                HasSubstr("of one whole can be averaged"));
}

// A full disk leaves the old file.
TEST_F(ImageCommandTest, NothingIsHalfWritten) {
    folder_.write("out.exr", "old");
    {
        const FileSizeLimit limit(1000);
        EXPECT_THAT(errorOf([&] { run({"convert", path("a.exr"), "-o", path("out.exr")}); }), HasSubstr("out.exr"));
    }
    EXPECT_EQ(readFile(path("out.exr")), "old");
}

TEST_F(ImageCommandTest, AverageWeighsAllAlike) {
    run({"average", path("a.exr"), path("b.exr"), path("b.exr"), "-o", path("out.exr")});
    const Image mean = readImage(path("out.exr"));
    EXPECT_NEAR(mean.at(22, 12, 0),
                (testing_images::reference().at(22, 12, 0) + 2 * testing_images::changed().at(22, 12, 0)) / 3, 1e-6);
    EXPECT_EQ(mean.at(3, 3, mean.channelIndex("depth.Z")), 3);
    testing::internal::CaptureStderr();
    writeExr(path("plain.exr"), testing_images::reference());
    run({"average", path("bad.exr"), path("plain.exr"), "-o", path("out.exr")});
    EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("bad.exr: 2 value(s) are NaN or infinite"));
    EXPECT_FLOAT_EQ(readImage(path("out.exr")).at(3, 2, 0), testing_images::reference().at(3, 2, 0));
    const auto error = [&](const char* other) {
        return complaint({"average", path("a.exr"), path(other), "-o", path("no.exr")}, "no.exr");
    };
    EXPECT_THAT(error("small.exr"), AllOf(HasSubstr("small.exr is 5x4"), HasSubstr("a.exr is 48x40")));
    EXPECT_THAT(error("plain.exr"), HasSubstr("plain.exr has no channel Debug Sample Count.X"));
    EXPECT_THAT(error("cut.exr"), HasSubstr("cannot read"));
}

TEST_F(ImageCommandTest, SplitShowsEachItsPartWithOneExposure) {
    Image dark = testing_images::reference();
    for (float& v : dark.data()) v *= 0.25f;
    writeExr(path("dark.exr"), dark);
    run({"split", path("a.exr"), path("dark.exr"), "-o", path("out.png"), "--auto-exposure", "--line", "0"});
    const Image shown = readLinearRgb(path("out.png"));
    const float factor = std::exp2(autoExposure(testing_images::reference()));
    const auto expectShown = [&](int x, const Image& of) {
        EXPECT_NEAR(srgbEncode(shown.at(x, 7, 1)), srgbEncode(clamp01(of.at(x, 7, 1) * factor)), 0.51 / 255) << x;
    };
    expectShown(23, testing_images::reference());
    expectShown(24, dark);
    run({"split", path("a.exr"), path("dark.exr"), "-o", path("out.exr"), "--rows", "--line", "0"});
    EXPECT_EQ(readImage(path("out.exr")).rgb(9, 19), testing_images::reference().rgb(9, 19));
    EXPECT_EQ(readImage(path("out.exr")).rgb(9, 20), dark.rgb(9, 20));
    run({"split", path("a.exr"), path("b.exr"), "-o", path("out.exr"), "--crop", "0", "8", "0", "6", "--crop", "20",
         "28", "10", "16", "--zoom", "2", "--line", "3"});
    const Image parts = readImage(path("out.exr"));
    ASSERT_EQ(sizeString(parts), "35x27");
    EXPECT_EQ(parts.rgb(19 + 2, 15 + 3), testing_images::changed().rgb(21, 11));
    EXPECT_EQ(parts.rgb(16, 0), Rgb(1.f));
    const auto error = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments{"split", path("a.exr"), path("b.exr"), "-o", path("no.png")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return complaint(arguments, "no.png");
    };
    EXPECT_THAT(error({"--zoom", "2"}), HasSubstr("give a --crop"));
    EXPECT_THAT(error({"--rows", "--crop", "0", "1", "0", "1"}), HasSubstr("--rows"));
    EXPECT_THAT(error({"--crop", "0", "1", "0", "41"}), HasSubstr("cannot cut"));
    EXPECT_THAT(complaint({"split", path("a.exr"), path("small.exr"), "-o", path("no.png")}, "no.png"),
                AllOf(HasSubstr("small.exr is 5x4"), HasSubstr("a.exr is 48x40")));
}

TEST_F(ImageCommandTest, InfoSaysWhatIsInThere) {
    const std::string text = run({"info", path("a.exr"), path("bad.exr")});
    EXPECT_THAT(text, AllOf(HasSubstr("48 x 40 pixels, at (10, 20) of 640 x 480"), HasSubstr("drc:seed = a.exr"),
                            HasSubstr("the beauty, Debug Sample Count, Denoising Variance, depth"),
                            HasSubstr("stops by --auto-exposure")));
    const auto json = nlohmann::json::parse(run({"info", path("a.exr"), path("bad.exr"), "--json"}));
    ASSERT_EQ(json.size(), 2u);
    EXPECT_EQ(json[0]["width"], 48);
    EXPECT_EQ(json[0]["window"], nlohmann::json({10, 20, 640, 480}));
    EXPECT_EQ(json[0]["channels"]["depth.Z"]["mean"], 3);
    EXPECT_EQ(json[0]["metadata"]["drc:command"], "secret");
    EXPECT_EQ(json[1]["channels"]["R"]["nan"], 1);
    EXPECT_EQ(json[1]["channels"]["G"]["infinite"], 1);
    EXPECT_EQ(json[1]["channels"]["B"]["nan"], 0);
    writeExr(path("odd.exr"), Image(1, 1), {{"note", "two\nlines \xff"}});
    EXPECT_THAT(run({"info", path("odd.exr")}), HasSubstr("note = two lines"));
    EXPECT_NO_THROW(nlohmann::json::parse(run({"info", path("odd.exr"), "--json"})));
    EXPECT_THAT(complaint({"info", path("cut.exr")}), HasSubstr("cannot read"));
}

TEST_F(ImageCommandTest, DiffIsCompare) {
    const auto json = nlohmann::json::parse(run({"diff", path("a.exr"), path("b.exr"), "--json"}));
    EXPECT_GT(json["mse"].get<double>(), 0.001);
    EXPECT_LT(json["ssim"].get<double>(), 1);
}

}  // namespace
}  // namespace drc
