#include "math/transform.h"

#include <gtest/gtest.h>

#include "math/frame.h"

namespace drc {
namespace {

void expectNear(const Vec3& a, const Vec3& b, float tolerance = 1e-5f) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
}

TEST(Transform, ComposesRightToLeft) {
    const Transform t = Transform::translate(Vec3(1, 2, 3)) * Transform::scale(2, 3, 4);
    expectNear(t.point(Vec3(1, 1, 1)), Vec3(3, 5, 7));
    expectNear(t.vector(Vec3(1, 1, 1)), Vec3(2, 3, 4));
    expectNear(t.inverse().point(Vec3(3, 5, 7)), Vec3(1, 1, 1));
    EXPECT_TRUE((Transform::scale(2, 2, 2) * Transform::scale(0.5f, 0.5f, 0.5f)).isIdentity());
    EXPECT_TRUE(Transform().isIdentity());
    EXPECT_EQ(t.at(0, 3), 1);
    EXPECT_EQ(t.transposed().at(3, 0), 1);
}

TEST(Transform, RotatesRightHanded) {
    expectNear(Transform::rotate(90, Vec3(0, 0, 1)).vector(Vec3(1, 0, 0)), Vec3(0, 1, 0));
    expectNear(Transform::rotate(90, Vec3(2, 0, 0)).vector(Vec3(0, 1, 0)), Vec3(0, 0, 1));
    expectNear(Transform::rotate(120, Vec3(1, 1, 1)).vector(Vec3(1, 0, 0)), Vec3(0, 1, 0));
}

TEST(Transform, NormalsStayPerpendicular) {
    const Transform t = Transform::rotate(30, Vec3(1, 2, 3)) * Transform::scale(1, 5, 0.2f);
    const Vec3 n(1, 2, 2), tangent(2, -1, 0);
    EXPECT_NEAR(dot(t.normal(n), t.vector(tangent)), 0, 1e-5);
    EXPECT_GT(dot(t.normal(n), t.vector(n)), 0);
}

TEST(Transform, Handedness) {
    EXPECT_FALSE(Transform::rotate(77, Vec3(1, 0, 2)).swapsHandedness());
    EXPECT_TRUE(Transform::scale(-1, 1, 1).swapsHandedness());
    EXPECT_FALSE(Transform::scale(-1, -1, 1).swapsHandedness());
}

TEST(Transform, Singular) {
    const Transform flat = Transform::scale(1, 0, 1);
    EXPECT_FALSE(flat.isInvertible());
    EXPECT_FALSE((flat * Transform::translate(Vec3(1, 1, 1))).isInvertible());
    EXPECT_TRUE(Transform::scale(1e-12f, 1e-12f, 1e-12f).isInvertible());
}

TEST(Transform, LookAtIsLeftHanded) {
    // Looking along +z with y up, x is to the right.
    const Transform t = Transform::lookAt(Vec3(1, 2, 3), Vec3(1, 2, 8), Vec3(0, 1, 0));
    expectNear(t.point(Vec3(1, 2, 3)), Vec3(0, 0, 0));
    expectNear(t.point(Vec3(1, 2, 8)), Vec3(0, 0, 5));
    expectNear(t.vector(Vec3(0, 1, 0)), Vec3(0, 1, 0));
    expectNear(t.vector(Vec3(1, 0, 0)), Vec3(1, 0, 0));
    // Looking along -z, world +x is to the left.
    const Transform back = Transform::lookAt(Vec3(0, 0, 0), Vec3(0, 0, -1), Vec3(0, 1, 0));
    expectNear(back.vector(Vec3(1, 0, 0)), Vec3(-1, 0, 0));
    EXPECT_FALSE(t.swapsHandedness());
}

TEST(Transform, Perspective) {
    const Transform t = Transform::perspective(90, 1, 101);
    expectNear(t.point(Vec3(0, 0, 1)), Vec3(0, 0, 0));
    expectNear(t.point(Vec3(0, 0, 101)), Vec3(0, 0, 1));
    expectNear(t.point(Vec3(5, -10, 10)), Vec3(0.5f, -1, 1.01f * 0.9f));
    expectNear(t.inverse().point(Vec3(0.5f, -1, 0.909f)), Vec3(5, -10, 10), 1e-3f);
}

TEST(Frame, IsOrthonormalAndRightHanded) {
    for (const Vec3& v : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 2, 3), Vec3(-1, 0.5f, -1e-8f), Vec3(1, 0, 0)}) {
        const Vec3 n = normalize(v);
        for (const Frame& f : {Frame::fromNormal(n), Frame::fromNormalAndTangent(n, Vec3(1, 1, 0)),
                               Frame::fromNormalAndTangent(n, n * 3), Frame::fromNormalAndTangent(n, Vec3(0, 0, 0))}) {
            expectNear(cross(f.s, f.t), f.n);
            EXPECT_NEAR(length(f.s), 1, 1e-5);
            EXPECT_NEAR(length(f.t), 1, 1e-5);
            EXPECT_EQ(f.n, n);
            const Vec3 w(0.3f, -0.2f, 0.8f);
            expectNear(f.toLocal(f.toWorld(w)), w);
        }
    }
}

}  // namespace
}  // namespace drc
