// Cylinder, cone, paraboloid and hyperboloid.
#include "scene/shapes/shape_of_revolution.h"

#include "scene/chi_square.h"
#include "scene/shapes/shape_check.h"
#include "scene/shapes/shape_cone.h"
#include "scene/shapes/shape_cylinder.h"
#include "scene/shapes/shape_hyperboloid.h"
#include "scene/shapes/shape_paraboloid.h"

namespace drc {
namespace {

void expectNear(const Vec3& a, const Vec3& b, float tolerance) { EXPECT_LT(length(a - b), tolerance) << a << " " << b; }

// The hit of a ray that starts 5 units from the axis of object space and runs towards it, at the given height and
// angle.
std::optional<ShapeHit> hitFromOutside(const Shape& shape, float z, float degrees) {
    const float phi = degrees * kPi / 180;
    const Vec3 outward(std::cos(phi), std::sin(phi), 0);
    return shape.intersect(rayFrom(outward * 5 + Vec3(0, 0, z), -outward), 0);
}

Transform tilted() {
    return Transform::translate(Vec3(3, -1, 2)) * Transform::rotate(40, Vec3(1, 2, 3)) *
           Transform::scale(1.5f, 1.5f, 1.5f);
}

TEST(ShapeOfRevolution, CylinderHits) {
    const ShapePtr cylinder = makeCylinder({.radius = 2, .zMin = 1, .zMax = -1, .phiMax = 270});
    const auto hit = hitFromOutside(*cylinder, 0.5f, 90);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 3, 1e-6);
    expectNear(hit->ng, Vec3(0, 1, 0), 1e-6f);
    EXPECT_NEAR(hit->uv.x, 90 / 270.0, 1e-6);
    EXPECT_NEAR(hit->uv.y, 0.75, 1e-6);
    expectNear(hit->dpdu, Vec3(-2 * 1.5f * kPi, 0, 0), 1e-5f);
    expectNear(hit->dpdv, Vec3(0, 0, 2), 1e-6f);
    // Through the missing quarter, the inside of the far wall is visible. The ends are open.
    EXPECT_NEAR(hitFromOutside(*cylinder, 0, 315)->t, 7, 1e-6);
    EXPECT_FALSE(hitFromOutside(*cylinder, 1.01f, 90));
    EXPECT_FALSE(cylinder->intersect(rayFrom(Vec3(1, 1, 5), Vec3(0, 0, -1)), 0));
    EXPECT_FALSE(cylinder->intersect(rayFrom(Vec3(0, 5, 0), Vec3(0, 1, 0)), 0));
    EXPECT_NEAR(cylinder->intersect(rayFrom(Vec3(5, 0, 0), Vec3(-1, 0, 0)), 3.5f)->t, 7, 1e-6);  // beyond tMin
    EXPECT_NEAR(cylinder->area(), 1.5 * kPi * 2 * 2, 1e-4);
}

TEST(ShapeOfRevolution, ConeHits) {
    const ShapePtr cone = makeCone({.radius = 2, .height = 4});
    const auto hit = hitFromOutside(*cone, 1, 180);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 5 - 1.5f, 1e-6);
    expectNear(hit->ng, normalize(Vec3(-4, 0, 2)), 1e-6f);
    EXPECT_NEAR(hit->uv.x, 0.5, 1e-6);
    EXPECT_NEAR(hit->uv.y, 0.25, 1e-6);
    expectNear(hit->dpdv, Vec3(2, 0, 4), 1e-5f);
    // The cone has only one sheet, and its base is open.
    EXPECT_FALSE(hitFromOutside(*cone, 4.5f, 0));
    EXPECT_FALSE(hitFromOutside(*cone, -0.1f, 0));
    EXPECT_NEAR(cone->intersect(rayFrom(Vec3(0.5f, 0, -5), Vec3(0, 0, 1)), 0)->t, 5 + 3, 1e-5);
    // A ray parallel to the surface's slope has only one hit.
    const Vec3 d = normalize(Vec3(-2, 0, 4));
    const auto parallel = cone->intersect(rayFrom(Vec3(1, 0, 0) - d, d), 0);
    ASSERT_TRUE(parallel);
    EXPECT_LT(parallel->ng.x, 0);
    // The derivatives must be finite at the apex.
    const auto apex = cone->intersect(rayFrom(Vec3(0, 0, 9), Vec3(0, 0, -1)), 0);
    ASSERT_TRUE(apex);
    EXPECT_NEAR(length(apex->ng), 1, 1e-6);
    EXPECT_TRUE(std::isfinite(length(apex->dpdu) + length(apex->dpdv)));
    EXPECT_NEAR(cone->area(), kPi * 2 * std::sqrt(20.f), 1e-4);
}

TEST(ShapeOfRevolution, ParaboloidHits) {
    const ShapePtr bowl = makeParaboloid({.radius = 2, .zMin = 1, .zMax = 4});
    const auto hit = hitFromOutside(*bowl, 2.25f, 90);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 5 - 1.5f, 1e-6);
    // r^2 = z: the normal is along (2 r, -1).
    expectNear(hit->ng, normalize(Vec3(0, 3, -1)), 1e-6f);
    EXPECT_NEAR(hit->uv.x, 0.25, 1e-6);
    EXPECT_NEAR(hit->uv.y, 1.25 / 3, 1e-6);
    expectNear(hit->dpdv, Vec3(0, 3 / (2 * 1.5f), 3), 1e-5f);
    EXPECT_FALSE(hitFromOutside(*bowl, 0.5f, 90));
    // A ray along the axis meets the infinite surface only once.
    const ShapePtr whole = makeParaboloid({.radius = 2, .zMax = 4});
    EXPECT_NEAR(whole->intersect(rayFrom(Vec3(0.6f, 0.8f, 9), Vec3(0, 0, -1)), 0)->t, 8, 1e-5);
    EXPECT_FALSE(whole->intersect(rayFrom(Vec3(2.1f, 0, 9), Vec3(0, 0, -1)), 0));
    const auto apex = whole->intersect(rayFrom(Vec3(0, 0, -1), Vec3(0, 0, 1)), 0);
    ASSERT_TRUE(apex);
    expectNear(apex->ng, Vec3(0, 0, -1), 1e-6f);
    EXPECT_TRUE(std::isfinite(length(apex->dpdu) + length(apex->dpdv)));
    // pi r / (6 h^2) ((r^2 + 4 h^2)^(3/2) - r^3)
    EXPECT_NEAR(whole->area(), kPi * 2 / 96 * (std::pow(68, 1.5) - 8), 2e-4);
    // There is no surface below the apex, but v still counts from zMin.
    const ShapePtr below = makeParaboloid({.radius = 2, .zMin = -4, .zMax = 4});
    EXPECT_NEAR(below->area(), whole->area(), 1e-3);
    EXPECT_NEAR(hitFromOutside(*below, 2, 90)->uv.y, 0.75, 1e-6);
}

TEST(ShapeOfRevolution, HyperboloidHits) {
    // x^2 + y^2 = 1 + z^2.
    const ShapePtr hyperboloid = makeHyperboloid({.p1 = Vec3(1, -1, -1), .p2 = Vec3(1, 1, 1)});
    const auto hit = hitFromOutside(*hyperboloid, 0.75f, 0);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 5 - 1.25f, 1e-6);
    expectNear(hit->ng, normalize(Vec3(1.25f, 0, -0.75f)), 1e-6f);
    EXPECT_NEAR(hit->uv.y, 0.875, 1e-6);
    // At that height the segment is at (1, 0.75), so phi of p differs by that angle.
    EXPECT_NEAR(hit->uv.x, 1 - std::atan(0.75f) / (2 * kPi), 1e-6);
    // The surface contains the segment: at phi = 0, dpdv is along it and uv is (0, v).
    const auto on = hyperboloid->intersect(rayFrom(Vec3(4, 2, 0.5f), normalize(Vec3(-3, -1.5f + 1e-4f, 0))), 0);
    ASSERT_TRUE(on);
    EXPECT_NEAR(on->uv.y, 0.75, 1e-5);
    expectNear(on->dpdv, Vec3(0, 2, 2), 1e-3f);
    EXPECT_NEAR(hyperboloid->area(), 2 * kPi * (std::sqrt(3.0) + std::asinh(std::sqrt(2.0)) / std::sqrt(2.0)), 1e-4);
    // pbrt's default hyperboloid is a cone.
    EXPECT_NEAR(makeHyperboloid({})->area(), kPi * std::sqrt(2.f) * std::sqrt(3.f), 1e-4);
}

// The segment's own points satisfy x^2 + y^2 = 1 + z + z^2 / 4, but pbrt's equation has no linear term in z. Its
// surface passes through the circle of p2, with radius 2 at z = 2, and through one with radius 3 at z = 4.
TEST(ShapeOfRevolution, HyperboloidsAreThoseOfPbrtsEquation) {
    const ShapePtr cone = makeHyperboloid({.p1 = Vec3(1, 0, 0), .p2 = Vec3(2, 0, 2)});
    // width 4 - height 4 = 1 and width 9 - height 16 = 1: r^2 = (28 + 5 z^2) / 12.
    for (const float z : {0.1f, 1.f, 1.9f}) {
        const float radius = std::sqrt((28 + 5 * z * z) / 12);
        const auto hit = hitFromOutside(*cone, z, 30);
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->t, 5 - radius, 1e-5);
        EXPECT_NEAR(hit->uv.x, 30 / 360.0, 1e-5);
        EXPECT_NEAR(hit->uv.y, z / 2, 1e-6);
        const Vec3 outward(std::cos(kPi / 6), 0.5f, 0), up(0, 0, 1);
        expectNear(hit->ng, normalize(outward * radius - up * (5 * z / 12)), 1e-5f);
        // Shading normals are those of the cone that the segment sweeps.
        expectNear(hit->ns, normalize(outward * 2.f - up), 1e-5f);
        expectNear(hit->dpdv, outward + up * 2.f, 1e-5f);
    }
    EXPECT_FALSE(hitFromOutside(*cone, -0.1f, 30));
    EXPECT_FALSE(hitFromOutside(*cone, 2.1f, 30));
    // In this case, a cone with its apex at p2, the equation has no points before the apex.
    EXPECT_EQ(makeHyperboloid({.p1 = Vec3(1, 0, 0), .p2 = Vec3(0, 0, 1)}), nullptr);
    // In this case it has points above z = 0.39 and below -0.39, but none between.
    const ShapePtr two = makeHyperboloid({.p1 = Vec3(1, -0.6f, -0.5f), .p2 = Vec3(0.3f, 0.7f, 1)});
    EXPECT_TRUE(hitFromOutside(*two, 0.45f, 30) && hitFromOutside(*two, -0.45f, 30));
    EXPECT_FALSE(hitFromOutside(*two, 0.3f, 30));
    EXPECT_EQ(hitFromOutside(*two, 0.9f, 30)->ns == Vec3(0.f), false);
}

TEST(ShapeOfRevolution, IsExactFromAfar) {
    const ShapePtr cylinder = makeCylinder({});
    const auto hit = cylinder->intersect(rayFrom(Vec3(1e5f, 0.75f, 0), Vec3(-1, 0, 0)), 0);
    ASSERT_TRUE(hit);
    expectNear(hit->ng, Vec3(std::sqrt(1 - 0.5625f), 0.75f, 0), 1e-5f);
    EXPECT_TRUE(cylinder->intersect(rayFrom(Vec3(1e5f, 0.9999f, 0), Vec3(-1, 0, 0)), 0));
    EXPECT_FALSE(cylinder->intersect(rayFrom(Vec3(1e5f, 1.0001f, 0), Vec3(-1, 0, 0)), 0));
}

// One shape of each kind, whole or partial.
std::vector<ShapePtr> shapesIn(const Transform& t, bool reverse, bool whole) {
    const float phiMax = whole ? 360 : 250;
    return {makeCylinder({t, reverse, 0.8f, -0.5f, 1, phiMax}), makeCone({t, reverse, 0.9f, 1.6f, phiMax}),
            makeParaboloid({t, reverse, 0.5f, whole ? 0 : 0.3f, 2, phiMax}),
            makeHyperboloid({t, reverse, Vec3(1, -0.6f, -0.5f), Vec3(0.3f, 0.7f, 1), phiMax}),
            makeHyperboloid({t, reverse, Vec3(0.3f, 0.7f, 1), Vec3(1, -0.6f, -0.5f), phiMax})};
}

TEST(ShapeOfRevolution, FaceOutwardsUnlessReversed) {
    const auto outward = [](const Transform& t, bool reverse) {
        std::vector<bool> result;
        for (const ShapePtr& shape : shapesIn(t, reverse, true))
            result.push_back(hitFromOutside(*shape, 0.5f, 20)->ng.x > 0);
        return result;
    };
    // The last one runs downwards, which flips its normals inwards.
    const std::vector<bool> usual = {true, true, true, true, false}, turned = {false, false, false, false, true};
    EXPECT_EQ(outward(Transform(), false), usual);
    EXPECT_EQ(outward(Transform(), true), turned);
    EXPECT_EQ(outward(Transform::scale(1, -1, 1), false), usual);
    EXPECT_EQ(outward(Transform::scale(1, -1, 1), true), turned);
}

TEST(ShapeOfRevolution, Sampling) {
    const Transform stretched = tilted() * Transform::scale(1, 2, 0.5f);
    for (const ShapePtr& shape : shapesIn(tilted(), false, true)) checkSampling(*shape, 2000);
    for (const ShapePtr& shape : shapesIn(stretched, true, false)) checkSampling(*shape, 2000);
}

TEST(ShapeOfRevolution, SamplesAreUniform) {
    // Compares heights with the cumulative area: (r^2 + 4 h z)^(3/2) - r^3 for a steep paraboloid, 1 - (1 - z/h)^2 for
    // a cone.
    Pcg32 rng(3);
    const ShapePtr bowl = makeParaboloid({.radius = 0.1f, .zMax = 2}), cone = makeCone({.radius = 1, .height = 2});
    const double perZ = 0.01 / 2;
    const auto below = [&](double z) { return std::pow(perZ * perZ + 4 * perZ * z, 1.5) - std::pow(perZ, 3); };
    constexpr int kBins = 20, kSamples = 20000;
    std::vector<int> ofBowl(kBins), ofCone(kBins);
    for (int i = 0; i < kSamples; ++i) {
        const Vec2 u = rng.nextVec2();
        const double share = below(bowl->sample(u).p.z) / below(2);
        const double z = cone->sample(u).p.z, coneShare = 1 - (1 - z / 2) * (1 - z / 2);
        ++ofBowl[size_t(std::clamp(int(share * kBins), 0, kBins - 1))];
        ++ofCone[size_t(std::clamp(int(coneShare * kBins), 0, kBins - 1))];
    }
    for (const auto& bins : {ofBowl, ofCone}) {
        double chiSquare = 0;
        for (const int n : bins)
            chiSquare += (n - kSamples / kBins) * (n - kSamples / kBins) / double(kSamples / kBins);
        EXPECT_LT(chiSquare, 55);  // 19 degrees of freedom: a chance of 2e-5
    }
}

TEST(ShapeOfRevolution, SamplingFromAPoint) {
    const Transform stretched = tilted() * Transform::scale(1, 2, 0.5f);
    for (const ShapePtr& shape : shapesIn(tilted(), false, true)) checkSamplingFrom(*shape, Vec3(5, 2, 3), 20000);
    for (const ShapePtr& shape : shapesIn(stretched, true, false))
        checkSamplingFrom(*shape, stretched.point(Vec3(0.5f, 1.4f, 1.2f)), 20000);
}

// From a point inside, where no part of the surface is edge-on. The pdf of a direction is the sum over all points on
// the ray.
TEST(ShapeOfRevolution, DirectionsFollowTheDensity) {
    const Transform t = tilted() * Transform::scale(1, 1.6f, 0.7f);
    for (const ShapePtr& shape : shapesIn(t, false, false)) {
        const Vec3 p = t.point(Vec3(0.02f, -0.05f, 0.6f));
        const auto sample = [&](std::mt19937& rng) -> std::optional<Vec3> {
            std::uniform_real_distribution<float> u(0, kOneMinusEpsilon);
            const float x = u(rng), y = u(rng);
            return normalize(shape->sampleFrom(p, Vec2(x, y)).p - p);
        };
        const auto pdf = [&](const Vec3& w) {
            float sum = 0, after = 0;
            while (const auto hit = shape->intersect(rayFrom(p, w), after)) {
                sum += shape->pdfFrom(p, w, {p + w * hit->t, hit->ng, hit->uv, hit->part});
                after = hit->t * 1.0001f;
            }
            return sum;
        };
        const test::ChiSquare r = test::chiSquareTest(sample, pdf, 20000, 3, 4e-5);
        EXPECT_GT(r.pValue, test::kChiSquareLevel);
        EXPECT_NEAR(r.pdfIntegral, 1, 2e-3);
    }
}

TEST(ShapeOfRevolution, Derivatives) {
    const Transform t = tilted() * Transform::scale(1, 1.3f, 0.7f);
    std::vector<ShapePtr> shapes = shapesIn(t, false, false);
    // Derivatives of hyperboloids lie on the surface only if the segment does.
    shapes.resize(3);
    shapes.push_back(makeHyperboloid({t, false, Vec3(0.6f, -0.7f, -1), Vec3(0.6f, 0.7f, 1)}));
    for (const ShapePtr& shape : shapes) {
        const Vec3 from = t.point(Vec3(-1, 3, 1.5f)), to = t.point(Vec3(-0.1f, 0, 0.5f));
        checkDerivatives(*shape, rayFrom(from, normalize(to - from)), 1e-3f);
    }
}

}  // namespace
}  // namespace drc
