#include "scene/shapes/projected_shape.h"

#include <gmock/gmock.h>

#include "base/folder_testing.h"
#include "scene/shapes/shape_cylinder.h"
#include "scene/shapes/shape_sphere.h"

namespace drc {
namespace {

// Points beyond z = 0 shrink.
const Transform kPerspective({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, .2, 1});

TEST(ProjectedShape, HasItsPointsAndNormalsWhereTheTransformationMovesThem) {
    const TriangleMesh mesh = projectedShape(*makeSphere({.radius = 1}), kPerspective);
    const Transform back = kPerspective.inverse();
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3 p = back.point(mesh.positions[i]);
        EXPECT_NEAR(length(p), 1, 1e-5f);
        // A point a little outside stays outside, and the normal is that of the surface there.
        const Vec3 n = mesh.normals[i];
        EXPECT_GT(length(back.point(mesh.positions[i] + n * 1e-3f)), 1);
        Vec3 along = cross(n, std::abs(n.x) < .5f ? Vec3(1, 0, 0) : Vec3(0, 1, 0));
        EXPECT_NEAR(length(back.point(mesh.positions[i] + along * 1e-3f)), 1, 4e-6f);
    }
    double outwards = 0;
    for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
        outwards += dot(mesh.geometricNormal(t), mesh.positions[mesh.indices[3 * t]]) >= 0;
    EXPECT_GT(outwards / mesh.triangleCount(), .98) << "those at the poles have no area";
}

TEST(ProjectedShape, OfAnAffineTransformationIsTheShape) {
    const auto cylinder = makeCylinder({.radius = 2, .zMin = -1, .zMax = 3});
    const TriangleMesh mesh = projectedShape(*cylinder, Transform());
    double area = 0;
    for (uint32_t t = 0; t < mesh.triangleCount(); ++t) area += double(mesh.area(t));
    EXPECT_NEAR(area / double(cylinder->area()), 1, 1e-4);
    EXPECT_TRUE(isAffine(Transform::scale(2, 3, 4)));
    EXPECT_FALSE(isAffine(kPerspective));
}

TEST(ProjectedShape, MustNotReachInfinity) {
    EXPECT_THAT(errorOf([] { projectedShape(*makeSphere({.radius = 6}), kPerspective); }),
                testing::HasSubstr("moves a part of it to infinity"));
}

}  // namespace
}  // namespace drc
