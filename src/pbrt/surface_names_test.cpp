#include "scene/surface_names.h"

#include <gmock/gmock.h>

#include "pbrt/test_scenes.h"
#include "scene/scene.h"

namespace drc::pbrt {
namespace {

using testing::EndsWith;

constexpr const char* kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n0 1 0\n0 0 1\n3 0 1 2\n";

std::unique_ptr<Scene> withNames(const TemporaryFolder& folder, const std::string& world) {
    LoadOptions options;
    options.names = true;
    return loadPbrtFile(folder.write("scene.pbrt", world), options);
}
SurfaceName nameOf(const Scene& scene, const Primitive& primitive) { return scene.names.at(primitive.name); }

TEST(SurfaceNames, AreThoseOfTheFile) {
    const TemporaryFolder folder;
    folder.write("m.ply", kPly);
    folder.write("part.pbrt", "# a ball\nShape \"sphere\"\n");
    const auto scene = withNames(folder,
                                 "WorldBegin\nMakeNamedMaterial \"Walnut\" \"string type\" \"plastic\"\n"
                                 "NamedMaterial \"Walnut\"\nShape \"plymesh\" \"string filename\" \"m.ply\"\n"
                                 "Include \"part.pbrt\"\nMaterial \"mirror\"\nShape \"sphere\"\n"
                                 "Material \"none\"\nShape \"disk\"\nWorldEnd\n");
    ASSERT_EQ(scene->primitives.size(), 4u);
    const SurfaceName mesh = nameOf(*scene, scene->primitives[0]), ball = nameOf(*scene, scene->primitives[1]),
                      mirror = nameOf(*scene, scene->primitives[2]), none = nameOf(*scene, scene->primitives[3]);
    EXPECT_EQ(mesh.material, "Walnut");
    EXPECT_EQ(mesh.materialKind, "plastic");
    EXPECT_EQ(mesh.shapeKind, "plymesh");
    EXPECT_EQ(mesh.meshFile, "m.ply");
    EXPECT_THAT(mesh.file, EndsWith("scene.pbrt"));
    EXPECT_EQ(mesh.line, 4);
    EXPECT_EQ(ball.material, "Walnut");
    EXPECT_EQ(ball.shapeKind, "sphere");
    EXPECT_EQ(ball.meshFile, "");
    EXPECT_THAT(ball.file, EndsWith("part.pbrt"));
    EXPECT_EQ(ball.line, 2);
    EXPECT_EQ(mirror.material, "");
    EXPECT_EQ(mirror.materialKind, "mirror");
    EXPECT_EQ(mirror.line, 7);
    EXPECT_EQ(none.materialKind, "none");
}

TEST(SurfaceNames, AreThoseOfPbrtV4Too) {
    const TemporaryFolder folder;
    const auto scene = withNames(folder,
                                 "Film \"rgb\"\nWorldBegin\nShape \"sphere\"\nAttributeBegin\n"
                                 "MakeNamedMaterial \"Oak\" \"string type\" \"coateddiffuse\"\nNamedMaterial \"Oak\"\n"
                                 "Shape \"disk\"\nAttributeEnd\nShape \"cylinder\"\n");
    ASSERT_EQ(scene->primitives.size(), 3u);
    EXPECT_EQ(nameOf(*scene, scene->primitives[0]).materialKind, "diffuse");
    EXPECT_EQ(nameOf(*scene, scene->primitives[1]).material, "Oak");
    EXPECT_EQ(nameOf(*scene, scene->primitives[1]).materialKind, "coateddiffuse");
    EXPECT_EQ(nameOf(*scene, scene->primitives[2]).material, "");
}

// Also of what moves within an object, which is an object of its own.
TEST(SurfaceNames, OfObjectsAreTheirOwn) {
    const TemporaryFolder folder;
    const auto scene = withNames(
        folder,
        "WorldBegin\nObjectBegin \"chair\"\nShape \"sphere\"\nActiveTransform EndTime\nTranslate 0 0 1\n"
        "ActiveTransform All\nShape \"disk\"\nObjectEnd\nObjectInstance \"chair\"\nShape \"cone\"\nWorldEnd\n");
    ASSERT_EQ(scene->instances.size(), 2u);
    std::vector<std::string> kinds;
    for (const Instance& instance : scene->instances) {
        const ObjectDefinition& object = scene->objects[size_t(instance.object)];
        EXPECT_EQ(object.name, "chair");
        kinds.emplace_back(nameOf(*scene, object.primitives.at(0)).shapeKind);
    }
    EXPECT_EQ(kinds, (std::vector<std::string>{"sphere", "disk"}));
    EXPECT_EQ(nameOf(*scene, scene->primitives.at(0)).shapeKind, "cone");
}

// Hair comes as one shape for each curve, and has one row for all that become one primitive.
TEST(SurfaceNames, OfJoinedCurvesAreOneRow) {
    const TemporaryFolder folder;
    std::string world = "WorldBegin\n";
    for (int i = 0; i < 50; ++i)
        world += "Shape \"curve\" \"point P\" [0 0 0  0 0 1  0 1 1  1 1 " + std::to_string(i) + "]\n";
    const auto scene = withNames(folder, world + "WorldEnd\n");
    EXPECT_EQ(scene->primitives.size(), 1u);
    EXPECT_EQ(scene->names.size(), 1u);
    EXPECT_EQ(nameOf(*scene, scene->primitives[0]).line, 2);
}

TEST(SurfaceNames, AreKeptOnlyForThoseWhoAsk) {
    const auto scene = loadWorld("Shape \"sphere\"");
    EXPECT_EQ(scene->names.size(), 0u);
    EXPECT_EQ(scene->primitives.at(0).name, SurfaceNames::kNone);
}

}  // namespace
}  // namespace drc::pbrt
