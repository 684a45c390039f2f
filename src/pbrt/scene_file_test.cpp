#include "pbrt/scene_file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <cstdlib>
#include <fstream>
#include <thread>

#include "base/log.h"
#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kTriangle = "Shape \"trianglemesh\" \"integer indices\" [0 1 2] \"point P\" [0 0 0  1 0 0  0 1 0]\n";

// Number of new warnings that f causes.
template <typename F>
int warningsOf(const F& f) {
    forgetWarnings();
    f();
    return warningCount();
}

TEST(SceneFile, DefaultsArePbrts) {
    const auto scene = loadWorld("");
    const RenderSettings& s = scene->sensor.settings;
    EXPECT_EQ(s.film.width, 1280);
    EXPECT_EQ(s.film.height, 720);
    EXPECT_EQ(s.filter->radius(), Vec2(0.5f, 0.5f));
    EXPECT_EQ(s.integrator, "path");
    EXPECT_EQ(s.maxDepth, 5);
    EXPECT_EQ(s.sampler, "halton");
    EXPECT_EQ(s.samplesPerPixel, 16);
    EXPECT_EQ(s.outputFile, "pbrt.exr");
    ASSERT_NE(scene->sensor.camera, nullptr);
}

TEST(SceneFile, SettingsOfTheFile) {
    const auto scene = loadPbrtString(
        "Integrator \"iispt\" \"integer maxdepth\" 9 \"float rrthreshold\" .5 \"string lightsamplestrategy\" "
        "\"uniform\"\n"
        "Sampler \"stratified\" \"integer xsamples\" 3 \"integer ysamples\" 5\nAccelerator \"kdtree\"\n"
        "PixelFilter \"gaussian\" \"float xwidth\" 3 \"float ywidth\" 1.5\n"
        "Film \"image\" \"integer xresolution\" 64 \"integer yresolution\" 32 \"float cropwindow\" [.5 1 .25 0]\n"
        "  \"float scale\" 2 \"float maxsampleluminance\" 10 \"float diagonal\" 35 \"string filename\" \"a.png\"\n"
        "WorldBegin\nWorldEnd\n");
    const RenderSettings& s = scene->sensor.settings;
    EXPECT_EQ(s.integrator, "iispt");
    EXPECT_EQ(s.maxDepth, 9);
    EXPECT_EQ(s.samplesPerPixel, 15);
    EXPECT_EQ(s.filter->radius(), Vec2(3, 1.5f));
    EXPECT_EQ(s.film.width, 64);
    EXPECT_THAT(s.cropWindow, testing::ElementsAre(.5f, 1, 0, .25f));
    EXPECT_EQ(s.filmScale, 2);
    EXPECT_EQ(s.maxSampleLuminance, 10);
    EXPECT_EQ(s.outputFile, "a.png");
}

TEST(SceneFile, ResolutionCanBeOverridden) {
    const auto scene = loadPbrtString("WorldBegin WorldEnd", ".", {FilmGeometry{40, 30}});
    EXPECT_EQ(scene->sensor.settings.film.width, 40);
    EXPECT_EQ(scene->sensor.settings.film.height, 30);
}

TEST(SceneFile, NamedMaterialsAreSharedAndShapesMayOverrideThem) {
    const auto scene = loadWorld(
        "MakeNamedMaterial \"m\" \"string type\" \"plastic\" \"float roughness\" .2\n"
        "NamedMaterial \"m\"\n" +
        kTriangle + kTriangle +
        "Shape \"sphere\" \"float roughness\" .3 \"float radius\" 2\n"
        "Material \"none\"\n" +
        kTriangle + "Material \"\"\n" + kTriangle);
    ASSERT_EQ(scene->primitives.size(), 5u);
    EXPECT_EQ(scene->primitives[0].material, scene->primitives[1].material);
    ASSERT_NE(scene->primitives[0].material, nullptr);
    EXPECT_NE(scene->primitives[2].material, scene->primitives[0].material);
    EXPECT_EQ(scene->primitives[3].material, nullptr);
    EXPECT_EQ(scene->primitives[4].material, nullptr);
}

TEST(SceneFile, NamesEndWithTheirBlock) {
    EXPECT_EQ(warningsOfWorld("AttributeBegin\nMakeNamedMaterial \"m\" \"string type\" \"matte\"\nAttributeEnd\n"
                              "NamedMaterial \"m\""),
              "drc: s.pbrt:5:15: warning: no material 'm' has been named; the material before it stays\n");
}

TEST(SceneFile, AreaLightsKeepTheirPlaceAmongTheLights) {
    const auto scene = loadWorld(
        "LightSource \"point\" \"rgb I\" [1 1 1]\nAttributeBegin\n"
        "AreaLightSource \"area\" \"rgb L\" [2 2 2] \"bool twosided\" \"true\"\n" +
        kTriangle + "Shape \"disk\"\nAttributeEnd\n" + kTriangle +
        "LightSource \"infinite\" \"rgb L\" [1 2 3] \"rgb scale\" [2 2 2]\n"
        "LightSource \"distant\" \"point from\" [0 0 1] \"point to\" [0 0 0]\n");
    ASSERT_EQ(scene->lights.size(), 5u);
    EXPECT_EQ(scene->lights[1], scene->primitives[0].areaLight);
    EXPECT_EQ(scene->lights[2], scene->primitives[1].areaLight);
    EXPECT_EQ(scene->primitives[2].areaLight, nullptr);
    EXPECT_EQ(scene->lights[3]->escaped(Vec3(0.f), Vec3(0, 0, 1)), Rgb(2, 4, 6));
    EXPECT_TRUE(scene->lights[0]->isDelta());
    EXPECT_TRUE(scene->lights[4]->isDelta());
}

TEST(SceneFile, Instances) {
    const auto scene = loadWorld("Translate 1 0 0\nObjectBegin \"o\"\nTranslate 0 2 0\n" + kTriangle +
                                 "ObjectEnd\nTranslate 0 0 3\nObjectInstance \"o\"\nIdentity\nObjectInstance \"o\"\n");
    EXPECT_TRUE(scene->primitives.empty());
    ASSERT_EQ(scene->objects.size(), 1u);
    ASSERT_EQ(scene->instances.size(), 2u);
    const Vec3 p = scene->objects[0].primitives.at(0).mesh->positions[0];
    EXPECT_EQ(p, Vec3(1, 2, 0));
    EXPECT_EQ(scene->instances[0].objectToWorld.start().point(p), Vec3(2, 2, 3));
    EXPECT_EQ(scene->instances[1].objectToWorld.start().point(p), Vec3(1, 2, 0));
    EXPECT_EQ(scene->triangleCount(), 2u);
    EXPECT_EQ(warningsOfWorld("ObjectInstance \"p\""),
              "drc: s.pbrt:2:16: warning: no object 'p' has been defined; the instance is left out\n");
    EXPECT_THAT(warningsOfWorld("ObjectBegin \"p\" ObjectBegin \"q\" ObjectEnd ObjectEnd"),
                HasSubstr("s.pbrt:2:17: warning: ObjectBegin inside of another object, which ends here"));
    EXPECT_THAT(errorOfWorldV4("ObjectBegin \"p\" ObjectBegin \"q\""),
                HasSubstr("s.pbrt:2:17: ObjectBegin inside of another object"));
}

TEST(SceneFile, AlphaMasks) {
    const auto scene =
        loadWorld("Texture \"m\" \"float\" \"constant\" \"float value\" .5\n" + kTriangle +
                  "\"float alpha\" 0 \"texture shadowalpha\" \"m\"\n" + kTriangle + "\"float alpha\" 1\n");
    ASSERT_NE(scene->primitives[0].alpha, nullptr);
    EXPECT_NE(scene->primitives[0].shadowAlpha, scene->primitives[0].alpha);
    EXPECT_EQ(scene->primitives[1].alpha, nullptr);
}

TEST(SceneFile, NamedButUnbuiltThingsAreWarningsAndTheRestIsLoaded) {
    std::unique_ptr<Scene> scene;
    const int warnings = warningsOf([&] {
        scene = loadPbrtString(
            "WorldBegin\n"
            "Shape \"nurbs\" \"integer nu\" 2\n"
            "Texture \"f\" \"spectrum\" \"ptex\" \"float gamma\" 2\nMakeNamedMedium \"fog\" \"string type\" "
            "\"heterogeneous\"\n"
            "MediumInterface \"\" \"fog\"\nShape \"sphere\"\nMaterial \"matte\" \"texture Kd\" \"f\"\n" +
                kTriangle + "WorldEnd",
            ".", {}, "unbuilt.pbrt");
    });
    EXPECT_EQ(warnings, 3);
    EXPECT_EQ(scene->primitives.size(), 2u);
    EXPECT_TRUE(scene->lights.empty());
}

// In either dialect, what a scene has in thousands of places is said once for its kind.
TEST(SceneFile, OneWarningForAKind) {
    std::string textures, shapes;
    for (int i = 0; i < 50; ++i) {
        const std::string name = "t" + std::to_string(i);
        textures += "Texture \"" + name + "\" \"spectrum\" \"ptex\" \"string filename\" \"" + name + ".ptx\"\n";
        textures += "Texture \"" + name + "\" \"float\" \"ptex\" \"string filename\" \"" + name + ".ptx\"\n";
        shapes += kTriangle + " \"string tomorrow\" \"yes\"\n" + kTriangle + " \"bool today\" \"true\"\n";
    }
    for (const bool v4 : {false, true}) {
        const std::string material =
            v4 ? "Material \"diffuse\" \"texture reflectance\" \"t7\"\n" : "Material \"matte\" \"texture Kd\" \"t7\"\n";
        forgetWarnings();
        testing::internal::CaptureStderr();
        const auto scene = v4 ? loadWorldV4(textures + material + shapes) : loadWorld(textures + material + shapes);
        EXPECT_EQ(
            testing::internal::GetCapturedStderr(),
            "drc: s.pbrt:2:25: warning: texture 'ptex' is not supported yet; the constant 0.5 is used (and 99 more)\n"
            "drc: s.pbrt:104:2: warning: unknown parameter 'tomorrow' of shape 'trianglemesh'; ignored (and 49 more)\n"
            "drc: s.pbrt:106:2: warning: unknown parameter 'today' of shape 'trianglemesh'; ignored (and 49 more)\n");
        EXPECT_EQ(warningCount(), 3);
        ASSERT_EQ(scene->primitives.size(), 100u);
        Bsdf bsdf(Frame(), Vec3(0, 0, 1));
        scene->primitives[0].material->addLobes({}, Rgb(1.f), bsdf);
        EXPECT_EQ(bsdf.albedo(Vec3(0, 0, 1)), Rgb(0.5f));
    }
}

TEST(SceneErrors, CutShort) {
    EXPECT_EQ(errorOfScene("WorldBegin\nAttributeBegin\n"),
              "s.pbrt:3:1: the file ends before the AttributeEnd of AttributeBegin in line 2 of s.pbrt\n    \n    ^");
    EXPECT_EQ(errorOfScene("Translate 1 2 3\nWorldBegin"),
              "s.pbrt:2:11: the file ends before the WorldEnd of WorldBegin in line 2 of s.pbrt\n"
              "    WorldBegin\n              ^");
    EXPECT_THAT(errorOfScene(""), StartsWith("s.pbrt:1:1: the file ends without a WorldBegin"));
    EXPECT_EQ(errorOfScene("WorldBegin\nShape \"sphere\" \"float radius\" [1"),
              "s.pbrt:2:31: unterminated '[': the file ends before the ']' of parameter 'radius' of shape 'sphere'\n"
              "    Shape \"sphere\" \"float radius\" [1\n"
              "                                  ^");
    EXPECT_EQ(errorOfScene("WorldBegin\nShape \"sph"),
              "s.pbrt:2:7: unterminated string: there is no closing '\"' on this line\n"
              "    Shape \"sph\n          ^");
}

TEST(SceneErrors, CutAnywhereASceneIsAnErrorAndNeverACrash) {
    const std::string whole =
        "LookAt 0 0 1 0 0 0 0 1 0 Camera \"perspective\" \"float fov\" [40] WorldBegin AttributeBegin "
        "Material \"matte\" \"rgb Kd\" [.1 .2 .3] " +
        kTriangle + "AttributeEnd WorldEnd";
    for (size_t n = 0; n < whole.size(); ++n) EXPECT_NE(errorOfScene(whole.substr(0, n)), "") << whole.substr(0, n);
    EXPECT_EQ(errorOfScene(whole), "");
}

TEST(SceneErrors, Blocks) {
    EXPECT_THAT(errorOfWorldV4("AttributeEnd"), StartsWith("s.pbrt:2:1: AttributeEnd without AttributeBegin"));
    EXPECT_THAT(
        errorOfWorldV4("AttributeBegin\nTransformEnd"),
        StartsWith("s.pbrt:3:1: TransformEnd where the AttributeBegin in line 2 of s.pbrt must be ended first"));
    EXPECT_THAT(errorOfWorldV4("AttributeBegin"),
                StartsWith("s.pbrt:3:1: the file ends before the AttributeEnd of AttributeBegin in line 2 of s.pbrt"));
    EXPECT_THAT(errorOfWorld("Camera \"perspective\""), StartsWith("s.pbrt:2:1: Camera must come before WorldBegin"));
    EXPECT_THAT(errorOfScene("Shape \"sphere\""), StartsWith("s.pbrt:1:1: Shape must come after WorldBegin"));
}

TEST(SceneErrors, UnknownNames) {
    EXPECT_EQ(errorOfWorld("  Shpae \"sphere\""),
              "s.pbrt:2:3: unknown directive 'Shpae'; did you mean 'Shape'?\n      Shpae \"sphere\"\n      ^");
    EXPECT_EQ(errorOfWorld("Material \"mat\" \"rgb Kd\" [1 1 1]"),
              "s.pbrt:2:10: unknown material 'mat'\n    Material \"mat\" \"rgb Kd\" [1 1 1]\n             ^");
    EXPECT_THAT(errorOfWorld("Material \"plastik\""), HasSubstr("unknown material 'plastik'; did you mean 'plastic'?"));
    EXPECT_THAT(errorOfWorld("Shape \"cube\""), HasSubstr("s.pbrt:2:7: unknown shape 'cube'"));
    EXPECT_THAT(errorOfWorld("LightSource \"sun\""), HasSubstr("unknown light 'sun'"));
    EXPECT_THAT(errorOfWorld("Texture \"t\" \"spectrum\" \"noise\""), HasSubstr("unknown texture 'noise'"));
    EXPECT_THAT(errorOfWorld("Texture \"t\" \"rgb\" \"constant\""), HasSubstr("must be of type 'float' or 'spectrum'"));
    EXPECT_THAT(errorOfScene("PixelFilter \"tent\" WorldBegin WorldEnd"), HasSubstr("unknown pixel filter 'tent'"));
    EXPECT_THAT(errorOfScene("Sampler \"best\" WorldBegin WorldEnd"), HasSubstr("unknown sampler 'best'"));
    EXPECT_THAT(errorOfScene("Camera \"fisheye\" WorldBegin WorldEnd"), HasSubstr("unknown camera 'fisheye'"));
    EXPECT_THAT(errorOfWorldV4("Material \"diffuse\" \"texture reflectance\" \"wood\""),
                HasSubstr("no spectrum texture 'wood' has been defined"));
    EXPECT_THAT(errorOfWorld("\"sphere\""), HasSubstr("expected a directive, found the string \"sphere\""));
}

TEST(SceneErrors, Meshes) {
    EXPECT_THAT(errorOfWorld("Shape \"trianglemesh\" \"point P\" [0 0 0]"), HasSubstr("needs the parameter 'indices'"));
    EXPECT_THAT(errorOfWorld("Shape \"trianglemesh\" \"integer indices\" [0 1 3] \"point P\" [0 0 0 1 0 0 0 1 0]"),
                HasSubstr("parameter 'indices' of shape 'trianglemesh' has the vertex 3, but 'P' has only 3 vertices"));
    EXPECT_THAT(errorOfWorld("Shape \"trianglemesh\" \"integer indices\" [0 -1 2] \"point P\" [0 0 0 1 0 0 0 1 0]"),
                HasSubstr("has the vertex -1"));
    EXPECT_THAT(errorOfWorld("Shape \"trianglemesh\" \"integer indices\" [0 1] \"point P\" [0 0 0 1 0 0 0 1 0]"),
                HasSubstr("must have three values a triangle, found 2"));
    EXPECT_THAT(errorOfWorld(kTriangle + "\"normal N\" [0 0 1]"),
                HasSubstr("must have as many values as 'P', 3, found 1"));
    EXPECT_THAT(errorOfWorld(kTriangle + "\"float uv\" [0 0 1]"),
                HasSubstr("must have two values a vertex, 6, found 3"));
}

TEST(SceneFiles, MissingOnesSayWhatWasTried) {
    const TemporaryFolder folder;
    EXPECT_EQ(errorOfWorld("Shape \"plymesh\" \"string filename\" \"a.ply\"", folder.path()),
              "s.pbrt:2:35: cannot find the PLY file 'a.ply'; tried '" + folder.path() +
                  "/a.ply'\n"
                  "    Shape \"plymesh\" \"string filename\" \"a.ply\"\n"
                  "                                      ^");
    EXPECT_THAT(errorOfWorld("Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"a.png\"", folder.path()),
                HasSubstr("cannot find the texture 'a.png'; tried '" + folder.path() + "/a.png'"));
    EXPECT_THAT(errorOfWorld("LightSource \"infinite\" \"string mapname\" \"a.exr\"", folder.path()),
                HasSubstr("cannot find the environment map 'a.exr'"));
    EXPECT_EQ(errorOf([] { loadPbrtFile("/absent.pbrt"); }),
              "cannot read scene file '/absent.pbrt': No such file or directory");
}

// Editors on Windows may save text as UTF-16, with a mark or without.
TEST(SceneFiles, TextInUtf16IsNamed) {
    const TemporaryFolder folder;
    for (const bool bigEndian : {false, true})
        for (const bool marked : {false, true}) {
            std::string text;
            const auto add = [&](int c) {
                const char bytes[] = {char(c >> 8), char(c & 255)};
                text += bytes[bigEndian ? 0 : 1];
                text += bytes[bigEndian ? 1 : 0];
            };
            if (marked) add(0xFEFF);
            for (const char c : std::string("WorldBegin\nWorldEnd\n")) add(c);
            const std::string path = folder.write("wide.pbrt", text);
            EXPECT_THAT(errorOf([&] { loadPbrtFile(path); }),
                        StartsWith(path + ":1:1: the text is in UTF-16; save the file as UTF-8"));
            EXPECT_THAT(errorOfWorld("Include \"wide.pbrt\"", folder.path()),
                        HasSubstr("wide.pbrt:1:1: the text is in UTF-16"));
        }
}

// A scene may come from another program: `generate | drc render /dev/stdin`.
TEST(SceneFiles, AScenePipedIn) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/pipe";
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    const auto loadPiped = [&](const std::string& text) {
        std::thread writer([&] { std::ofstream(path) << text; });
        std::unique_ptr<Scene> scene;
        const std::string error = errorOf([&] { scene = loadPbrtFile(path); });
        writer.join();
        return std::pair(std::move(scene), error);
    };
    // Larger than a pipe holds.
    std::string world = "WorldBegin\n";
    for (int i = 0; i < 2000; ++i) world += kTriangle;
    EXPECT_EQ(loadPiped(world + "WorldEnd\n").first->primitives.size(), 2000u);
    EXPECT_THAT(loadPiped("WorldBegin\nShpe\n").second, StartsWith(path + ":2:1: unknown directive"));
    EXPECT_THAT(loadPiped("").second, HasSubstr("the file ends without a WorldBegin"));
}

TEST(SceneFiles, VerticesThatNoTriangleUsesMayBeAnywhere) {
    const TemporaryFolder folder;
    const auto meshOf = [&](const std::string& face) {
        folder.write("m.ply",
                     "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                     "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                     "nan 1e30 -inf\n1 0 0\n0 1 0\n0 0 1\n" +
                         face);
        return loadWorld("Shape \"plymesh\" \"string filename\" \"m.ply\"", folder.path());
    };
    const auto scene = meshOf("3 1 2 3\n");
    const TriangleMesh& mesh = *scene->primitives.at(0).mesh;
    for (const Vec3& p : mesh.positions) EXPECT_LE(length(p), 1) << p;
    EXPECT_THAT(errorOf([&] { meshOf("3 0 2 3\n"); }), HasSubstr("the mesh has a vertex at no number"));
}

TEST(SceneFiles, DamagedMeshIsReportedAtItsShape) {
    const TemporaryFolder folder;
    folder.write("a.ply", "ply\nformat ascii 1.0\n");
    EXPECT_THAT(
        errorOfWorld(kTriangle + "Shape \"plymesh\" \"string filename\" \"a.ply\"", folder.path()),
        AllOf(StartsWith("s.pbrt:3:7: cannot load the mesh: "), HasSubstr("a.ply:2:1: the PLY file ends within")));
    folder.write("b.png", "this is no picture");
    EXPECT_THAT(errorOfWorld("Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"b.png\"", folder.path()),
                AllOf(StartsWith("s.pbrt:2:53: "), HasSubstr("b.png")));
}

TEST(SceneFiles, IncludesFindTheirFilesBesideThemThenBesideTheScene) {
    const TemporaryFolder folder;
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    folder.write("main.ply", ply + "1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n");
    folder.write("sub/near.ply", ply + "2 0 0\n0 1 0\n0 0 1\n3 0 1 2\n");
    folder.write("sub/part.pbrt",
                 "Shape \"plymesh\" \"string filename\" \"near.ply\"\n"
                 "Shape \"plymesh\" \"string filename\" \"main.ply\"\n");
    const auto scene = loadPbrtFile(folder.write("main.pbrt", "WorldBegin\nInclude \"sub/part.pbrt\"\nWorldEnd\n"));
    ASSERT_EQ(scene->primitives.size(), 2u);
    EXPECT_EQ(scene->primitives[0].mesh->positions[0].x, 2);
    EXPECT_EQ(scene->primitives[1].mesh->positions[0].x, 1);
}

TEST(SceneFiles, IncludeErrors) {
    const TemporaryFolder folder;
    folder.write("a.pbrt", "Include \"b.pbrt\"\n");
    const std::string b = folder.write("b.pbrt", "\n  Include \"a.pbrt\"\n");
    EXPECT_EQ(errorOfWorld("Include \"a.pbrt\"", folder.path()),
              b + ":2:11: '" + folder.path() + "/a.pbrt' includes itself\n      Include \"a.pbrt\"\n              ^");
    EXPECT_THAT(errorOfWorld("Include \"absent.pbrt\"", folder.path()),
                StartsWith("s.pbrt:2:9: cannot find the file to include 'absent.pbrt'"));
    for (int i = 0; i < 100; ++i)
        folder.write("deep" + std::to_string(i) + ".pbrt", "Include \"deep" + std::to_string(i + 1) + ".pbrt\"\n");
    EXPECT_THAT(errorOfWorld("Include \"deep0.pbrt\"", folder.path()),
                HasSubstr("deep62.pbrt:1:9: Include is nested more than 64 files deep"));
    folder.write("error.pbrt", "Identity\nWorldBgin\n");
    EXPECT_THAT(errorOfWorld("Include \"error.pbrt\"", folder.path()), HasSubstr("error.pbrt:2:1: unknown directive"));
    folder.write("open.pbrt", "Shape \"sphere\" \"float radius\" [1\n");
    EXPECT_THAT(errorOfWorld("Include \"open.pbrt\"\n] ", folder.path()),
                HasSubstr("open.pbrt:1:31: unterminated '['"));
}

// Loads every scene of a folder outside the project (DRC_SHARED, or a folder beside the project).
TEST(SceneFiles, SharedScenesLoadWithoutWarnings) {
    const char* variable = std::getenv("DRC_SHARED");
    const std::filesystem::path root = variable != nullptr ? variable : DRC_SOURCE_DIR "/../shared";
    if (!std::filesystem::is_directory(root / "scenes")) GTEST_SKIP() << "no scenes in " << root;
    for (const auto& entry : std::filesystem::directory_iterator(root / "scenes")) {
        const auto file = entry.path() / "scene.pbrt";
        if (!std::filesystem::exists(file)) continue;
        const int warnings = warningsOf([&] {
            const std::string error = errorOf([&] {
                const auto scene = loadPbrtFile(file.string(), {FilmGeometry{32, 32}});
                EXPECT_GT(scene->triangleCount(), 0u) << file;
                EXPECT_FALSE(scene->lights.empty()) << file;
            });
            EXPECT_EQ(error, "") << file;
        });
        EXPECT_EQ(warnings, 0) << file;
    }
}

}  // namespace
}  // namespace drc::pbrt
