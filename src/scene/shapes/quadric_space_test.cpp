// Which side of a shape its normal is on, under mirroring and ReverseOrientation: for hits and for sampled points.
#include "scene/shapes/quadric_space.h"

#include <gtest/gtest.h>

#include "math/rng.h"
#include "scene/ray_testing.h"
#include "scene/shapes/shape_cone.h"
#include "scene/shapes/shape_cylinder.h"
#include "scene/shapes/shape_disk.h"
#include "scene/shapes/shape_hyperboloid.h"
#include "scene/shapes/shape_paraboloid.h"
#include "scene/shapes/shape_sphere.h"

namespace drc {
namespace {

struct Quadric {
    const char* name;
    ShapePtr (*make)(const Transform& toWorld, bool reverse);
    // In object space: the direction of the normal, up to its length, at a point of the surface.
    Vec3 (*outward)(const Vec3& p);
};
Vec3 fromAxis(const Vec3& p) { return Vec3(p.x, p.y, 0); }

template <typename Params>
Params params(const Transform& toWorld, bool reverse) {
    Params p;
    p.objectToWorld = toWorld;
    p.reverseOrientation = reverse;
    return p;
}

const Quadric kQuadrics[] = {
    {"sphere", [](const Transform& t, bool r) { return makeSphere(params<SphereParams>(t, r)); },
     [](const Vec3& p) { return p; }},
    {"cylinder", [](const Transform& t, bool r) { return makeCylinder(params<CylinderParams>(t, r)); }, fromAxis},
    {"cone", [](const Transform& t, bool r) { return makeCone(params<ConeParams>(t, r)); }, fromAxis},
    {"paraboloid", [](const Transform& t, bool r) { return makeParaboloid(params<ParaboloidParams>(t, r)); }, fromAxis},
    {"hyperboloid",
     [](const Transform& t, bool r) {
         auto p = params<HyperboloidParams>(t, r);
         p.p1 = Vec3(1, 0, -1);
         p.p2 = Vec3(1, 0.5f, 1);
         return makeHyperboloid(p);
     },
     fromAxis},
    {"disk", [](const Transform& t, bool r) { return makeDisk(params<DiskParams>(t, r)); },
     [](const Vec3&) { return Vec3(0, 0, 1); }},
};

const Transform kPlacings[] = {
    Transform(),
    Transform::scale(-0.3f, 0.3f, 0.3f),
    Transform::scale(1, 1, -1),
    Transform::scale(-2, -2, -2),
    Transform::translate(Vec3(3, -1, 2)) * Transform::rotate(40, Vec3(1, 2, 3)) * Transform::scale(1, -1.5f, 0.5f),
};

TEST(QuadricSpace, NormalsStayOutsideUnderMirroring) {
    Pcg32 random(5);
    for (const Quadric& quadric : kQuadrics)
        for (const Transform& toWorld : kPlacings)
            for (const bool reverse : {false, true}) {
                SCOPED_TRACE(quadric.name);
                const ShapePtr shape = quadric.make(toWorld, reverse);
                const Transform toObject = toWorld.inverse();
                int hits = 0;
                for (int i = 0; i < 200; ++i) {
                    const ShapeSample sample = shape->sample(random.nextVec2());
                    const Vec3 outward = toWorld.normal(quadric.outward(toObject.point(sample.p)));
                    const Vec3 expected = reverse ? -outward : outward;
                    ASSERT_GT(dot(sample.ng, expected), 0) << "sampled";
                    // The hit at the sampled point, from either side.
                    const Vec3 d = (i % 2 ? 1.f : -1.f) * sample.ng;
                    const auto hit = shape->intersect(rayFrom(sample.p - d * 0.01f, d), 0);
                    if (!hit || length(hit->p - sample.p) > 1e-3f) continue;
                    ++hits;
                    ASSERT_GT(dot(hit->ng, expected), 0) << "hit";
                }
                EXPECT_GT(hits, 150);
            }
}

}  // namespace
}  // namespace drc
