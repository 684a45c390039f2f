#include "pbrt/kept_contents.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/folder_testing.h"
#include "image/pfm.h"
#include "pbrt/scene_file.h"

namespace drc::pbrt {
namespace {

const std::string kBall = "Shape \"sphere\" \"float radius\" 0.5\n";
const std::string kMesh = "Shape \"trianglemesh\" \"point P\" [0 0 0  1 0 0  0 1 0] \"integer indices\" [0 1 2]\n";

std::unique_ptr<Scene> load(const std::string& world, KeptContents& kept, const std::string& folder = ".") {
    return loadPbrtString("WorldBegin\n" + world + "WorldEnd\n", folder, {.kept = &kept});
}

TEST(KeptContents, ScenesShareWhatTheyDescribeAlike) {
    KeptContents kept;
    const auto first = load(kMesh + kBall, kept);
    const auto second = load("Material \"mirror\" LightSource \"point\"\n" + kMesh + kBall, kept);
    EXPECT_EQ(first->primitives[0].mesh, second->primitives[0].mesh);
    EXPECT_EQ(first->primitives[1].shape, second->primitives[1].shape);
}

TEST(KeptContents, WhatDiffersIsReadAnew) {
    KeptContents kept;
    const auto first = load(kMesh + kBall, kept);
    for (const std::string change : {"Translate 0 0 1e-3 ", "ReverseOrientation ", "Scale -1 1 1 "}) {
        const auto second = load(change + kMesh + kBall, kept);
        EXPECT_NE(first->primitives[0].mesh, second->primitives[0].mesh) << change;
        EXPECT_NE(first->primitives[1].shape, second->primitives[1].shape) << change;
        load(kMesh + kBall, kept);
    }
    const auto other =
        load("Shape \"trianglemesh\" \"point P\" [0 0 0  1 0 0  0 1 1e-3] \"integer indices\" [0 1 2]\n", kept);
    EXPECT_FLOAT_EQ(other->primitives[0].mesh->positions[2].z, 1e-3f);
}

TEST(KeptContents, OnlyTheLatestSceneIsKept) {
    KeptContents kept;
    std::weak_ptr<const TriangleMesh> mesh;
    mesh = load(kMesh, kept)->primitives[0].mesh;
    EXPECT_FALSE(mesh.expired());
    load(kBall, kept);
    EXPECT_TRUE(mesh.expired());
}

TEST(KeptContents, ScenesFarFromZeroShareToo) {
    KeptContents kept;
    const std::string far = "Translate 1e5 0 0\n" + kMesh;
    const auto first = load(far, kept), second = load(far, kept);
    ASSERT_NE(first->origin, Vec3(0.f));
    EXPECT_EQ(first->origin, second->origin);
    EXPECT_EQ(first->primitives[0].mesh, second->primitives[0].mesh);
    const auto near = load(kMesh, kept);
    EXPECT_EQ(near->origin, Vec3(0.f));
    EXPECT_EQ(near->primitives[0].mesh->positions[1], Vec3(1, 0, 0));
}

TEST(KeptContents, FilesThatChangeAreReadAnew) {
    const TemporaryFolder folder;
    const auto ply = [&](float z) {
        std::ofstream(folder.path() + "/a.ply")
            << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
               "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 "
            << z << "\n1 0 0\n0 1 0\n3 0 1 2\n";
    };
    const auto paint = [&](float value) {
        Image image(4, 4);
        for (float& v : image.data()) v = value;
        std::ofstream(folder.path() + "/a.pfm", std::ios::binary) << encodePfm(image);
    };
    const auto colorOf = [](const Scene& scene) {
        TextureContext at;
        Bsdf bsdf{Frame(), Vec3(0, 0, 1)};
        scene.primitives[0].material->addLobes(at, Rgb(1.f), bsdf);
        return bsdf.albedo(Vec3(0, 0, 1), LobeFlags::NonSpecular).x;
    };
    const std::string world =
        "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"a.pfm\" Material \"matte\" \"texture Kd\" "
        "\"t\"\n"
        "Shape \"plymesh\" \"string filename\" \"a.ply\"\n";
    ply(0.25f), paint(0.5f);
    KeptContents kept;
    const auto first = load(world, kept, folder.path()), second = load(world, kept, folder.path());
    EXPECT_EQ(first->primitives[0].mesh, second->primitives[0].mesh);
    EXPECT_NEAR(colorOf(*second), 0.5f, 1e-3f);
    ply(0.125f), paint(0.75f);
    std::filesystem::last_write_time(folder.path() + "/a.pfm",
                                     std::filesystem::file_time_type::clock::now() + std::chrono::seconds(2));
    std::filesystem::last_write_time(folder.path() + "/a.ply",
                                     std::filesystem::file_time_type::clock::now() + std::chrono::seconds(2));
    const auto third = load(world, kept, folder.path());
    EXPECT_FLOAT_EQ(third->primitives[0].mesh->positions[0].z, 0.125f);
    EXPECT_NEAR(colorOf(*third), 0.75f, 1e-3f);
}

}  // namespace
}  // namespace drc::pbrt
