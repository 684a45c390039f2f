// Shapes far from the origin, placed by instances, and rays that start close to them. Embree transforms such rays to
// the shape's space in single precision, and the hit that it finds must be the one that is described.
#include <gtest/gtest.h>

#include "accel/accel.h"
#include "scene/materials/material_matte.h"
#include "scene/ray_testing.h"
#include "scene/shapes/shape_cone.h"
#include "scene/shapes/shape_cylinder.h"
#include "scene/shapes/shape_disk.h"
#include "scene/shapes/shape_hyperboloid.h"
#include "scene/shapes/shape_paraboloid.h"
#include "scene/shapes/shape_sphere.h"

namespace drc {
namespace {

std::vector<ShapePtr> quadrics() {
    return {makeSphere({}),
            makeSphere({.zMin = -0.5f, .zMax = 0.8f}),
            makeDisk({}),
            makeCylinder({}),
            makeCone({}),
            makeParaboloid({}),
            makeHyperboloid({.p1 = Vec3(1, -0.5f, -1), .p2 = Vec3(1, 0.5f, 1)})};
}

Primitive primitiveOf(const ShapePtr& shape) {
    Primitive p;
    p.shape = shape;
    p.material = makeMatte({});
    return p;
}

Transform placedAt(const Vec3& center) {
    return Transform::translate(center) * Transform::rotate(40, Vec3(1, 2, -1)) * Transform::scale(1.3f, 1.3f, 1.3f);
}

struct Aim {
    const char* name;
    float distance;  // from the origin to the shape
    float t;         // from the ray's origin to the hit
};
constexpr Aim kAims[] = {{"near", 5, 0.01f}, {"far", 100, 0.3f}, {"very far", 1000, 5}, {"far and short", 1000, 0.1f}};

// Aims rays at the shape from about the given distance, at all angles except grazing ones. Returns how many of them
// miss.
int missedOf(const Shape& shape, const AnimatedTransform& motion, float distance, int count) {
    Scene scene;
    scene.objects.push_back({"o", {}});
    scene.objects[0].primitives.push_back(primitiveOf(ShapePtr(ShapePtr(), &shape)));
    scene.instances.push_back({0, motion});
    const Accel accel(scene);
    Pcg32 rng(3);
    int missed = 0;
    for (int i = 0; i < count; ++i) {
        const ShapeSample at = shape.sample(rng.nextVec2());
        const float time = rng.nextVec2().x;
        const Transform toWorld = motion.at(time);
        const Vec3 p = toWorld.point(at.p), n = normalize(toWorld.normal(at.ng));
        const Vec3 d = normalize(n * (i % 2 ? 1.f : -1.f) + sampleUniformSphere(rng.nextVec2()) * 0.7f);
        SurfaceInteraction hit;
        const Ray ray = rayFrom(p - d * distance, d, time);
        if (!accel.intersect(ray, hit)) {
            ++missed;
            continue;
        }
        EXPECT_EQ(hit.primitive, &scene.objects[0].primitives[0]);
        EXPECT_LE(hit.t, distance * 1.01f + 0.01f);
        EXPECT_LT(length(hit.p - (ray.o + ray.d * hit.t)), 1e-6f * (length(p) + 1)) << hit.t;
    }
    return missed;
}

TEST(ShapeHits, NoneIsLostNextToAPlacedShape) {
    constexpr int kCount = 1000;
    for (const ShapePtr& shape : quadrics())
        for (const Aim& aim : kAims)
            EXPECT_LE(missedOf(*shape, placedAt(Vec3(1, 0.6f, -0.3f) * aim.distance), aim.t, kCount), kCount / 100)
                << aim.name;
}

TEST(ShapeHits, NoneIsLostNextToAMovingShape) {
    constexpr int kCount = 1000;
    for (const ShapePtr& shape : quadrics())
        for (const Aim& aim : kAims) {
            const Transform start = placedAt(Vec3(1, 0.6f, -0.3f) * aim.distance);
            const AnimatedTransform motion(
                start, Transform::translate(Vec3(1, 2, 0)) * start * Transform::rotate(50, Vec3(0, 1, 1)));
            // Embree's interpolation is accurate to about a thousandth, so shorter rays would miss what they are aimed
            // at.
            EXPECT_LE(missedOf(*shape, motion, std::max(0.1f, aim.t), kCount), kCount / 100) << aim.name;
        }
}

// The nearest hit found by testing each primitive in a scene of its own.
const Primitive* nearestOf(const std::vector<std::unique_ptr<Accel>>& alone, const std::vector<Primitive>& all,
                           const Ray& ray, SurfaceInteraction& nearest) {
    const Primitive* found = nullptr;
    for (size_t i = 0; i < alone.size(); ++i) {
        SurfaceInteraction hit;
        if (!alone[i]->intersect(ray, hit) || (found && hit.t >= nearest.t)) continue;
        nearest = hit;
        found = &all[i];
    }
    return found;
}

// Before the nearest hit, Embree may accept farther ones, on shapes as well as on meshes.
TEST(ShapeHits, OfSeveralSurfacesTheNearestIsDescribed) {
    std::vector<Primitive> all;
    // No two primitives coincide, since either could then be the nearest.
    for (int i = 0; i < 4; ++i) {
        const float x = 0.3f * float(i);
        all.push_back(
            primitiveOf(makeSphere({.objectToWorld = Transform::translate(Vec3(x, -x, 0.1f)), .radius = 0.5f})));
        all.push_back(primitiveOf(makeDisk({.objectToWorld = Transform::rotate(20 + 50 * x, Vec3(1, x, 0))})));
        all.push_back(primitiveOf(
            makeCylinder({.objectToWorld = Transform::rotate(100 * x, Vec3(1, 0, 1)), .radius = 0.4f + x})));
    }
    for (int i = 0; i < 4; ++i) {
        auto mesh = std::make_shared<TriangleMesh>();
        const float z = 0.5f * float(i) - 0.7f;
        mesh->positions = {Vec3(-3, -3, z), Vec3(3, -3, -z), Vec3(0, 3, 0.2f)};
        mesh->indices = {0, 1, 2};
        Primitive p;
        p.mesh = mesh;
        p.material = makeMatte({});
        all.push_back(p);
    }
    for (const Transform& placement : {Transform(), placedAt(Vec3(3, 1, -2))}) {
        Scene together;
        together.objects.push_back({"o", all});
        together.instances.push_back({0, placement});
        std::vector<std::unique_ptr<Scene>> scenes;
        std::vector<std::unique_ptr<Accel>> alone;
        for (const Primitive& p : all) {
            scenes.push_back(std::make_unique<Scene>());
            scenes.back()->objects.push_back({"o", {p}});
            scenes.back()->instances.push_back({0, placement});
            alone.push_back(std::make_unique<Accel>(*scenes.back()));
        }
        const Accel accel(together);
        int shapes = 0, meshes = 0;
        forManyRays(1000, [&](const Ray& local) {
            const Ray ray = rayFrom(placement.point(local.o), normalize(placement.vector(local.d)));
            SurfaceInteraction hit, expected;
            const Primitive* nearest = nearestOf(alone, all, ray, expected);
            ASSERT_EQ(accel.intersect(ray, hit), nearest != nullptr);
            if (nearest == nullptr) return;
            EXPECT_EQ(hit.primitive - together.objects[0].primitives.data(), nearest - all.data());
            EXPECT_EQ(hit.t, expected.t);
            EXPECT_EQ(hit.p, expected.p);
            EXPECT_EQ(hit.ng, expected.ng);
            EXPECT_EQ(hit.uv, expected.uv);
            ++(nearest->shape ? shapes : meshes);
        });
        EXPECT_GT(shapes, 100);
        EXPECT_GT(meshes, 100);
    }
}

// A ray that leaves a convex shape must not hit it again, however far the ray came from that found the point.
TEST(ShapeHits, LieOnTheShapeHoweverFarTheRayCame) {
    for (const float far : {10.f, 1000.f, 100'000.f}) {
        Scene scene;
        scene.primitives.push_back(primitiveOf(makeSphere({})));
        const Accel accel(scene);
        Pcg32 rng(4);
        int again = 0, hits = 0;
        for (int i = 0; i < 1000; ++i) {
            const Vec3 o = sampleUniformSphere(rng.nextVec2()) * far;
            SurfaceInteraction hit, next;
            if (!accel.intersect(rayFrom(o, normalize(sampleUniformSphere(rng.nextVec2()) * 0.5f - o)), hit)) continue;
            ++hits;
            again += accel.intersect(hit.spawnRay(hit.ng), next);
            again += !accel.intersect(hit.spawnRay(-hit.ng), next);
        }
        EXPECT_GT(hits, 500) << far;
        EXPECT_EQ(again, 0) << far;
    }
}

// The same at large coordinates: of the instance in the world, of the shape in its object, and of both. Such rays are
// kept off the sphere by the lower bound of the spawn offset. Rays along the normal are the easy case, so other
// directions are tried as well.
TEST(ShapeHits, RaysLeaveAPlacedShapeForGood) {
    const Transform turn = Transform::rotate(40, Vec3(1, 2, -1));
    for (const float far : {0.f, 30.f, 1000.f, 30'000.f}) {
        const Transform out = Transform::translate(Vec3(1, 0.01f, -0.4f) * far);
        const Transform back = Transform::translate(Vec3(-1, -0.01f, 0.4f) * far);
        const std::pair<Transform, Transform> placements[] = {
            {out * turn, Transform()}, {back * turn, turn.inverse() * out}, {turn, out}, {turn * back, out}};
        for (const auto& [instance, within] : placements) {
            Scene scene;
            scene.objects.push_back({"o", {}});
            scene.objects[0].primitives.push_back(primitiveOf(makeSphere({.objectToWorld = within})));
            scene.instances.push_back({0, instance});
            const Accel accel(scene);
            const Vec3 center = instance.point(within.point(Vec3(0.f)));
            Pcg32 rng(5);
            int again = 0, hits = 0;
            for (int i = 0; i < 2000; ++i) {
                const Vec3 o = center + sampleUniformSphere(rng.nextVec2()) * 5.f;
                SurfaceInteraction hit, next;
                if (!accel.intersect(rayFrom(o, normalize(center + sampleUniformSphere(rng.nextVec2()) * 0.8f - o)),
                                     hit))
                    continue;
                ++hits;
                const Vec3 side = Frame::fromNormal(hit.ng).toWorld(sampleCosineHemisphere(rng.nextVec2()));
                again += accel.intersect(hit.spawnRay(hit.ng), next);
                again += accel.intersect(hit.spawnRay(side), next);
                again += !accel.intersect(hit.spawnRay(-hit.ng), next);
            }
            EXPECT_GT(hits, 1500) << far;
            EXPECT_EQ(again, 0) << far;
        }
    }
}

}  // namespace
}  // namespace drc
