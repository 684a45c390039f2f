// Scenes that in few words ask for more than any machine has. Each must give an error at its place, without delay.
#include <gmock/gmock.h>

#include "base/log.h"
#include "pbrt/test_scenes.h"
#include "scene/scene.h"

namespace drc::pbrt {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string repeated(const std::string& text, int count) {
    std::string result;
    for (int i = 0; i < count; ++i) result += text;
    return result;
}

TEST(SceneLimits, BlocksWithinBlocks) {
    const std::string inner = repeated("AttributeBegin\n", 500) + repeated("TransformBegin\n", 500);
    const std::string ends = repeated("TransformEnd\n", 500) + repeated("AttributeEnd\n", 500);
    EXPECT_EQ(errorOfWorld(inner + ends), "");
    EXPECT_THAT(errorOfWorld(repeated("AttributeBegin\n", 2000)),
                StartsWith("s.pbrt:1026:1: AttributeBegin within more than 1024 other blocks"));
}

TEST(SceneLimits, ParametersOfADirective) {
    std::string many;
    for (int i = 0; i < 300; ++i) many += "\"float a" + std::to_string(i) + "\" 1 ";
    EXPECT_THAT(
        errorOfWorld("Shape \"sphere\" " + many),
        AllOf(StartsWith("s.pbrt:2:"), HasSubstr("'a256' of shape 'sphere' is one too many: there may be 256")));
}

TEST(SceneLimits, AttributesThatEveryShapeGetsACopyOf) {
    EXPECT_EQ(errorOfWorldV4("Attribute \"shape\" \"float alpha\" 1 \"float radius\" 2\nShape \"sphere\""), "");
    EXPECT_THAT(errorOfWorldV4("Attribute \"shape\" \"point3 P\" [" + repeated("1 2 3 ", 500) + "]"),
                AllOf(StartsWith("s.pbrt:2:"), HasSubstr("1 parameters with 1500 values; there may be 256 with 1024")));
    std::string many;
    for (int i = 0; i < 300; ++i) many += "Attribute \"shape\" \"float a" + std::to_string(i) + "\" 1\n";
    EXPECT_THAT(errorOfWorldV4(many), AllOf(StartsWith("s.pbrt:258:"), HasSubstr("257 parameters with 257 values")));
}

TEST(SceneLimits, TexturesOfTextures) {
    // A chain of textures, each of which scales the previous one under the same name.
    const std::string first = "Texture \"t\" \"spectrum\" \"checkerboard\"\n";
    const std::string next = "Texture \"t\" \"spectrum\" \"scale\" \"texture tex1\" \"t\"\n";
    const std::string use = "Material \"matte\" \"texture Kd\" \"t\"\nShape \"sphere\"\n";
    EXPECT_EQ(errorOfWorld(first + repeated(next, 99) + use), "");
    EXPECT_THAT(errorOfWorld(first + repeated(next, 100) + use),
                AllOf(StartsWith("s.pbrt:102:24: "), HasSubstr("is made of textures of textures, 101 deep")));
    // A texture that uses the previous one twice doubles the lookups with each line, for float and colour textures
    // alike.
    const std::string twice =
        "Texture \"t\" \"float\" \"mix\" \"texture tex1\" \"t\" \"texture tex2\" \"t\" \"texture amount\" \"t\"\n";
    EXPECT_THAT(errorOfWorld("Texture \"t\" \"float\" \"checkerboard\"\n" + repeated(twice, 60)),
                HasSubstr("would look up 9841 textures for each point"));
    EXPECT_THAT(warningsOfWorld("Texture \"t\" \"float\" \"scale\" \"texture tex1\" \"t\""),
                HasSubstr("no float texture 't' has been defined"));
}

TEST(SceneLimits, MaterialsOfMaterials) {
    const std::string first = "MakeNamedMaterial \"m\" \"string type\" \"mirror\"\n";
    const std::string twice =
        "MakeNamedMaterial \"m\" \"string type\" \"mix\" \"string namedmaterial1\" \"m\" \"string namedmaterial2\" "
        "\"m\"\n";
    EXPECT_THAT(errorOfWorld(first + repeated(twice, 60)), HasSubstr("lobes, which is more than the"));
    EXPECT_THAT(warningsOfWorld(twice), HasSubstr("'m' has not been defined"));
}

TEST(SceneLimits, TransformationsThatLeaveTheRangeOfFloats) {
    EXPECT_THAT(errorOfWorld(repeated("Scale 1e20 1e20 1e20\n", 3)),
                StartsWith("s.pbrt:3:1: with the transformations before it, this one cannot be inverted"));
    EXPECT_THAT(errorOfWorld(repeated("Scale 1e-20 1e-20 1e-20\n", 3)),
                StartsWith("s.pbrt:3:1: with the transformations before it, this one cannot be inverted"));
    EXPECT_THAT(errorOfWorld("Scale 0 1 1"), StartsWith("s.pbrt:2:1: this transformation cannot be inverted"));
    EXPECT_THAT(errorOfWorld("Rotate 30 0 0 0"), StartsWith("s.pbrt:2:1: this transformation cannot be inverted"));
    EXPECT_THAT(errorOfScene("Scale 1 0 1"), StartsWith("s.pbrt:1:1: this transformation cannot be"));
    EXPECT_EQ(errorOfWorld("Scale 1e-20 1e-20 1e-20\nScale 1e20 1e20 1e20\nShape \"sphere\""), "");
}

TEST(SceneLimits, ShapesBeyondWhatCanBeIntersected) {
    EXPECT_THAT(errorOfWorld("Shape \"sphere\" \"float radius\" 3e38"),
                StartsWith("s.pbrt:2:7: the shape 'sphere' reaches farther from the origin than 1e18"));
    EXPECT_THAT(errorOfWorld("Scale 1e10 1e10 1e10 Shape \"disk\" \"float radius\" 1e10"), HasSubstr("farther"));
    EXPECT_THAT(errorOfWorld("Shape \"curve\" \"point P\" [0 0 0 1 0 0 0 1 0 1 1 1e30]"), HasSubstr("farther"));
    EXPECT_THAT(
        errorOfWorld("Shape \"trianglemesh\" \"integer indices\" [0 1 2] \"point P\" [0 0 0 1 0 0 0 1e19 0]"),
        AllOf(StartsWith("s.pbrt:2:7: cannot load the mesh: "), HasSubstr("farther from the origin than 1e18")));
    EXPECT_EQ(errorOfWorld("Shape \"sphere\" \"float radius\" 1e15"), "");
}

// Comparisons with NaN are false, so bounds do not notice NaN.
TEST(SceneLimits, CurvesThroughPointsThatAreNoNumbers) {
    const std::string large = "Scale 1e20 1e20 1e20 Shape \"curve\" \"float width\" 0 \"point P\" ";
    EXPECT_THAT(errorOfWorld(large + "[1e19 0 0 1e19 1e-5 0 1e19 2e-5 0 1e19 3e-5 1e-5]"),
                StartsWith("s.pbrt:2:28: the shape 'curve' reaches farther from the origin than 1e18"));
    // The first of its two segments is valid.
    EXPECT_THAT(errorOfWorld(large + "[0 0 0 1e-20 0 0 0 1e-20 0 1e-20 1e-20 0 1e19 0 0 0 1e19 0 0 0 1e19]"),
                HasSubstr("farther"));
    EXPECT_EQ(errorOfWorld(large + "[0 0 0 1e-20 0 0 0 1e-20 0 1e-20 1e-20 0]"), "");
}

TEST(SceneLimits, InstancesThatRaysCannotBeTakenTo) {
    const std::string object = "ObjectBegin \"o\"\nShape \"sphere\"\nObjectEnd\n";
    EXPECT_THAT(errorOfWorld(object + "Scale 1e-10 1e-10 1e-10\nObjectInstance \"o\""),
                StartsWith("s.pbrt:6:16: an object may be made smaller by a factor of 1e9 at most"));
    EXPECT_EQ(errorOfWorld(object + "Scale 1e-8 1e-8 1e-8\nObjectInstance \"o\""), "");
}

// Embree inverts placements in floats, and aborts on rays with NaN coordinates.
TEST(SceneLimits, PlacementsThatFloatsCannotInvert) {
    const std::string object = "ObjectBegin \"o\"\nShape \"sphere\"\nObjectEnd\n";
    const auto placed = [&](const std::string& placement) {
        return errorOfWorld(object + placement + "\nObjectInstance \"o\"");
    };
    EXPECT_THAT(placed("Scale 1e13 1e13 1e13"),
                StartsWith("s.pbrt:6:16: an object may be made larger by a factor of 1e12 at most"));
    EXPECT_EQ(placed("Scale 1e12 1e12 1e12"), "");
    EXPECT_THAT(placed("Rotate -165 -2 -2 1 Scale 1e-6 1e9 1e3 Rotate 30 1 2 3"), HasSubstr("stretches it aslant"));
    EXPECT_EQ(placed("Scale 1e-6 1e9 1e3"), "");
    EXPECT_EQ(placed("Rotate 45 1 2 3 Scale 1 1 1e-4 Rotate 30 1 2 3"), "");
}

TEST(SceneLimits, MotionsThatFloatsCannotInvert) {
    const auto motion = [](const std::string& start, const std::string& end) {
        return "ActiveTransform StartTime " + start + " ActiveTransform EndTime " + end +
               " ActiveTransform All\nShape \"sphere\"";
    };
    EXPECT_THAT(errorOfWorld(motion("Rotate 110 0 -2 1 Scale -1e-9 -1e3 1e9 Rotate 30 1 2 3",
                                    "Rotate 132 0 -1 1 Scale -1e-9 1 -1e-6")),
                StartsWith("s.pbrt:3:7: an object may be made larger by a factor of 1e12 at most; where"));
    EXPECT_EQ(errorOfWorld(motion("Scale 1 500 1", "Rotate 90 1 2 0 Scale 1 1 500")), "");
    EXPECT_EQ(errorOfWorld(motion("Scale 1e-8 1e-8 1e-8", "Scale 1e8 1e8 1e8")), "");
    // Rotated by 0 or 90 degrees, the part is stretched along its axes, but not between.
    const auto turning = [](const std::string& placement) {
        return "ObjectBegin \"o\"\nActiveTransform EndTime Rotate 90 0 0 1\nShape \"sphere\"\nObjectEnd\n"
               "Rotate 45 0 0 1 " +
               placement + " ObjectInstance \"o\"";
    };
    EXPECT_THAT(errorOfWorld(turning("Scale 1 1e7 1")), HasSubstr("stretches it aslant"));
    EXPECT_EQ(errorOfWorld(turning("Scale 1 500 1")), "");
}

// Each instance of an object with many moving parts places every one of them again.
TEST(SceneLimits, InstancesOfManyMovingParts) {
    std::string object = "ObjectBegin \"o\"\nActiveTransform EndTime\n";
    object += repeated("Translate 1 0 0 Shape \"sphere\"\n", 1000) + "ObjectEnd\n";
    const std::string turn = "ActiveTransform EndTime Rotate 10 0 1 0\n";
    EXPECT_EQ(errorOfWorld(object + turn + repeated("ObjectInstance \"o\"\n", 3)), "");
    EXPECT_THAT(errorOfWorld(object + turn + repeated("ObjectInstance \"o\"\n", 300)),
                AllOf(StartsWith("s.pbrt:1264:16: with this one, instances count for more than 16777216"),
                      HasSubstr("one that moves counts for up to 65")));
}

TEST(SceneLimits, ShapesThatPromiseMoreThanTheyBring) {
    EXPECT_THAT(errorOfWorld("Shape \"heightfield\" \"integer nu\" 2147483647 \"integer nv\" 2147483647 "
                             "\"float Pz\" [0 1 2 3]"),
                HasSubstr("must have nu times nv values, 4611686014132420608, found 4"));
    EXPECT_THAT(errorOfWorld("Shape \"loopsubdiv\" \"integer levels\" 30 \"integer indices\" [0 1 2] "
                             "\"point P\" [0 0 0 1 0 0 0 1 0]"),
                AllOf(StartsWith("s.pbrt:2:7: with this one, subdivision surfaces come to 1.15e+18 triangles"),
                      HasSubstr("use fewer levels")));
    // Each surface by itself is small.
    const std::string surface =
        "Shape \"loopsubdiv\" \"integer levels\" 12 \"integer indices\" [0 1 2] \"point P\" [0 0 0 1 0 0 0 1 0]\n";
    EXPECT_THAT(errorOfWorld(repeated(surface, 5)), StartsWith("s.pbrt:6:7: with this one, subdivision surfaces come"));
}

TEST(SceneLimits, TablesOfMegabytes) {
    const TemporaryFolder folder;
    folder.write("a.spd", repeated("400 1\n", 800'000));
    EXPECT_THAT(errorOfWorld("Material \"matte\" \"spectrum Kd\" \"a.spd\"", folder.path()),
                AllOf(StartsWith("s.pbrt:2:32: cannot read spectrum file"), HasSubstr("File too large")));
    folder.write("l.dat", repeated("50 6 1.5 30\n", 300));
    EXPECT_THAT(errorOfScene("Camera \"realistic\" \"string lensfile\" \"l.dat\"\nWorldBegin\nWorldEnd", folder.path()),
                HasSubstr("l.dat:257:1: a lens may have at most 256 surfaces, this one has 300"));
    folder.write("big.dat", repeated("#", 5 << 20));
    EXPECT_THAT(
        errorOfScene("Camera \"realistic\" \"string lensfile\" \"big.dat\"\nWorldBegin\nWorldEnd", folder.path()),
        AllOf(StartsWith("s.pbrt:1:38: cannot read lens file"), HasSubstr("File too large")));
}

TEST(SceneLimits, ThousandsOfWarningsHaveTheirPlaces) {
    const std::string text = repeated("Shape \"sphere\" \"float radius\" 1 \"float radius\" 1\n", 10'000);
    forgetWarnings();
    testing::internal::CaptureStderr();
    EXPECT_EQ(errorOfWorld(text), "");
    const std::string warnings = testing::internal::GetCapturedStderr();
    EXPECT_EQ(warningCount(), 10'000);
    EXPECT_EQ(
        warnings,
        "drc: s.pbrt:2:33: warning: parameter 'radius' of shape 'sphere' is given twice; the last one counts (and "
        "9999 more)\n");
    forgetWarnings();
}

}  // namespace
}  // namespace drc::pbrt
