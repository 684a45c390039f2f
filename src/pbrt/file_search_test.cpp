#include "pbrt/file_search.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "image/image_io.h"
#include "pbrt/test_scenes.h"
#include "scene/scene.h"

namespace drc::pbrt {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
std::string plyAt(int x) { return kPly + std::to_string(x) + " 0 0\n0 1 0\n0 0 1\n3 0 1 2\n"; }
std::string shape(const std::string& file) { return "Shape \"plymesh\" \"string filename\" \"" + file + "\"\n"; }
float firstX(const Scene& scene, size_t k) { return scene.primitives.at(k).mesh->positions[0].x; }

// For each kind of file there is one beside the included file and one beside the scene, with different contents.
TEST(FileSearch, EveryKindOfFileIsFoundBesideTheFileThatNamesIt) {
    const TemporaryFolder folder;
    for (const std::string& where : {std::string(), std::string("parts/")}) {
        const bool near = !where.empty();
        folder.write(where + "m.ply", plyAt(near ? 2 : 1));
        Image image(1, 1);
        image.setRgb(0, 0, near ? Rgb(0, 1, 0) : Rgb(1, 0, 0));
        folder.write(where + "t.png", encodePng(image));
        folder.write(where + "s.spd", near ? "300 0.25\n900 0.25\n" : "300 0.75\n900 0.75\n");
        // The lens file beside the scene has no aperture and is refused.
        folder.write(where + "l.dat", near ? "50 6 1.5 30\n-50 45 1 30\n" : "50 6 1.5 0\n-50 45 1 30\n");
    }
    folder.write("parts/camera.pbrt", "Camera \"realistic\" \"string lensfile\" \"l.dat\"\n");
    folder.write("parts/world.pbrt",
                 "LightSource \"infinite\" \"string mapname\" \"t.png\"\n"
                 "LightSource \"point\" \"spectrum I\" \"s.spd\"\n"
                 "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"t.png\"\n"
                 "Material \"matte\" \"texture Kd\" \"t\"\n" +
                     shape("m.ply"));
    const auto scene = loadPbrtFile(folder.write(
        "scene.pbrt", "Include \"parts/camera.pbrt\"\nWorldBegin\nInclude \"parts/world.pbrt\"\nWorldEnd\n"));
    EXPECT_EQ(firstX(*scene, 0), 2);
    EXPECT_NEAR(scene->lights.at(0)->escaped(Vec3(0.f), Vec3(0, 0, 1)).y, 1, 1e-3f);
    EXPECT_EQ(scene->lights.at(0)->escaped(Vec3(0.f), Vec3(0, 0, 1)).x, 0);
    EXPECT_NEAR(luminance(scene->lights.at(1)->sample(Vec3(0, 0, 1), Vec2(0.5f))->radiance), 0.25f, 0.01f);
}

TEST(FileSearch, IncludesWithinIncludesStartFromTheirOwnFolders) {
    const TemporaryFolder folder;
    folder.write("a/b/c.pbrt", shape("m.ply") + "Include \"../d.pbrt\"\n");
    folder.write("a/b/m.ply", plyAt(3));
    folder.write("a/d.pbrt", shape("b/m.ply") + shape("../m.ply"));
    folder.write("a/main.pbrt", "Include \"b/c.pbrt\"\n");
    folder.write("m.ply", plyAt(1));
    const auto scene = loadPbrtFile(
        folder.write("scene.pbrt", "WorldBegin\nInclude \"a/main.pbrt\"\n" + shape("m.ply") + "WorldEnd\n"));
    ASSERT_EQ(scene->primitives.size(), 4u);
    EXPECT_EQ(firstX(*scene, 0), 3);
    EXPECT_EQ(firstX(*scene, 1), 3);
    EXPECT_EQ(firstX(*scene, 2), 1);
    EXPECT_EQ(firstX(*scene, 3), 1);
}

TEST(FileSearch, AbsolutePathsAndOddNames) {
    const TemporaryFolder folder;
    folder.write("in here/a mesh (1).ply", plyAt(4));
    folder.write("back\\slash.ply", plyAt(5));
    folder.write("\xc3\xbc.ply", plyAt(6));
    const auto scene = loadWorld(shape(folder.path() + "/in here/a mesh (1).ply") + shape("in here/a mesh (1).ply") +
                                     shape("./in here/../in here//a mesh (1).ply") + shape("back\\\\slash.ply") +
                                     shape("\xc3\xbc.ply"),
                                 folder.path());
    const float expected[] = {4, 4, 4, 5, 6};
    for (size_t k = 0; k < 5; ++k) EXPECT_EQ(firstX(*scene, k), expected[k]) << k;
    // Windows' path separators are escapes, as in pbrt; written as such, they separate folders.
    EXPECT_THAT(errorOfWorld(shape("in here\\mesh.ply"), folder.path()), HasSubstr("write folders with '/'"));
    folder.write("part/sub/m.ply", plyAt(7));
    EXPECT_EQ(firstX(*loadWorld(shape("part\\\\sub\\\\m.ply"), folder.path()), 0), 7);
    EXPECT_THAT(errorOfWorld(shape("part\\\\none.ply"), folder.path()),
                AllOf(HasSubstr("/part\\none.ply'"), HasSubstr("/part/none.ply'")));
}

TEST(FileSearch, ASceneBehindALinkFindsWhatStandsBesideTheScene) {
    const TemporaryFolder folder;
    folder.write("real/m.ply", plyAt(7));
    const std::string scene = folder.write("real/scene.pbrt", "WorldBegin\n" + shape("m.ply") + "WorldEnd\n");
    const std::string link = folder.path() + "/link.pbrt";
    fs::create_symlink(scene, link);
    EXPECT_EQ(firstX(*loadPbrtFile(link), 0), 7);
    folder.write("m.ply", plyAt(8));
    EXPECT_EQ(firstX(*loadPbrtFile(link), 0), 8);
}

TEST(FileSearch, WhatIsNoFileIsRefusedBeforeItIsOpened) {
    const TemporaryFolder folder;
    const std::string pipe = folder.path() + "/pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const auto named = [&](const std::string& directive) { return errorOfWorld(directive, folder.path()); };
    for (const std::string name : {"pipe", "/dev/zero"}) {
        SCOPED_TRACE(name);
        const std::string quoted = "\"" + name + "\"";
        for (const std::string& directive :
             {"Include " + quoted, "Shape \"plymesh\" \"string filename\" " + quoted,
              "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" " + quoted,
              "Material \"matte\" \"spectrum Kd\" " + quoted, "LightSource \"infinite\" \"string mapname\" " + quoted})
            EXPECT_THAT(named(directive), AllOf(HasSubstr("s.pbrt:2:"), HasSubstr(name + "', which is no file but a")));
    }
    EXPECT_THAT(named("Include \"" + folder.path() + "\""), HasSubstr("', a folder"));
    EXPECT_THAT(named("Include \"\""), HasSubstr("the name of the file to include is empty"));
    EXPECT_THAT(named(std::string("Include \"a\0b\"", 13)), HasSubstr("has a zero byte in it"));
    fs::create_symlink("one", folder.path() + "/two");
    fs::create_symlink("two", folder.path() + "/one");
    EXPECT_THAT(named("Include \"one\""), HasSubstr("cannot find the file to include 'one'"));
}

}  // namespace
}  // namespace drc::pbrt
