// Blocks that do not nest: pbrt-v3 goes on, and keeps states and transformations on stacks of their own.
#include "pbrt/blocks.h"

#include <gmock/gmock.h>

#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::HasSubstr;

const std::string kTriangle = "Shape \"trianglemesh\" \"integer indices\" [0 1 2] \"point3 P\" [0 0 0  1 0 0  0 1 0]\n";

// Loads a pbrt-v3 world, with a triangle after it, that must give a warning with this text.
std::unique_ptr<Scene> loadWith(const std::string& warning, const std::string& world) {
    std::unique_ptr<Scene> scene;
    EXPECT_THAT(saidBy([&] { scene = loadWorld(world + "\n" + kTriangle); }), HasSubstr(warning)) << world;
    return scene;
}
float xOf(const Scene& scene) { return scene.origin.x + scene.primitives.back().mesh->positions[0].x; }
bool isMirror(const Scene& scene) {
    Bsdf bsdf(Frame(), Vec3(0, 0, 1));
    scene.primitives.back().material->addLobes({}, Rgb(1.f), bsdf);
    return bsdf.albedo(Vec3(0, 0, 1)).x > .8f;
}

TEST(BlocksV3, EndsWithoutABeginningAreIgnored) {
    for (const std::string& kind : std::vector<std::string>{"Attribute", "Transform", "Object"}) {
        const auto scene = loadWith("s.pbrt:2:17: warning: " + kind + "End without " + kind + "Begin; ignored",
                                    "Translate 1 0 0 " + kind + "End");
        EXPECT_EQ(xOf(*scene), 1);
        EXPECT_THAT(errorOfWorldV4(kind + "End"), HasSubstr(kind + "End without " + kind + "Begin"));
    }
}

TEST(BlocksV3, StatesAndTransformationsEndOnTheirOwn) {
    // There is no state to end.
    auto scene = loadWith("s.pbrt:3:1: warning: AttributeEnd without AttributeBegin; ignored",
                          "Translate 1 0 0 TransformBegin Translate 2 0 0\nAttributeEnd");
    EXPECT_EQ(xOf(*scene), 3);
    // The state is that of the AttributeBegin, the transformation that of the TransformBegin.
    scene =
        loadWith("s.pbrt:4:1: warning: AttributeEnd where the TransformBegin in line 3 of s.pbrt should be ended first",
                 "AttributeBegin Material \"mirror\" Translate 1 0 0\nTransformBegin Translate 2 0 0\nAttributeEnd");
    EXPECT_EQ(xOf(*scene), 1);
    EXPECT_FALSE(isMirror(*scene));
    scene = loadWith("s.pbrt:4:1: warning: AttributeEnd where",
                     "AttributeBegin Material \"mirror\" Translate 1 0 0\nTransformBegin Translate 2 0 0\nAttributeEnd "
                     "TransformEnd");
    EXPECT_EQ(xOf(*scene), 0);
    scene =
        loadWith("s.pbrt:3:1: warning: TransformEnd where the AttributeBegin in line 2 of s.pbrt should be ended first",
                 "Translate 1 0 0 AttributeBegin Material \"mirror\" Translate 2 0 0\nTransformEnd");
    EXPECT_EQ(xOf(*scene), 1);
    EXPECT_TRUE(isMirror(*scene));
    scene = loadWith("s.pbrt:3:1: warning: TransformEnd where",
                     "Translate 1 0 0 AttributeBegin Material \"mirror\" Translate 2 0 0\nTransformEnd AttributeEnd");
    EXPECT_EQ(xOf(*scene), 1);
    EXPECT_FALSE(isMirror(*scene));
}

TEST(BlocksV3, ObjectsEndTheStateBelowThem) {
    const auto scene = loadWith("s.pbrt:3:1: warning: ObjectEnd where the AttributeBegin in line 2",
                                "AttributeBegin Material \"mirror\" Translate 1 0 0\nObjectEnd");
    EXPECT_EQ(xOf(*scene), 0);
    EXPECT_FALSE(isMirror(*scene));
}

TEST(BlocksV3, WorldEndEndsAll) {
    const auto scene =
        loadWith("s.pbrt:5:1: warning: WorldEnd comes before the AttributeEnd of AttributeBegin in line 2 of s.pbrt",
                 "AttributeBegin Translate 1 0 0");
    EXPECT_EQ(xOf(*scene), 1);
}

}  // namespace
}  // namespace drc::pbrt
