#include "scene/shapes/shape_sphere.h"

#include "scene/shapes/shape_check.h"

namespace drc {
namespace {

void expectNear(const Vec3& a, const Vec3& b, float tolerance) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
}

SphereParams partialSphere() {
    SphereParams p;
    p.radius = 2;
    p.zMin = -1;
    p.zMax = 1.5f;
    p.phiMax = 200;
    return p;
}

Transform tilted() {
    return Transform::translate(Vec3(3, -1, 2)) * Transform::rotate(40, Vec3(1, 2, 3)) *
           Transform::scale(1.5f, 1.5f, 1.5f);
}

TEST(Sphere, HitsWhereItShould) {
    const ShapePtr sphere = makeSphere({.radius = 2});
    const auto outside = sphere->intersect(rayFrom(Vec3(5, 0, 0), Vec3(-1, 0, 0)), 0);
    ASSERT_TRUE(outside);
    EXPECT_FLOAT_EQ(outside->t, 3);
    expectNear(outside->ng, Vec3(1, 0, 0), 1e-6f);
    EXPECT_NEAR(outside->uv.x, 0, 1e-6);
    EXPECT_NEAR(outside->uv.y, 0.5, 1e-6);
    // PBR 3e, section 3.2.3: dpdu = phiMax (-y, x, 0). dpdv points up, since v increases with z.
    expectNear(outside->dpdu, Vec3(0, 4 * kPi, 0), 1e-4f);
    expectNear(outside->dpdv, Vec3(0, 0, 2 * kPi), 1e-4f);
    // From inside, with the near hit before tMin, and with the hits beyond tMax.
    EXPECT_FLOAT_EQ(sphere->intersect(rayFrom(Vec3(1, 0, 0), Vec3(1, 0, 0)), 0)->t, 1);
    EXPECT_FLOAT_EQ(sphere->intersect(rayFrom(Vec3(5, 0, 0), Vec3(-1, 0, 0)), 3.5f)->t, 7);
    Ray shortRay = rayFrom(Vec3(5, 0, 0), Vec3(-1, 0, 0));
    shortRay.tMax = 2.9f;
    EXPECT_FALSE(sphere->intersect(shortRay, 0));
    EXPECT_FALSE(sphere->intersect(rayFrom(Vec3(5, 0, 2.001f), Vec3(-1, 0, 0)), 0));
    EXPECT_FALSE(sphere->intersect(rayFrom(Vec3(5, 0, 0), Vec3(1, 0, 0)), 0));
    // Poles.
    const auto pole = sphere->intersect(rayFrom(Vec3(0, 0, 9), Vec3(0, 0, -1)), 0);
    ASSERT_TRUE(pole);
    EXPECT_NEAR(pole->uv.y, 1, 1e-4);
    EXPECT_TRUE(std::isfinite(pole->dpdv.x) && std::isfinite(pole->dpdu.x));
}

TEST(Sphere, IsExactFromAfar) {
    const ShapePtr sphere = makeSphere({.radius = 1});
    const auto hit = sphere->intersect(rayFrom(Vec3(1e5f, 0.75f, 0), Vec3(-1, 0, 0)), 0);
    ASSERT_TRUE(hit);
    expectNear(hit->ng, Vec3(std::sqrt(1 - 0.5625f), 0.75f, 0), 1e-5f);
    EXPECT_TRUE(sphere->intersect(rayFrom(Vec3(1e5f, 0.9999f, 0), Vec3(-1, 0, 0)), 0));
    EXPECT_FALSE(sphere->intersect(rayFrom(Vec3(1e5f, 1.0001f, 0), Vec3(-1, 0, 0)), 0));
}

TEST(Sphere, PartsAreClipped) {
    const ShapePtr sphere = makeSphere(partialSphere());
    // Along y = 0 from +x: the surface exists at phi = 0, and also on the far side at phi = 180.
    EXPECT_FLOAT_EQ(sphere->intersect(rayFrom(Vec3(5, 1e-4f, 0), Vec3(-1, 0, 0)), 0)->t, 3);
    // phi = 270 is cut away, so a ray from -y hits the inside at phi = 90.
    const auto hit = sphere->intersect(rayFrom(Vec3(0, -5, 0), Vec3(0, 1, 0)), 0);
    ASSERT_TRUE(hit);
    EXPECT_FLOAT_EQ(hit->t, 7);
    EXPECT_NEAR(hit->uv.x, 90 / 200.0, 1e-5);
    expectNear(hit->ng, Vec3(0, 1, 0), 1e-5f);
    // Above zMax and below zMin.
    EXPECT_FALSE(sphere->intersect(rayFrom(Vec3(0, 0, 9), Vec3(0, 0, -1)), 0));
    EXPECT_FALSE(sphere->intersect(rayFrom(Vec3(0.5f, 5, 1.6f), Vec3(0, -1, 0)), 0));
    EXPECT_NEAR(sphere->area(), 200 * kPi / 180 * 2 * 2.5, 1e-4);
    // v runs from zMin to zMax.
    const float r = std::sqrt(4 - 1.49f * 1.49f);
    EXPECT_NEAR(sphere->intersect(rayFrom(Vec3(0, 9, 1.49f), Vec3(0, -1, 0)), 0)->uv.y, 1, 1e-2);
    EXPECT_NEAR(sphere->intersect(rayFrom(Vec3(0, 9, 1.49f), Vec3(0, -1, 0)), 0)->t, 9 - r, 1e-5);
}

TEST(Sphere, FacesOutwardsUnlessReversed) {
    const Ray ray = rayFrom(Vec3(5, 0, 0), Vec3(-1, 0, 0));
    auto outward = [&](const Transform& t, bool reverse) {
        const ShapePtr s = makeSphere({.objectToWorld = t, .reverseOrientation = reverse});
        checkSampling(*s, 200);
        return s->intersect(ray, 0)->ng.x > 0;
    };
    EXPECT_TRUE(outward(Transform(), false));
    EXPECT_FALSE(outward(Transform(), true));
    EXPECT_TRUE(outward(Transform::scale(1, -1, 1), false));
    EXPECT_FALSE(outward(Transform::scale(1, 1, -1), true));
}

TEST(Sphere, TransformedHits) {
    const Transform t = tilted();
    const ShapePtr sphere = makeSphere({.objectToWorld = t, .radius = 2});
    const Vec3 centre = t.point(Vec3(0, 0, 0)), d = normalize(Vec3(1, -2, 0.5f));
    const auto hit = sphere->intersect(rayFrom(centre - d * 10, d), 0);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 10 - 3, 1e-5);
    expectNear(hit->ng, -d, 1e-5f);
    EXPECT_NEAR(sphere->area(), 4 * kPi * 9, 1e-3);
    const Bounds b = sphere->bounds();
    expectNear(b.min, centre - Vec3(3, 3, 3), 1e-4f);
    expectNear(b.max, centre + Vec3(3, 3, 3), 1e-4f);
    // If the direction is not unit, t is in units of its length.
    EXPECT_NEAR(sphere->intersect(rayFrom(centre - d * 10, d * 2), 0)->t, 3.5, 1e-5);
}

TEST(Sphere, Derivatives) {
    checkDerivatives(*makeSphere({.radius = 2}), rayFrom(Vec3(4, 3, 2), normalize(Vec3(-4, -3, -1.5f))), 2e-3f);
    SphereParams p = partialSphere();
    p.objectToWorld = tilted();
    const Vec3 target = p.objectToWorld.point(Vec3(0.5f, 1.9f, 0.3f)), from = p.objectToWorld.point(Vec3(1, 5, 0.5f));
    checkDerivatives(*makeSphere(p), rayFrom(from, normalize(target - from)), 4e-3f);
}

TEST(Sphere, Sampling) {
    checkSampling(*makeSphere({}));
    SphereParams p = partialSphere();
    checkSampling(*makeSphere(p));
    p.objectToWorld = tilted();
    checkSampling(*makeSphere(p));
    // For an ellipsoid the pdf varies with position, and must still be that of sample().
    const ShapePtr ellipsoid = makeSphere({.objectToWorld = Transform::scale(1, 2, 3)});
    checkSampling(*ellipsoid);
    EXPECT_NEAR(ellipsoid->area(), 48.882, 0.02);  // by elliptic integrals
}

TEST(Sphere, SamplingFromOutside) {
    checkSamplingFrom(*makeSphere({}), Vec3(0, 0, 3));
    checkSamplingFrom(*makeSphere({.objectToWorld = tilted(), .reverseOrientation = true}), Vec3(1, 2, 3));
    // Cone sampling has a constant pdf, and samples are never hidden.
    const ShapePtr sphere = makeSphere({});
    const double solidAngle = 2 * kPi * (1 - std::sqrt(1 - 1 / 9.0));
    for (int i = 0; i < 100; ++i) {
        const Vec2 u(uniformFloat(hash32(i, 0)), uniformFloat(hash32(i, 1)));
        const ShapeSample s = sphere->sampleFrom(Vec3(0, 0, 3), u);
        EXPECT_NEAR(1 / s.pdf, solidAngle, 1e-5);
        EXPECT_GE(dot(s.ng, Vec3(0, 0, 3) - s.p), -1e-5f);
        EXPECT_NEAR(length(s.p), 1, 1e-6);
    }
    // A small and distant sphere, where naive formulas would cancel.
    EXPECT_NEAR(sphere->sampleFrom(Vec3(0, 1e5f, 0), Vec2(0.5f, 0.5f)).pdf / (1e10 / kPi), 1, 1e-4);
}

TEST(Sphere, SamplingFromInsideAndOfParts) {
    checkSamplingFrom(*makeSphere({}), Vec3(0.2f, 0, 0.5f));
    checkSamplingFrom(*makeSphere(partialSphere()), Vec3(0.5f, 4, 1));
    checkSamplingFrom(*makeSphere(partialSphere()), Vec3(0.5f, -4, 1));
    checkSamplingFrom(*makeSphere({.objectToWorld = Transform::scale(1, 2, 3)}), Vec3(3, 1, 1));
}

// A ray through a hole in the near side hits the far side, which sampleFrom() never chooses.
TEST(Sphere, TheFarSideIsNotSampledFromOutside) {
    const ShapePtr sphere =
        makeSphere({.objectToWorld = Transform::translate(Vec3(1, 0, 0)), .reverseOrientation = true});
    const Vec3 p(5, 0, 0), wi(-1, 0, 0);
    EXPECT_GT(sphere->pdfFrom(p, wi, {Vec3(2, 0, 0), Vec3(-1, 0, 0)}), 0);
    EXPECT_EQ(sphere->pdfFrom(p, wi, {Vec3(0, 0, 0), Vec3(1, 0, 0)}), 0);
}

}  // namespace
}  // namespace drc
