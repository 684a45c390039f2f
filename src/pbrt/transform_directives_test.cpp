// Transform directives, tested by the resulting positions of a point light or a vertex.
#include <gmock/gmock.h>

#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::HasSubstr;

void expectNear(const Vec3& a, const Vec3& b) { EXPECT_LT(length(a - b), 1e-5f) << a << " is not " << b; }

const std::string kTriangle =
    "Shape \"trianglemesh\" \"integer indices\" [0 1 2] \"point P\" [1 2 3  4 2 3  1 5 3] \"normal N\" [0 0 1 0 0 1 0 "
    "0 1]\n";

// The position to which the directives transform the point (1, 2, 3).
Vec3 placed(const std::string& directives) {
    const auto scene = loadWorld(directives + "\n" + kTriangle);
    return scene->primitives.at(0).mesh->positions[0] + scene->origin;
}

TEST(TransformDirectives, MoveScaleAndTurn) {
    expectNear(placed(""), Vec3(1, 2, 3));
    expectNear(placed("Translate 10 20 30"), Vec3(11, 22, 33));
    expectNear(placed("Scale 2 3 -1"), Vec3(2, 6, -3));
    expectNear(placed("Rotate 90 0 0 1"), Vec3(-2, 1, 3));
    expectNear(placed("Rotate 90 1 0 0"), Vec3(1, -3, 2));
    expectNear(placed("Translate 1 0 0 Scale 2 2 2"), Vec3(3, 4, 6));
    expectNear(placed("Scale 2 2 2 Translate 1 0 0"), Vec3(4, 4, 6));
    expectNear(placed("Translate 1 1 1 Identity"), Vec3(1, 2, 3));
}

TEST(TransformDirectives, MatricesAreWrittenColumnByColumn) {
    const std::string matrix = " [0 1 0 0  -1 0 0 0  0 0 2 0  5 6 7 1]";  // x' = 5 - y, y' = 6 + x, z' = 7 + 2 z
    expectNear(placed("Translate 100 0 0 Transform" + matrix), Vec3(3, 7, 13));
    expectNear(placed("Translate 100 0 0 ConcatTransform" + matrix), Vec3(103, 7, 13));
    expectNear(placed("ConcatTransform" + matrix + " Scale 2 2 2"), Vec3(1, 8, 19));
}

TEST(TransformDirectives, LookAt) {
    // From (0, 0, 5) towards the origin with y up: the eye goes to the origin, the target to +z, and x is turned round.
    expectNear(placed("LookAt 0 0 5  0 0 0  0 1 0"), Vec3(-1, 2, 2));
}

TEST(TransformDirectives, NamedCoordinateSystems) {
    expectNear(placed("Translate 1 0 0 CoordinateSystem \"a\" Translate 5 5 5 CoordSysTransform \"a\""), Vec3(2, 2, 3));
    const auto scene =
        loadPbrtString("Translate 0 0 7\nCamera \"perspective\"\nWorldBegin\nCoordSysTransform \"camera\"\n" +
                       kTriangle + "WorldEnd\n");
    expectNear(scene->primitives.at(0).mesh->positions[0], Vec3(1, 2, -4));
    expectNear(scene->sensor.camera->position(), Vec3(0, 0, -7));
    // As in both versions of pbrt.
    EXPECT_THAT(
        warningsOfWorld("CoordSysTransform \"camrea\""),
        HasSubstr("s.pbrt:2:1: warning: no coordinate system 'camrea' has been named; the transformation stays"));
}

TEST(TransformDirectives, BlocksRestore) {
    expectNear(placed("AttributeBegin Translate 9 9 9 AttributeEnd"), Vec3(1, 2, 3));
    expectNear(placed("TransformBegin Translate 9 9 9 TransformEnd"), Vec3(1, 2, 3));
    const auto scene = loadWorld("TransformBegin ReverseOrientation TransformEnd\n" + kTriangle);
    EXPECT_TRUE(scene->primitives[0].mesh->flipNormal) << "TransformEnd must restore transformations alone";
}

TEST(TransformDirectives, OrientationOfMeshes) {
    const auto flip = [](const std::string& directives) {
        const auto mesh = loadWorld(directives + "\n" + kTriangle)->primitives.at(0).mesh;
        return std::pair(mesh->flipNormal, mesh->normals[0].z);
    };
    EXPECT_EQ(flip(""), std::pair(false, 1.f));
    EXPECT_EQ(flip("ReverseOrientation"), std::pair(true, -1.f));
    EXPECT_EQ(flip("Scale -1 1 1"), std::pair(true, 1.f));
    EXPECT_EQ(flip("Scale -1 1 1 ReverseOrientation"), std::pair(false, -1.f));
    EXPECT_EQ(flip("Scale 1 1 -2"), std::pair(true, -1.f));
}

TEST(TransformDirectives, SingularAndMalformedOnesAreErrors) {
    EXPECT_EQ(errorOfWorld("  Scale 1 0 1"),
              "s.pbrt:2:3: this transformation cannot be inverted\n      Scale 1 0 1\n      ^");
    EXPECT_THAT(errorOfWorld("Rotate 90 0 0 0"), HasSubstr("cannot be inverted"));
    EXPECT_THAT(errorOfWorld("LookAt 1 1 1  1 1 1  0 1 0"),
                HasSubstr("s.pbrt:2:1: LookAt looks from a point to the same"));
    EXPECT_THAT(errorOfWorld("LookAt 1 1 1  1 3 1  0 1 0"), HasSubstr("LookAt looks along its up vector"));
    EXPECT_THAT(errorOfWorld("LookAt 1 1 1  -2 -2 -2  5 5 5"), HasSubstr("LookAt looks along its up vector"));
    EXPECT_THAT(errorOfWorld("LookAt 1 1 1  1 3 1  0 0 0"), HasSubstr("the up vector of LookAt"));
    EXPECT_THAT(errorOfWorld("Translate 1 2"), HasSubstr("s.pbrt:3:1: expected number 3 of the 3 of Translate, found "
                                                         "'WorldEnd'"));
    EXPECT_THAT(errorOfWorld("Transform [1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 5]"), HasSubstr("expected ']' after the 16"));
}

// Spheres, instances and the rest divide by w as meshes and cameras do.
TEST(TransformDirectives, WDividesEverything) {
    const std::string w2 = "ConcatTransform [1 0 0 0 0 1 0 0 0 0 1 0 2 0 0 2]\n";
    for (const std::string& shape : std::vector<std::string>{
             "Shape \"sphere\"", "Shape \"disk\"", "Shape \"cylinder\"", "Shape \"cone\"", "Shape \"paraboloid\"",
             "Shape \"hyperboloid\" \"point p1\" [1 0 0]", "Shape \"curve\" \"point P\" [0 0 0 1 0 0 2 1 0 3 0 0]"}) {
        const auto half = loadWorld("Translate 1 0 0 Scale .5 .5 .5 " + shape), divided = loadWorld(w2 + shape);
        const Bounds a = half->bounds(), b = divided->bounds();
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(a.min[i], b.min[i], 1e-5f) << shape;
            EXPECT_NEAR(a.max[i], b.max[i], 1e-5f) << shape;
        }
    }
    const std::string object = "ObjectBegin \"o\"\n" + kTriangle + "ObjectEnd\n";
    EXPECT_NEAR(loadWorld(object + w2 + "ObjectInstance \"o\"")->bounds().max.y,
                loadWorld(object + "Scale .5 .5 .5 ObjectInstance \"o\"")->bounds().max.y, 1e-5f);
}

TEST(TransformDirectives, PerspectiveMakesMeshes) {
    const std::string perspective = "ConcatTransform [1 0 0 0 0 1 0 0 0 0 1 .2 0 0 0 1]\n";
    const Bounds b = loadWorld(perspective + "Shape \"sphere\"")->bounds();
    EXPECT_NEAR(b.min.z, -1 / .8f, 1e-4f);
    EXPECT_NEAR(b.max.z, 1 / 1.2f, 1e-4f);
    EXPECT_THAT(errorOfWorld(perspective + "Scale 9 9 9 Shape \"sphere\""),
                HasSubstr("moves a part of it to infinity"));
    EXPECT_THAT(errorOfWorld("ObjectBegin \"o\"\n" + kTriangle + "ObjectEnd\n" + perspective + "ObjectInstance \"o\""),
                HasSubstr("cannot have a transformation with perspective"));
    EXPECT_THAT(errorOfWorld(perspective + "Shape \"curve\" \"point P\" [0 0 0 1 0 0 2 1 0 3 0 0]"),
                HasSubstr("such a shape cannot have a transformation with perspective"));
}

}  // namespace
}  // namespace drc::pbrt
