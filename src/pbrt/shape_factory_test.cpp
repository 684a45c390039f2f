// Shapes in scene files.
#include "pbrt/shape_factory.h"

#include <gmock/gmock.h>

#include "base/log.h"
#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::HasSubstr;

// The only primitive of a world, which must load without a warning.
Primitive onlyPrimitive(const std::string& world) {
    forgetWarnings();
    const auto scene = loadWorld(world);
    EXPECT_EQ(warningCount(), 0) << world;
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

// pbrt swaps the ends of a hyperboloid whose second end is in the plane z = 0.
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

TEST(ShapeFactory, TangentsOfMeshes) {
    const std::string triangle = "Shape \"trianglemesh\" \"point P\" [0 0 0 1 0 0 0 1 0] \"integer indices\" [0 1 2] ";
    const TriangleMeshPtr mesh =
        onlyPrimitive("Rotate 90 0 0 1\n" + triangle + "\"vector S\" [1 0 0 0 1 0 0 0 2]").mesh;
    ASSERT_EQ(mesh->tangents.size(), 3u);
    EXPECT_LT(length(mesh->tangents[0] - Vec3(0, 1, 0)), 1e-6f);
    EXPECT_LT(length(mesh->tangents[2] - Vec3(0, 0, 2)), 1e-6f);
    EXPECT_EQ(mesh->bumpTangents, BumpTangents::OppositeUnit);
    EXPECT_EQ(loadWorldV4(triangle)->primitives.at(0).mesh->bumpTangents, BumpTangents::Derivatives);
    EXPECT_THAT(errorOfWorld(triangle + "\"vector S\" [1 0 0]"),
                HasSubstr("must have as many values as 'P', 3, found 1"));
}

TEST(ShapeFactory, AlphaOfEveryShape) {
    for (const char* shape : {"sphere", "disk", "cylinder", "cone", "paraboloid", "hyperboloid"}) {
        const Primitive p = onlyPrimitive("Texture \"m\" \"float\" \"constant\" \"float value\" .5\nShape \"" +
                                          std::string(shape) + "\" \"texture alpha\" \"m\" \"float shadowalpha\" 0");
        EXPECT_EQ(p.alpha, nullptr) << shape;  // a mask that is opaque everywhere
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
    // As in pbrt, normals point against the winding; ReverseOrientation and mirroring apply as for any mesh with
    // normals.
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
    // A triangle that is no more than an edge is left out, between its neighbours too.
    const std::string square = "\n\"point P\" [0 0 0 1 0 0 1 1 0 0 1 0] \"integer nlevels\" 1";
    std::unique_ptr<Scene> scene;
    EXPECT_EQ(
        saidBy([&] { scene = loadWorld("Shape \"loopsubdiv\" \"integer indices\" [0 1 2 2 0 0 0 2 3]" + square); }),
        "drc: s.pbrt:2:20: warning: 1 of the triangles of shape 'loopsubdiv' has the same vertex twice, and is left "
        "out\n");
    EXPECT_EQ(scene->primitives.at(0).mesh->triangleCount(), 8u);
    EXPECT_TRUE(loadWorld("Shape \"loopsubdiv\" \"integer indices\" [0 0 1]" + square)->primitives.empty());
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

// The control points of all pieces in order.
std::vector<Vec3> controlPoints(const Primitive& p) {
    std::vector<Vec3> points;
    for (const Curves::ControlPoint& c : p.shape->asCurves()->controlPoints()) points.push_back(c.p);
    return points;
}

TEST(ShapeFactory, CurvesOfAllKinds) {
    // Wide, so that each segment becomes a single piece.
    const std::string wide = "Shape \"curve\" \"float width\" 100 ";
    const std::string cubic = wide + "\"point P\" [0 0 0 1 3 0 2 3 0 3 0 0 4 -3 0 5 -3 0 6 0 0] ";
    const Primitive bezier = onlyPrimitive("Scale 2 2 2\n" + cubic + "\"integer splitdepth\" 2");
    ASSERT_EQ(bezier.shape->asCurves()->pieceCount(), 2u);
    EXPECT_EQ(controlPoints(bezier)[5], Vec3(8, -6, 0));
    EXPECT_EQ(bezier.shape->asCurves()->controlPoints()[5].radius, 100);
    EXPECT_EQ(bezier.shape->asCurves()->type(), CurveType::Flat);
    // A quadratic curve equals its degree elevation.
    const auto quadratic = controlPoints(onlyPrimitive(wide + "\"integer degree\" 2 \"point P\" [0 0 0 3 3 0 6 0 0]"));
    const Vec3 expected[4] = {Vec3(0, 0, 0), Vec3(2, 2, 0), Vec3(4, 2, 0), Vec3(6, 0, 0)};
    for (size_t i = 0; i < 4; ++i) EXPECT_LT(length(quadratic.at(i) - expected[i]), 1e-5f);
    // A segment of a B-spline begins at (p0 + 4 p1 + p2) / 6, or for degree two halfway between p0 and p1. Segments
    // join.
    const std::string spline = "\"string basis\" \"bspline\" \"point P\" [0 0 0 6 0 0 6 6 0 0 6 0 0 12 0]";
    const auto cubicSpline = controlPoints(onlyPrimitive(wide + spline));
    ASSERT_EQ(cubicSpline.size(), 8u);
    EXPECT_LT(length(cubicSpline[0] - Vec3(5, 1, 0)), 1e-5f);
    EXPECT_LT(length(cubicSpline[3] - Vec3(5, 5, 0)), 1e-5f);
    EXPECT_LT(length(cubicSpline[3] - cubicSpline[4]), 1e-5f);
    EXPECT_LT(length((cubicSpline[3] - cubicSpline[2]) - (cubicSpline[5] - cubicSpline[4])), 1e-5f);
    const auto quadraticSpline = controlPoints(onlyPrimitive(wide + spline + " \"integer degree\" 2"));
    ASSERT_EQ(quadraticSpline.size(), 12u);
    EXPECT_LT(length(quadraticSpline[4] - Vec3(6, 3, 0)), 1e-5f);
    EXPECT_LT(length(quadraticSpline[3] - quadraticSpline[4]), 1e-5f);
}

TEST(ShapeFactory, CurveWidthsAndNormals) {
    const Primitive ribbon = onlyPrimitive(
        "Shape \"curve\" \"string type\" \"ribbon\" \"float width0\" 40 \"float width1\" 80 \"normal N\" [0 0 1 0 0 2 "
        "0 1 0]\n"
        "\"point P\" [0 0 0 1 0 0 2 0 0 3 0 0 4 0 0 5 0 0 6 0 0]");
    const Curves& curves = *ribbon.shape->asCurves();
    ASSERT_EQ(curves.pieceCount(), 1u + 6u);  // where the normals rotate, one piece per 15 degrees
    EXPECT_EQ(curves.controlPoints()[0].radius, 20);
    EXPECT_FLOAT_EQ(curves.controlPoints()[3].radius, 30);
    EXPECT_FLOAT_EQ(curves.controlPoints().back().radius, 40);
    EXPECT_EQ(curves.controlNormals()[3].n, Vec3(0, 0, 1));
    EXPECT_EQ(curves.controlNormals().back().n, Vec3(0, 1, 0));
}

TEST(ShapeFactory, CurveTypes) {
    const auto typeOf = [](const std::string& type) {
        return onlyPrimitive("Shape \"curve\" " + type + " \"point P\" [0 0 0 1 0 0 2 0 0 3 0 0]")
            .shape->asCurves()
            ->type();
    };
    EXPECT_EQ(typeOf(""), CurveType::Flat);
    EXPECT_EQ(typeOf("\"string type\" \"flat\""), CurveType::Flat);
    EXPECT_EQ(typeOf("\"string type\" \"cylinder\""), CurveType::Cylinder);
    EXPECT_EQ(typeOf("\"string type\" \"tube\""), CurveType::Tube);
    EXPECT_EQ(typeOf("\"string type\" \"ribbon\" \"normal N\" [0 0 1 0 0 1]"), CurveType::Ribbon);
}

TEST(ShapeFactory, CurvesThatLookAlikeAreOnePrimitive) {
    const std::string curve = "Shape \"curve\" \"float width\" 9 \"point P\" [0 0 0 1 0 0 2 0 0 3 0 0]\n";
    const std::string tube = "Shape \"curve\" \"string type\" \"cylinder\" \"point P\" [0 0 0 1 0 0 2 0 0 3 0 0]\n";
    const auto scene = loadWorld(curve + "Translate 1 0 0\n" + curve + curve + tube + "Material \"mirror\"\n" + tube +
                                 tube + "AreaLightSource \"diffuse\"\n" + tube + tube);
    std::vector<uint32_t> pieces;
    for (const Primitive& p : scene->primitives) pieces.push_back(p.shape->asCurves()->pieceCount());
    EXPECT_THAT(pieces, testing::ElementsAre(3, 1, 2, 1, 1));
    EXPECT_EQ(scene->lights.size(), 2u);
    EXPECT_EQ(controlPoints(scene->primitives[0])[4], Vec3(1, 0, 0));
}

TEST(ShapeFactory, CurveErrors) {
    const auto errorOfCurve = [](const std::string& params) { return errorOfWorld("Shape \"curve\" " + params); };
    const std::string points = "\"point P\" [0 0 0 1 0 0 2 0 0 3 0 0] ";
    EXPECT_THAT(errorOfCurve(""), HasSubstr("s.pbrt:2:7: shape 'curve' needs the parameter 'P'"));
    EXPECT_THAT(
        errorOfCurve("\"point P\" [0 0 0 1 0 0 2 0 0]"),
        HasSubstr("must have 4 points for a Bezier curve of degree 3, and 3 more for each further segment, found 3"));
    EXPECT_THAT(errorOfCurve(points + "\"integer degree\" 2"), HasSubstr("and 2 more for each"));
    EXPECT_THAT(errorOfCurve(points + "\"integer degree\" 4"), HasSubstr("must be 2 or 3, not 4"));
    EXPECT_THAT(errorOfCurve(points + "\"string basis\" \"hermite\""), HasSubstr("not 'hermite'"));
    EXPECT_THAT(errorOfCurve(points + "\"string type\" \"round\""), HasSubstr("not 'round'"));
    EXPECT_THAT(errorOfCurve(points + "\"string type\" \"ribbon\""), HasSubstr("needs the parameter 'N'"));
    EXPECT_THAT(errorOfCurve(points + "\"string type\" \"ribbon\" \"normal N\" [0 0 1]"), HasSubstr("2, found 1"));
    EXPECT_THAT(errorOfCurve(points + "\"float width\" -1"), HasSubstr("must not be negative"));
    forgetWarnings();
    EXPECT_TRUE(loadWorld("Shape \"curve\" \"point P\" [7 0 0 7 0 0 7 0 0 7 0 0]")->primitives.empty());
    EXPECT_EQ(warningCount(), 1);
}

TEST(ShapeFactory, SaysWhatIsWrong) {
    EXPECT_THAT(errorOfWorld("Shape \"cylinder\" \"float radius\" -1"),
                HasSubstr("s.pbrt:2:18: parameter 'radius' of shape 'cylinder' must be positive"));
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
