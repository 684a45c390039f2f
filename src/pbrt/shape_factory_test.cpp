// Shapes as a scene file writes them.
#include "pbrt/shape_factory.h"

#include <gmock/gmock.h>

#include "base/log.h"
#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::HasSubstr;

// The only primitive of a world that must load without a warning.
Primitive onlyPrimitive(const std::string& world) {
    const int before = warningCount();
    const auto scene = loadWorld(world);
    EXPECT_EQ(warningCount(), before) << world;
    EXPECT_EQ(scene->primitives.size(), 1u);
    return scene->primitives.at(0);
}

float areaOf(const std::string& world) { return onlyPrimitive(world).shape->area(); }

TEST(ShapeFactory, ParametersReachTheQuadrics) {
    EXPECT_NEAR(areaOf("Shape \"cylinder\""), 4 * kPi, 1e-4);
    EXPECT_NEAR(areaOf("Shape \"cylinder\" \"float radius\" 2 \"float zmin\" -1 \"float zmax\" 3 \"float phimax\" 180"),
                kPi * 2 * 4, 1e-4);
    EXPECT_NEAR(areaOf("Shape \"cone\""), kPi * std::sqrt(2.f), 1e-4);
    EXPECT_NEAR(areaOf("Shape \"cone\" \"float radius\" 3 \"float height\" 4 \"float phimax\" 90"), kPi * 15 / 4, 1e-4);
    EXPECT_NEAR(areaOf("Shape \"paraboloid\""), kPi / 6 * (std::pow(5.f, 1.5f) - 1), 1e-4);
    EXPECT_NEAR(areaOf("Shape \"paraboloid\" \"float radius\" 2 \"float zmax\" 4 \"float zmin\" 4e-9"),
                kPi * 2 / 96 * (std::pow(68.f, 1.5f) - 8), 1e-3);
    EXPECT_NEAR(areaOf("Shape \"hyperboloid\""), kPi * std::sqrt(6.f), 1e-4);
    EXPECT_NEAR(areaOf("Shape \"hyperboloid\" \"point p1\" [2 0 0] \"point p2\" [2 0 3] \"float phimax\" 180"), kPi * 6,
                1e-4);
}

TEST(ShapeFactory, ReverseOrientationTurnsEveryShape) {
    for (const char* shape : {"sphere", "cylinder", "cone", "paraboloid", "hyperboloid"}) {
        const auto normal = [&](const std::string& before) {
            const Primitive p = onlyPrimitive(before + "Shape \"" + shape + "\"");
            Ray ray;
            ray.o = Vec3(5, 0.1f, 0.3f);
            ray.d = Vec3(-1, 0, 0);
            return p.shape->intersect(ray, 0)->ng.x;
        };
        EXPECT_GT(normal(""), 0) << shape;
        EXPECT_LT(normal("ReverseOrientation\n"), 0) << shape;
    }
}

// pbrt swaps the ends of a hyperboloid whose second one lies in the plane z = 0.
TEST(ShapeFactory, HyperboloidThatEndsAtZeroStartsThere) {
    const auto hit = [](const std::string& points) {
        Ray ray;
        ray.o = Vec3(5, 0, 0.25f);
        ray.d = Vec3(-1, 0, 0);
        return *onlyPrimitive("Shape \"hyperboloid\" " + points).shape->intersect(ray, 0);
    };
    const ShapeHit upward = hit("\"point p1\" [1 0 0] \"point p2\" [2 0 1]");
    const ShapeHit swapped = hit("\"point p1\" [2 0 1] \"point p2\" [1 0 0]");
    EXPECT_NEAR(upward.uv.y, 0.25, 1e-6);
    EXPECT_EQ(swapped.uv.y, upward.uv.y);
    EXPECT_EQ(swapped.ng, upward.ng);
    EXPECT_NEAR(hit("\"point p1\" [2 0 1] \"point p2\" [.9 0 -.1]").uv.y, 0.75 / 1.1, 1e-6);
}

TEST(ShapeFactory, AlphaOfEveryShape) {
    for (const char* shape : {"sphere", "disk", "cylinder", "cone", "paraboloid", "hyperboloid"}) {
        const Primitive p = onlyPrimitive("Texture \"m\" \"float\" \"constant\" \"float value\" .5\nShape \"" +
                                          std::string(shape) + "\" \"texture alpha\" \"m\" \"float shadowalpha\" 0");
        EXPECT_EQ(p.alpha, nullptr) << shape;  // a mask without a hole
        ASSERT_NE(p.shadowAlpha, nullptr) << shape;
        EXPECT_EQ(p.shadowAlpha->eval({}), 0) << shape;
    }
}

TEST(ShapeFactory, LoopSubdivision) {
    const std::string octahedron =
        "Shape \"loopsubdiv\" \"integer indices\" [0 1 4 1 2 4 2 3 4 3 0 4 1 0 5 2 1 5 3 2 5 0 3 5]\n"
        "\"point P\" [1 0 0 0 1 0 -1 0 0 0 -1 0 0 0 1 0 0 -1]\n";
    EXPECT_EQ(onlyPrimitive(octahedron).mesh->triangleCount(), 8u * 64);
    EXPECT_EQ(onlyPrimitive(octahedron + "\"integer nlevels\" 1 \"string scheme\" \"loop\"").mesh->triangleCount(),
              32u);
    // As in pbrt, normals look against the winding; ReverseOrientation and mirrors count as for any mesh with normals.
    const auto outward = [&](const std::string& before) {
        const TriangleMeshPtr mesh = onlyPrimitive(before + octahedron).mesh;
        return dot(mesh->geometricNormal(0), mesh->positions[mesh->indices[0]]) > 0;
    };
    EXPECT_FALSE(outward(""));
    EXPECT_TRUE(outward("ReverseOrientation\n"));
    EXPECT_FALSE(outward("Scale -1 1 1\n"));
    EXPECT_THAT(errorOfWorld("Shape \"loopsubdiv\" \"integer indices\" [0 1 2] \"point P\" [0 0 0 1 0 0 0 1 0]\n"
                             "\"integer nlevels\" -1"),
                HasSubstr("s.pbrt:2:7: the 'nlevels' of a loopsubdiv must not be negative"));
    EXPECT_THAT(errorOfWorld("Shape \"loopsubdiv\" \"integer indices\" [0 1 2 0 1 2] \"point P\" [0 0 0 1 0 0 0 1 0]"),
                HasSubstr("s.pbrt:2:7: cannot load the mesh: the edge between vertices 0 and 1 is in two triangles"));
}

TEST(ShapeFactory, HeightField) {
    const TriangleMeshPtr mesh = onlyPrimitive(
                                     "Translate 1 0 0\nShape \"heightfield\" \"integer nu\" 3 \"integer nv\" 2 "
                                     "\"float Pz\" [0 1 2 3 4 5]")
                                     .mesh;
    EXPECT_EQ(mesh->positions[4], Vec3(1.5f, 1, 4));
    EXPECT_EQ(mesh->triangleCount(), 4u);
    EXPECT_THAT(errorOfWorld("Shape \"heightfield\" \"integer nu\" 3 \"integer nv\" 2 \"float Pz\" [0 1 2 3 4]"),
                HasSubstr("parameter 'Pz' of shape 'heightfield' must have nu times nv values, 6, found 5"));
    EXPECT_THAT(errorOfWorld("Shape \"heightfield\" \"integer nu\" 1 \"integer nv\" 2 \"float Pz\" [0 1]"),
                HasSubstr("must be at least 2"));
}

TEST(ShapeFactory, SaysWhatIsWrong) {
    EXPECT_THAT(errorOfWorld("Shape \"cylinder\" \"float radius\" -1"),
                HasSubstr("s.pbrt:2:7: parameter 'radius' of shape 'cylinder' must be positive"));
    EXPECT_THAT(errorOfWorld("Shape \"sphere\" \"float zmin\" 2"), HasSubstr("nothing of the sphere is between"));
    EXPECT_THAT(errorOfWorld("Shape \"sphere\" \"float zmin\" .5 \"float zmax\" .5"),
                HasSubstr("nothing of the sphere"));
    EXPECT_THAT(errorOfWorld("Shape \"disk\" \"float innerradius\" 1"), HasSubstr("from 0 to less than its 'radius'"));
    EXPECT_THAT(errorOfWorld("Shape \"disk\" \"float innerradius\" -.1"), HasSubstr("'innerradius' of a disk must be"));
    EXPECT_THAT(errorOfWorld("Shape \"cylinder\" \"float zmin\" 1"), HasSubstr("'zmin' equals 'zmax'"));
    EXPECT_THAT(errorOfWorld("Shape \"cone\" \"float height\" 0"), HasSubstr("use a disk for a flat one"));
    EXPECT_THAT(errorOfWorld("Shape \"cone\" \"float phimax\" 0"), HasSubstr("'phimax' of shape 'cone' must be"));
    EXPECT_THAT(errorOfWorld("Shape \"paraboloid\" \"float zmax\" -1"), HasSubstr("must be positive, and they must"));
    EXPECT_THAT(errorOfWorld("Shape \"hyperboloid\" \"point p2\" [1 1 0]"), HasSubstr("must differ in z"));
    EXPECT_THAT(errorOfWorld("Shape \"hyperboloid\" \"point p2\" [0 0 1]"), HasSubstr("must not both lie on"));
}

}  // namespace
}  // namespace drc::pbrt
