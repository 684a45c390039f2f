#include "pbrt/scene_copy.h"

#include <gmock/gmock.h>

#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class SceneCopyFolder : public testing::Test {
  protected:
    std::string copyOf(const std::string& text, const CopySettings& settings = {}) const {
        const std::string path = folder_.write("scene.pbrt", text);
        std::string copy;
        copyScene(path, settings, [&](std::string_view part) { copy += part; });
        return copy;
    }
    std::string complaint(const std::string& text) const {
        return errorOf([&] { copyOf(text); });
    }

    const TemporaryFolder folder_;
    const CopySettings settings_{
        .resolution = FilmGeometry{.width = 64, .height = 48}, .spp = 20, .integrator = "path", .maxDepth = 100};
};

TEST_F(SceneCopyFolder, KeepsTheTextWithoutSettings) {
    EXPECT_EQ(copyOf("Film \"image\" \"integer xresolution\" 10 # a comment\nSampler \"halton\"\nWorldBegin\n"
                     "ActiveTransform All Transform [1 0 0 0 0 1 0 0 0 0 1 0 .5e-3 0 0 1] Scale 1 -1 +1\n"
                     "Texture \"t\" \"float\" \"constant\" \"float value\" [.5]\nMaterial \"matte\" \"bool x\" true\n"
                     "MakeNamedMaterial \"string filename\" \"string type\" \"matte\"\nShape \"sphere\" WorldEnd\nX"),
              "# pbrt-v3\nFilm \"image\" \"integer xresolution\" 10\nSampler \"halton\"\nWorldBegin\n"
              "ActiveTransform All\nTransform [ 1 0 0 0 0 1 0 0 0 0 1 0 .5e-3 0 0 1 ]\nScale 1 -1 +1\n"
              "Texture \"t\" \"float\" \"constant\" \"float value\" [ .5 ]\nMaterial \"matte\" \"bool x\" true\n"
              "MakeNamedMaterial \"string filename\" \"string type\" \"matte\"\nShape \"sphere\"\nWorldEnd\n");
}

TEST_F(SceneCopyFolder, ReplacesSettings) {
    EXPECT_EQ(
        copyOf("Integrator \"bdpt\" \"integer maxdepth\" 3 Sampler \"sobol\" \"integer pixelsamples\" [ 4 ]\n"
               "Film \"image\" \"integer xresolution\" [10] \"float scale\" 2 \"string filename\" \"x.png\"\n"
               "WorldBegin\nWorldEnd",
               settings_),
        "# pbrt-v3\nFilm \"image\" \"float scale\" 2 \"string filename\" \"x.png\" \"integer xresolution\" [ 64 ] "
        "\"integer yresolution\" [ 48 ]\nSampler \"halton\" \"integer pixelsamples\" [ 20 ]\n"
        "Integrator \"path\" \"integer maxdepth\" [ 100 ]\nWorldBegin\nWorldEnd\n");
    EXPECT_THAT(copyOf("WorldBegin\nWorldEnd", settings_),
                StartsWith("# pbrt-v3\nFilm \"image\" \"integer xresolution\" [ 64 ]"));
    EXPECT_THAT(copyOf("ColorSpace \"srgb\"\nWorldBegin\n", settings_), HasSubstr("Film \"rgb\" \"integer xreso"));
}

TEST_F(SceneCopyFolder, PutsFilesInThePlaceOfTheirNames) {
    folder_.write("sub/a.pbrt", "Shape \"plymesh\" \"string filename\" [ \"a\\\"b.ply\" ]\nInclude \"b.pbrt\"\n");
    folder_.write("sub/b.pbrt", "Material \"metal\" \"spectrum k\" \"none.spd\"");
    folder_.write("sub/a\"b.ply", "");
    const std::string copy = copyOf("WorldBegin\nInclude \"sub/a.pbrt\"\nShape \"sphere\"\nWorldEnd");
    EXPECT_EQ(copy,
              "# pbrt-v3\nWorldBegin\nShape \"plymesh\" \"string filename\" [ \"" + folder_.path() +
                  "/sub/a\\\"b.ply\" ]\nMaterial \"metal\" \"spectrum k\" \"none.spd\"\nShape \"sphere\"\nWorldEnd\n");
}

TEST_F(SceneCopyFolder, MakesBlocksOfImports) {
    folder_.write("a.pbrt", "Translate 1 0 0\nImport \"b.pbrt\"");
    folder_.write("b.pbrt", "Shape \"sphere\"");
    EXPECT_EQ(copyOf("WorldBegin\nImport \"a.pbrt\"\nShape \"disk\"\nImport \"b.pbrt\""),
              "# pbrt-v4\nWorldBegin\nAttributeBegin\nTranslate 1 0 0\nAttributeBegin\nShape \"sphere\"\nAttributeEnd\n"
              "AttributeEnd\nShape \"disk\"\nAttributeBegin\nShape \"sphere\"\nAttributeEnd\n");
}

TEST_F(SceneCopyFolder, IsTheSameSceneToTheLoader) {
    folder_.write("inner.pbrt", "AttributeBegin Scale 2 2 2 Shape \"sphere\" \"float radius\" [.5] AttributeEnd");
    const std::string text =
        "LookAt 0 0 5 0 0 0 0 1 0 Camera \"perspective\"\nFilm \"image\"\nWorldBegin\n"
        "Include \"inner.pbrt\"\nLightSource \"point\" \"rgb I\" [1 2 3]\nWorldEnd";
    const auto scene = loadPbrtString(copyOf(text, settings_), "/");
    EXPECT_EQ(scene->primitives.size(), 1u);
    EXPECT_EQ(scene->lights.size(), 1u);
    EXPECT_NEAR(scene->bounds().max.x, 1, 1e-5);
    EXPECT_EQ(scene->sensor.settings.film.width, 64);
    EXPECT_EQ(scene->sensor.settings.samplesPerPixel, 20);
    EXPECT_EQ(scene->sensor.settings.maxDepth, 100);
}

TEST_F(SceneCopyFolder, PlacesFaults) {
    const std::string at = folder_.path("scene.pbrt");
    EXPECT_THAT(complaint("WorldBegin\nFrobnicate 1"), StartsWith(at + ":2:1: unknown directive"));
    EXPECT_THAT(complaint("Include \"none.pbrt\"\nWorldBegin"),
                StartsWith(at + ":1:9: cannot find the file to include"));
    EXPECT_THAT(complaint("Camera \"perspective\""), StartsWith(at + ":1:21: the file ends without a WorldBegin"));
    EXPECT_THAT(complaint("WorldBegin\nShape \"sphere\" \"float radius\" [1"), HasSubstr(":2:31: unterminated '['"));
    EXPECT_THAT(complaint("WorldBegin\nShape \"sphere\" \"radius\" 1"), HasSubstr(":2:16: expected a parameter"));
    EXPECT_THAT(complaint("WorldBegin\nShape \"sphere\" \"float radius\""), HasSubstr("expected a value"));
    EXPECT_THAT(complaint("WorldBegin\nShape sphere"), HasSubstr(":2:7: expected string 1 of Shape"));
    EXPECT_THAT(complaint("WorldBegin 3 \"x\nShape"), HasSubstr("unterminated string"));
    EXPECT_THAT(complaint("Include \"scene.pbrt\""), HasSubstr("includes itself"));
    EXPECT_THAT(complaint("7 WorldBegin"), HasSubstr("expected a directive"));
    EXPECT_THAT(errorOf([&] { copyScene(folder_.path("no.pbrt"), {}, [](std::string_view) {}); }),
                HasSubstr("no.pbrt"));
}

}  // namespace
}  // namespace drc::pbrt
