// Recognising the dialect of a scene.
#include "pbrt/dialect_scan.h"

#include <gmock/gmock.h>

#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

DialectFinding find(const std::string& text, const std::string& directory = ".") {
    return findDialect(Source::fromText(text, "s.pbrt", directory), FileSearch(directory));
}

TEST(DialectScan, TypesTell) {
    const auto is = [](const std::string& text, Dialect dialect) {
        const DialectFinding found = find(text);
        EXPECT_EQ(found.dialect, dialect) << text;
        EXPECT_FALSE(found.word.empty()) << text;
        EXPECT_FALSE(found.weak) << text;
    };
    for (const char* v3 :
         {"Film \"image\"", "Sampler \"02sequence\"", "Integrator \"directlighting\"", "Material \"matte\"",
          "MakeNamedMaterial \"diffuse\" \"rgb Kd\" [1 1 1] \"string type\" [\"glass\"]", "AreaLightSource \"area\"",
          "Texture \"rgb\" \"spectrum\" \"uv\"", "Camera \"environment\"", "Shape \"cone\""})
        is(std::string("LookAt 0 0 1 0 0 0 0 1 0 # Film \"rgb\"\n") + v3 + " Film \"rgb\"", Dialect::V3);
    for (const char* v4 :
         {"Film \"rgb\"", "Film \"gbuffer\"", "Sampler \"zsobol\"", "Sampler \"independent\"", "Material \"diffuse\"",
          "MakeNamedMaterial \"matte\" \"string type\" \"conductor\"", "Option \"bool disablepixeljitter\" true",
          "ColorSpace \"rec2020\"", "Attribute \"shape\" \"float radius\" 2", "Import \"x.pbrt\"",
          "Texture \"uv\" \"float\" \"directionmix\"", "Shape \"bilinearmesh\"", "Camera \"spherical\""})
        is(std::string("Camera \"perspective\" \"string note\" [ \"Film\" \"image\" ]\n") + v4 + " Film \"image\"",
           Dialect::V4);
}

TEST(DialectScan, ParametersTellWhereNothingElseDoes) {
    const auto is = [](const std::string& text, Dialect dialect) {
        const DialectFinding found = find("WorldBegin " + text);
        EXPECT_EQ(found.dialect, dialect) << text;
        EXPECT_TRUE(found.weak) << text;
    };
    is("LightSource \"infinite\" \"string filename\" \"a.exr\"", Dialect::V4);
    is("LightSource \"infinite\" \"string mapname\" \"a.exr\"", Dialect::V3);
    is("LightSource \"point\" \"blackbody I\" 6500", Dialect::V4);
    is("LightSource \"point\" \"blackbody I\" [6500]", Dialect::V4);
    is("LightSource \"point\" \"blackbody I\" [6500 1]", Dialect::V3);
    is("LightSource \"point\" \"float scale\" 3", Dialect::V4);
    is("LightSource \"point\" \"rgb scale\" [3 3 3]", Dialect::V3);
    is("AreaLightSource \"diffuse\" \"float power\" 3", Dialect::V4);
    is("Texture \"a\" \"float\" \"imagemap\" \"bool invert\" true", Dialect::V4);
    is("Texture \"a\" \"float\" \"scale\" \"float tex1\" 1", Dialect::V3);
    is("Material \"mix\" \"string materials\" [\"a\" \"b\"]", Dialect::V4);
    is("Material \"hair\" \"spectrum eta\" \"glass-BK7\"", Dialect::V4);
    is("Texture \"a\" \"spectrum\" \"constant\" \"xyz value\" [1 1 1]", Dialect::V3);
    // A directive or type outweighs parameters before it.
    EXPECT_EQ(find("Sampler \"halton\" \"integer seed\" 3\nFilm \"image\"").dialect, Dialect::V3);
    EXPECT_EQ(find("Sampler \"halton\" \"integer seed\" 3\nFilm \"image\"").where.line, 2);
}

TEST(DialectScan, SaysWhatItFound) {
    EXPECT_EQ(find("\nFilm \"rgb\"").describe(), "pbrt-v4, as 'Film \"rgb\"' in line 2 of s.pbrt tells");
    const DialectFinding none = find("WorldBegin Shape \"sphere\" WorldEnd");
    EXPECT_EQ(none.dialect, Dialect::V3);
    EXPECT_THAT(none.describe(), StartsWith("pbrt-v3, as no word of it"));
    // Faults are left to the parser to report.
    for (const char* bad : {"Film", "Film \"", "Shape \"sphere\" \"float radius\" [", "Include \"no.pbrt\"", "Film [",
                            "Shape \"sphere\" \"float", "Texture \"a\" Film \"rgb\""})
        EXPECT_EQ(find(bad).dialect, Dialect::V3) << bad;
}

TEST(DialectScan, FollowsIncludes) {
    const TemporaryFolder folder;
    folder.write("sub/film.pbrt", "Film \"rgb\"\n");
    const DialectFinding found = find("Camera \"perspective\" Include \"sub/film.pbrt\"", folder.path());
    EXPECT_EQ(found.dialect, Dialect::V4);
    EXPECT_THAT(found.where.file, HasSubstr("sub/film.pbrt"));
}

TEST(DialectScan, MixingTheTwoIsOneErrorThatNamesBothPlaces) {
    EXPECT_THAT(errorOfScene("Film \"image\"\nWorldBegin\nMaterial \"diffuse\"\nWorldEnd\n"),
                AllOf(StartsWith("s.pbrt:3:10: only pbrt-v4 has the type 'diffuse'"),
                      HasSubstr("read as pbrt-v3, as 'Film \"image\"' in line 1 of s.pbrt tells")));
    EXPECT_THAT(errorOfWorldV4("MakeNamedMaterial \"m\" \"string type\" \"matte\""),
                AllOf(StartsWith("s.pbrt:2:37: only pbrt-v3 has the type 'matte'"), HasSubstr("'Film \"rgb\"'")));
    EXPECT_THAT(errorOfScene("Film \"image\"\nColorSpace \"srgb\"\nWorldBegin\nWorldEnd"),
                StartsWith("s.pbrt:2:1: only pbrt-v4 has the directive 'ColorSpace'"));
    EXPECT_THAT(errorOfWorldV4("Texture \"a\" \"spectrum\" \"uv\""), HasSubstr("only pbrt-v3 has the type 'uv'"));
    EXPECT_THAT(errorOfWorldV4("AreaLightSource \"area\""), HasSubstr("only pbrt-v3 has the type 'area'"));
}

}  // namespace
}  // namespace drc::pbrt
