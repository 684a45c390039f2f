// MakeNamedMedium and MediumInterface, in both dialects.
#include "pbrt/medium_factory.h"

#include <gtest/gtest.h>

#include "base/log.h"
#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::HasSubstr;

// The medium called "fog" that the parameters describe, as it surrounds the camera.
Medium fog(const std::string& parameters, bool v4 = false) {
    const std::string text = "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" " + parameters +
                             "\nMediumInterface \"\" \"fog\"\nCamera \"perspective\"\n";
    const auto scene = loadPbrtString(
        v4 ? text + "Film \"rgb\"\nWorldBegin\n" : text + "Film \"image\"\nWorldBegin\nWorldEnd\n", ".", {}, "s.pbrt");
    return *scene->sensor.medium;
}

TEST(MediumFactory, ReadsCoefficients) {
    const std::string given = "\"rgb sigma_a\" [1 2 3] \"rgb sigma_s\" [4 5 6] \"float scale\" 10 \"float g\" -0.5";
    for (const bool v4 : {false, true}) {
        const Medium m = fog(given, v4);
        EXPECT_EQ(m.sigmaA, Rgb(10, 20, 30));
        EXPECT_EQ(m.sigmaS, Rgb(40, 50, 60));
        EXPECT_EQ(m.g, -0.5f);
        EXPECT_EQ(m.emission, Rgb(0.f));
    }
}

TEST(MediumFactory, HasTheDefaultsOfEachDialect) {
    EXPECT_EQ(fog("").sigmaA, Rgb(.0011f, .0024f, .014f));
    EXPECT_EQ(fog("").sigmaS, Rgb(2.55f, 3.21f, 3.77f));
    EXPECT_EQ(fog("", true).sigmaA, Rgb(1.f));
    EXPECT_EQ(fog("", true).sigmaS, Rgb(1.f));
    EXPECT_EQ(fog("").g, 0);
}

TEST(MediumFactory, KnowsPresets) {
    const Medium cream = fog("\"string preset\" \"Cream\" \"float scale\" 2 \"rgb sigma_a\" [1 1 1]");
    EXPECT_EQ(cream.sigmaS, Rgb(7.38f, 5.47f, 3.15f) * 2.f);
    EXPECT_EQ(cream.sigmaA, Rgb(2.f));
    forgetWarnings();
    EXPECT_EQ(fog("\"string preset\" \"Crem\"").sigmaS, fog("").sigmaS);
    EXPECT_EQ(warningCount(), 1);
}

// As for lights of pbrt-v4, a spectrum gives the colour alone, and an "rgb" the radiance.
TEST(MediumFactory, EmitsInV4) {
    EXPECT_EQ(fog("\"rgb Le\" [1 2 3] \"float Lescale\" 4", true).emission, Rgb(4, 8, 12));
    EXPECT_NEAR(luminance(fog("\"blackbody Le\" 3000 \"float Lescale\" 4", true).emission), 4, 1e-3);
    forgetWarnings();
    EXPECT_EQ(fog("\"rgb Le\" [1 2 3]").emission, Rgb(0.f));
    EXPECT_EQ(warningCount(), 1);  // pbrt-v3 does not have it
}

TEST(MediumFactory, InheritsFromAttribute) {
    const auto scene = loadWorldV4(
        "Attribute \"medium\" \"float g\" 0.25\nMakeNamedMedium \"fog\" \"string type\" \"homogeneous\"\n"
        "MediumInterface \"fog\" \"\"\nShape \"sphere\"");
    EXPECT_EQ(scene->primitives[0].media.inside->g, 0.25f);
}

TEST(MediumFactory, LeavesOutMediaThatAreNotTheSameEverywhere) {
    for (const char* type : {"cloud", "nanovdb", "rgbgrid", "uniformgrid"}) {
        forgetWarnings();
        const auto scene = loadWorldV4("MakeNamedMedium \"smoke\" \"string type\" \"" + std::string(type) +
                                       "\" \"float density\" [1 2]\nMediumInterface \"smoke\" \"\"\n"
                                       "Shape \"sphere\"\nMediumInterface \"smoke\"\nShape \"sphere\"");
        EXPECT_EQ(warningCount(), 1) << type;
        EXPECT_EQ(scene->primitives[0].media.inside->transmittance(1e6f), Rgb(1.f));
    }
    EXPECT_EQ(errorOfWorld("MakeNamedMedium \"smoke\" \"string type\" \"homogenous\""),
              "s.pbrt:2:39: unknown medium 'homogenous'; did you mean 'homogeneous'?\n"
              "    MakeNamedMedium \"smoke\" \"string type\" \"homogenous\"\n"
              "                                          ^");
}

TEST(MediumFactory, SaysWhatIsWrong) {
    const auto error = [](const std::string& parameters) {
        const std::string text = errorOfWorld("MakeNamedMedium \"fog\" " + parameters);
        return text.substr(0, text.find('\n'));
    };
    const std::string homogeneous = "\"string type\" \"homogeneous\" ";
    EXPECT_EQ(error(""), "s.pbrt:2:1: the medium 'fog' needs the parameter \"string type\"");
    EXPECT_EQ(error(homogeneous + "\"float g\" 1"),
              "s.pbrt:2:51: parameter 'g' of medium 'fog' must be between -1 and 1, both excluded, not 1");
    EXPECT_EQ(error(homogeneous + "\"rgb sigma_s\" [1 -1 1]"),
              "s.pbrt:2:51: parameter 'sigma_s' of medium 'fog' must not have a negative component");
    EXPECT_EQ(error(homogeneous + "\"rgb sigma_s\" [3e38 1 1] \"float scale\" 10"),
              "s.pbrt:2:1: the coefficients of medium 'fog' are too large");
}

TEST(MediumInterface, GoesToShapesAndTheCamera) {
    const std::string media =
        "MakeNamedMedium \"a\" \"string type\" \"homogeneous\" \"float g\" 0.1\n"
        "MakeNamedMedium \"b\" \"string type\" \"homogeneous\" \"float g\" 0.2\n";
    const auto scene = loadPbrtString(media +
                                          "MediumInterface \"a\" \"b\"\nCamera \"perspective\"\nWorldBegin\n"
                                          "Shape \"sphere\"\nAttributeBegin\nMediumInterface \"a\"\nShape \"sphere\"\n"
                                          "MediumInterface \"\" \"a\"\nShape \"sphere\"\nAttributeEnd\n"
                                          "TransformBegin\nMediumInterface \"b\" \"\"\nTransformEnd\n"
                                          "Shape \"sphere\"\nMediumInterface \"\"\nShape \"sphere\"\nWorldEnd\n",
                                      ".", {}, "s.pbrt");
    const auto names = [&](size_t i) {
        const MediumInterface& m = scene->primitives[i].media;
        const auto g = [](const Medium* medium) { return medium ? medium->g : 0; };
        return Vec2(g(m.inside), g(m.outside));
    };
    EXPECT_EQ(scene->sensor.medium->g, 0.2f);
    EXPECT_EQ(names(0), Vec2(0.1f, 0.2f));
    EXPECT_EQ(names(1), Vec2(0.1f, 0.1f));  // one name is that of both sides
    EXPECT_FALSE(scene->primitives[1].media.changes());
    EXPECT_EQ(names(2), Vec2(0, 0.1f));
    EXPECT_EQ(names(3), Vec2(0.2f, 0));  // TransformEnd restores the transformation alone
    EXPECT_EQ(names(4), Vec2(0, 0));
    EXPECT_EQ(scene->media.size(), 2u);
}

// In pbrt-v4 a medium may be named before it is made. pbrt-v3's files come out the same.
TEST(MediumInterface, FindsMediaThatAreDefinedLater) {
    for (const bool v4 : {false, true}) {
        const std::string text =
            "MediumInterface \"late\" \"\"\nShape \"sphere\"\n"
            "MakeNamedMedium \"late\" \"string type\" \"homogeneous\" \"float g\" 0.5\n";
        const auto scene = v4 ? loadWorldV4(text) : loadWorld(text);
        EXPECT_EQ(scene->primitives[0].media.inside->g, 0.5f);
    }
    const std::string unknown =
        "MakeNamedMedium \"mist\" \"string type\" \"homogeneous\"\nMediumInterface \"mits\" \"gone\"\n";
    EXPECT_EQ(errorOfWorldV4(unknown),
              "s.pbrt:3:17: no medium 'mits' is defined; did you mean 'mist'?\n"
              "    MediumInterface \"mits\" \"gone\"\n"
              "                    ^");
    EXPECT_EQ(warningsOfWorld(unknown + "Shape \"sphere\""),
              "drc: s.pbrt:3:17: warning: no medium 'mits' is defined; there is empty space in its place; did you mean "
              "'mist'?\n"
              "drc: s.pbrt:3:24: warning: no medium 'gone' is defined; there is empty space in its place\n");
}

TEST(MediumInterface, SeesASecondDefinitionFromThereOn) {
    const std::string text =
        "MakeNamedMedium \"m\" \"string type\" \"homogeneous\" \"float g\" 0.1\n"
        "MediumInterface \"m\" \"\"\nShape \"sphere\"\n"
        "MakeNamedMedium \"m\" \"string type\" \"homogeneous\" \"float g\" 0.2\n"
        "MediumInterface \"m\" \"\"\nShape \"sphere\"\n";
    for (const bool v4 : {false, true}) {
        const auto scene = v4 ? loadWorldV4(text) : loadWorld(text);
        EXPECT_EQ(scene->primitives[0].media.inside->g, 0.1f);
        EXPECT_EQ(scene->primitives[1].media.inside->g, 0.2f);
    }
}

}  // namespace
}  // namespace drc::pbrt
