#include "scene/shapes/triangle_mesh.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

TriangleMesh triangle() {
    TriangleMesh m;
    m.positions = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 1, 0)};
    m.indices = {0, 1, 2};
    return m;
}

TEST(TriangleMesh, NormalFollowsTheWindingAsInPbrt) {
    TriangleMesh m = triangle();
    EXPECT_EQ(m.geometricNormal(0), Vec3(0, 0, 1));
    EXPECT_EQ(m.area(0), 1);
    m.flipNormal = true;
    EXPECT_EQ(m.geometricNormal(0), Vec3(0, 0, -1));
    m.indices = {0, 2, 1};
    EXPECT_EQ(m.geometricNormal(0), Vec3(0, 0, 1));
}

TEST(TriangleMesh, ShadingNormalsDecide) {
    TriangleMesh m = triangle();
    m.normals.assign(3, normalize(Vec3(1, 0, -0.5f)));
    EXPECT_EQ(m.geometricNormal(0), Vec3(0, 0, -1));
    m.flipNormal = true;
    EXPECT_EQ(m.geometricNormal(0), Vec3(0, 0, -1));
    m.normals.assign(3, Vec3(0, 0, 1));
    EXPECT_EQ(m.geometricNormal(0), Vec3(0, 0, 1));
}

TEST(TriangleMesh, Degenerate) {
    TriangleMesh m = triangle();
    m.positions[2] = Vec3(1, 0, 0);
    EXPECT_EQ(m.geometricNormal(0), Vec3(0, 0, 0));
    EXPECT_EQ(m.area(0), 0);
    // A very small triangle is not degenerate.
    m = triangle();
    for (Vec3& p : m.positions) p *= 1e-15f;
    EXPECT_EQ(m.geometricNormal(0), Vec3(0, 0, 1));
}

TEST(TriangleMesh, ApplyTransformsNormalsAsNormals) {
    for (const bool withNormals : {false, true})
        for (const Transform& t : {Transform::scale(-1, 2, 3), Transform::rotate(30, Vec3(1, 2, 3)),
                                   Transform::translate(Vec3(1, 2, 3)) * Transform::scale(1, 1, -0.25f)}) {
            TriangleMesh m = triangle();
            m.positions[1] = Vec3(2, 0, 1);
            if (withNormals) m.normals.assign(3, normalize(Vec3(-0.2f, 0.1f, 1)));
            const Vec3 before = m.geometricNormal(0);
            m.apply(t);
            EXPECT_NEAR(length(m.geometricNormal(0) - normalize(t.normal(before))), 0, 1e-6);
            for (const Vec3& n : m.normals) EXPECT_NEAR(length(n), 1, 1e-6);
        }
}

}  // namespace
}  // namespace drc
