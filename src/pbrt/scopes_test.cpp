// What the end of a block restores: every cell of the table "Scopes" in docs/pbrt-dialects.md.
#include <gtest/gtest.h>

#include <functional>

#include "pbrt/scene_file.h"
#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

const std::string kTriangle = "Shape \"trianglemesh\" \"integer indices\" [0 1 2] \"point3 P\" [0 0 0  1 0 0  0 1 0]\n";

bool isRed(const Scene& scene) {
    const Rgb albedo = albedoOf(scene.primitives.at(0));
    return albedo.x > 2 * albedo.y;
}

// A kind of state: `change` changes it, `use` comes after the block, and before a triangle. isChanged tells, from the
// scene, whether the change still holds; it does not if the scene cannot be loaded.
struct Kind {
    std::string name, change, use;
    bool (*isChanged)(const Scene& scene);
};

const bool kStays = true, kEnds = false, kKnown = true;

// Whether a change outlives the end of each block.
struct V3 {
    bool attribute, transform, object;
    bool known = kKnown;
};
struct V4 {
    bool attribute, transform, object, import;
};
struct Row {
    Kind kind;
    V3 v3;
    V4 v4;
};

bool isMoved(const Scene& scene) { return scene.primitives.at(0).mesh->positions[0].x == 1; }
bool isFlipped(const Scene& scene) { return scene.primitives.at(0).mesh->flipNormal; }
bool emits(const Scene& scene) { return scene.primitives.at(0).areaLight != nullptr; }

// Both dialects understand these words where the table has columns of both.
std::vector<Row> rows(bool v3) {
    const std::string red = v3 ? "\"matte\" \"rgb Kd\" [.5 .1 .1]" : "\"diffuse\" \"rgb reflectance\" [.5 .1 .1]";
    const std::string named = v3 ? "\"string type\" \"matte\" \"rgb Kd\" [.5 .1 .1]"
                                 : "\"string type\" \"diffuse\" \"rgb reflectance\" [.5 .1 .1]";
    const std::string textured =
        v3 ? "Material \"matte\" \"texture Kd\" \"t\"" : "Material \"diffuse\" \"texture reflectance\" \"t\"";
    return {
        {{"transformation", "Translate 1 0 0", "", isMoved}, {kEnds, kEnds, kEnds}, {kEnds, kEnds, kEnds, kEnds}},
        {{"active transformations", "ActiveTransform EndTime", "Translate 1 0 0",
          // While only that of the end is active, the triangle moves.
          [](const Scene& scene) { return !scene.instances.empty(); }},
         {kEnds, kEnds, kEnds},
         {kEnds, kEnds, kEnds, kEnds}},
        {{"named coordinate system", "Translate 1 0 0 CoordinateSystem \"c\"", "CoordSysTransform \"c\"", isMoved},
         {kStays, kStays, kStays},
         {kStays, kStays, kStays, kEnds}},
        {{"material", "Material " + red, "", isRed}, {kEnds, kStays, kEnds}, {kEnds, kEnds, kEnds, kEnds}},
        {{"named material", "MakeNamedMaterial \"m\" " + named, "NamedMaterial \"m\"", isRed},
         {kEnds, kStays, kEnds},
         {kStays, kStays, kStays, kStays}},
        {{"spectrum texture", "Texture \"t\" \"spectrum\" \"constant\" \"rgb value\" [.5 .1 .1]", textured, isRed},
         {kEnds, kStays, kEnds},
         {kStays, kStays, kStays, kStays}},
        {{"float texture", "Texture \"f\" \"float\" \"constant\" \"float value\" 0",
          "Shape \"sphere\" \"texture alpha\" \"f\"",
          [](const Scene& scene) { return scene.primitives.at(0).alpha != nullptr; }},
         {kEnds, kStays, kEnds},
         {kStays, kStays, kStays, kStays}},
        {{"area light", "AreaLightSource \"diffuse\"", "", emits},
         {kEnds, kStays, kEnds},
         {kEnds, kEnds, kEnds, kEnds}},
        {{"orientation", "ReverseOrientation", "", isFlipped}, {kEnds, kStays, kEnds}, {kEnds, kEnds, kEnds, kEnds}},
        {{"medium interface", "MakeNamedMedium \"m\" \"string type\" \"homogeneous\" MediumInterface \"m\" \"\"", "",
          [](const Scene& scene) { return scene.primitives.at(0).media.changes(); }},
         {kEnds, kStays, kEnds},
         {kEnds, kEnds, kEnds, kEnds}},
        {{"named medium", "MakeNamedMedium \"m\" \"string type\" \"homogeneous\"", "MediumInterface \"m\" \"\"",
          [](const Scene& scene) { return scene.primitives.at(0).media.changes(); }},
         {kStays, kStays, kStays},
         {kStays, kStays, kStays, kStays}},
        {{"colour space", "ColorSpace \"rec2020\"", "Material \"diffuse\" \"rgb reflectance\" [.5 .4 .3]",
          [](const Scene& scene) { return albedoOf(scene.primitives.at(0)).x > .55f; }},
         {kEnds, kEnds, kEnds, !kKnown},
         {kEnds, kEnds, kEnds, kEnds}},
        {{"defaults of Attribute", "Attribute \"material\" \"rgb reflectance\" [.5 .1 .1]", "Material \"diffuse\"",
          isRed},
         {kEnds, kEnds, kEnds, !kKnown},
         {kEnds, kEnds, kEnds, kEnds}},
    };
}

std::string blocksOf(const std::string& begin, const std::string& end, const Kind& kind) {
    return begin + "\n" + kind.change + "\n" + end + "\n" + kind.use + "\n" + kTriangle;
}
bool holds(const Kind& kind, const std::function<std::unique_ptr<Scene>()>& load) {
    try {
        return kind.isChanged(*load());
    } catch (const Error&) {
        return false;
    }
}
// The state at the end of a block of the kind.
bool outlives(const Kind& kind, bool v3, const std::string& begin, const std::string& end) {
    const std::string world = blocksOf(begin, end, kind);
    return holds(kind, [&] { return v3 ? loadWorld(world) : loadWorldV4(world); });
}

TEST(Scopes, WhatHoldsWithoutABlock) {
    for (const bool v3 : {true, false})
        for (const Row& row : rows(v3)) {
            if (v3 && !row.v3.known) continue;
            Kind unchanged = row.kind;
            unchanged.change = "";
            EXPECT_TRUE(outlives(row.kind, v3, "", "")) << row.kind.name;
            EXPECT_FALSE(outlives(unchanged, v3, "", "")) << row.kind.name << ": the test could not fail";
        }
}

TEST(Scopes, Blocks) {
    const struct {
        std::string begin, end;
        bool V3::*v3;
        bool V4::*v4;
    } blocks[] = {{"AttributeBegin", "AttributeEnd", &V3::attribute, &V4::attribute},
                  {"TransformBegin", "TransformEnd", &V3::transform, &V4::transform},
                  {"ObjectBegin \"o\"", "ObjectEnd", &V3::object, &V4::object}};
    for (const auto& block : blocks) {
        for (const Row& row : rows(true)) {
            if (!row.v3.known) continue;
            EXPECT_EQ(outlives(row.kind, true, block.begin, block.end), row.v3.*block.v3)
                << row.kind.name << " in pbrt-v3's " << block.begin;
        }
        for (const Row& row : rows(false))
            EXPECT_EQ(outlives(row.kind, false, block.begin, block.end), row.v4.*block.v4)
                << row.kind.name << " in pbrt-v4's " << block.begin;
    }
}

TEST(Scopes, Import) {
    const TemporaryFolder folder;
    for (const Row& row : rows(false)) {
        folder.write("part.pbrt", row.kind.change + "\n");
        const std::string world = "Import \"part.pbrt\"\n" + row.kind.use + "\n" + kTriangle;
        EXPECT_EQ(holds(row.kind, [&] { return loadWorldV4(world, folder.path()); }), row.v4.import) << row.kind.name;
        const std::string included = "Include \"part.pbrt\"\n" + row.kind.use + "\n" + kTriangle;
        EXPECT_TRUE(holds(row.kind, [&] { return loadWorldV4(included, folder.path()); })) << row.kind.name;
    }
}

// Objects, lights and shapes are parts of the scene wherever they are defined.
TEST(Scopes, WhatIsAddedToTheSceneStays) {
    for (const bool v3 : {true, false}) {
        const std::string world = "AttributeBegin ObjectBegin \"o\" " + kTriangle +
                                  " ObjectEnd LightSource \"point\" " + kTriangle +
                                  " AttributeEnd ObjectInstance \"o\"";
        const auto scene = v3 ? loadWorld(world) : loadWorldV4(world);
        EXPECT_EQ(scene->instances.size(), 1u);
        EXPECT_EQ(scene->lights.size(), 1u);
        EXPECT_EQ(scene->primitives.size(), 1u);
    }
}

// WorldBegin resets the transformation and which are active, and nothing else.
TEST(Scopes, WorldBegin) {
    const auto scene = loadPbrtString(
        "Attribute \"material\" \"rgb reflectance\" [.5 .1 .1]\nTranslate 1 0 0 CoordinateSystem \"c\"\n"
        "ActiveTransform EndTime\nWorldBegin\nMaterial \"diffuse\"\n" +
            kTriangle + "CoordSysTransform \"c\" " + kTriangle + "CoordSysTransform \"world\" " + kTriangle,
        ".", {}, "s.pbrt");
    ASSERT_EQ(scene->primitives.size(), 3u);
    EXPECT_TRUE(isRed(*scene));
    EXPECT_EQ(scene->primitives[0].mesh->positions[0].x, 0);
    EXPECT_EQ(scene->primitives[1].mesh->positions[0].x, 1);
    EXPECT_EQ(scene->primitives[2].mesh->positions[0].x, 0);
}

// A material and a texture that are defined again: the latest definition counts for what comes after it.
TEST(Scopes, NamesCanBeDefinedAgain) {
    const auto scene = loadWorldV4(
        "MakeNamedMaterial \"m\" \"string type\" \"diffuse\" \"rgb reflectance\" [.5 .1 .1]\nNamedMaterial \"m\"\n" +
        kTriangle +
        "AttributeBegin MakeNamedMaterial \"m\" \"string type\" \"diffuse\" \"rgb reflectance\" [.1 .5 .1] "
        "AttributeEnd\n" +
        kTriangle + "NamedMaterial \"m\"\n" + kTriangle);
    ASSERT_EQ(scene->primitives.size(), 3u);
    EXPECT_NEAR(albedoOf(scene->primitives[1]).x, .5f, 1e-5f);
    EXPECT_NEAR(albedoOf(scene->primitives[2]).y, .5f, 1e-5f);
}

}  // namespace
}  // namespace drc::pbrt
