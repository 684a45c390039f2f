#include "pbrt/mesh_files.h"

#include <gmock/gmock.h>

#include "pbrt/ply_reader.h"
#include "pbrt/ply_writer.h"
#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TriangleMesh square() {
    TriangleMesh mesh;
    mesh.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, .5f)};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

TEST(PlyWriter, WritesWhatTheReaderReads) {
    const TemporaryFolder folder;
    TriangleMesh mesh = square();
    writePly(mesh, folder.path("plain.ply"));
    const TriangleMesh plain = readPly(folder.path("plain.ply"));
    EXPECT_EQ(plain.positions, mesh.positions);
    EXPECT_EQ(plain.indices, mesh.indices);
    EXPECT_THAT(plain.normals, IsEmpty());
    EXPECT_THAT(plain.uvs, IsEmpty());
    mesh.normals = {Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(0, 0, 1)};
    mesh.uvs = {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(.25f, 1)};
    writePly(mesh, folder.path("all.ply"));
    const TriangleMesh all = readPly(folder.path("all.ply"));
    EXPECT_EQ(all.positions, mesh.positions);
    EXPECT_EQ(all.normals, mesh.normals);
    EXPECT_EQ(all.uvs, mesh.uvs);
    EXPECT_EQ(all.indices, mesh.indices);
}

TEST(PlyWriter, NamesAFileThatItCannotWrite) {
    EXPECT_THAT(errorOf([] { writePly(square(), "/nowhere/a.ply"); }), HasSubstr("/nowhere/a.ply"));
}

TEST(MeshFiles, AreWoundAlongTheGeometricNormal) {
    const TriangleMesh plain = woundAlongNormals(square(), Vec3(10, 0, 0));
    EXPECT_EQ(plain.indices, square().indices);
    EXPECT_THAT(plain.uvs, IsEmpty());
    EXPECT_EQ(plain.positions[1], Vec3(11, 0, 0));

    TriangleMesh flipped = square();
    flipped.flipNormal = true;
    const Vec3 normal = flipped.geometricNormal(0);
    const TriangleMesh turned = woundAlongNormals(flipped, Vec3(0.f));
    EXPECT_FALSE(turned.flipNormal);
    EXPECT_EQ(turned.geometricNormal(0), normal);
    // The corners keep the texture coordinates that they had by their order.
    ASSERT_EQ(turned.uvs.size(), 6u);
    for (size_t i = 0; i < 3; ++i) {
        const uint32_t corner = turned.indices[i];
        const Vec2 expected = turned.positions[corner] == Vec3(0, 0, 0)   ? Vec2(0, 0)
                              : turned.positions[corner] == Vec3(1, 0, 0) ? Vec2(1, 0)
                                                                          : Vec2(1, 1);
        EXPECT_EQ(turned.uvs[corner], expected);
    }

    TriangleMesh shaded = square();
    shaded.normals.assign(4, Vec3(0, 0, -1));
    shaded.uvs = {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
    const TriangleMesh byNormals = woundAlongNormals(shaded, Vec3(0.f));
    EXPECT_THAT(byNormals.indices, ElementsAre(0, 2, 1, 0, 3, 2));
    EXPECT_EQ(byNormals.uvs, shaded.uvs);
}

TEST(MeshFiles, AreInTheFilesWorldSpace) {
    const TemporaryFolder folder;
    SceneListing listing;
    LoadOptions options;
    options.listing = &listing;
    const std::string triangle = "Shape \"trianglemesh\" \"integer indices\" [0 1 2] \"point P\" [0 0 0 1 0 0 0 1 0]\n";
    loadPbrtString("WorldBegin\nShape \"sphere\"\nTranslate 100000 0 0\n" + triangle + "ObjectBegin \"o\" " + triangle +
                       "ObjectEnd\nWorldEnd",
                   ".", options);
    const auto files = writeMeshFiles(listing, folder.path("a/meshes"));
    ASSERT_EQ(files.size(), 3u);
    EXPECT_THAT(files[0].path, IsEmpty());
    EXPECT_EQ(files[1].path, folder.path("a/meshes/1.ply"));
    EXPECT_EQ(files[1].triangles, 1u);
    EXPECT_EQ(files[1].vertices, 3u);
    EXPECT_EQ(files[1].bounds.max, Vec3(100001, 1, 0));
    EXPECT_EQ(readPly(files[1].path).positions[0], Vec3(100000, 0, 0));
    EXPECT_EQ(readPly(files[2].path).positions[0], Vec3(100000, 0, 0));  // as the object has it
    folder.write("file", "");
    EXPECT_THAT(errorOf([&] { writeMeshFiles(listing, folder.path("file")); }), HasSubstr("file"));
}

}  // namespace
}  // namespace drc::pbrt
