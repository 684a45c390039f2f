// Rays against shapes and curves in a whole scene; meshes are tested by rendered images.
#include "accel/accel.h"

#include <gmock/gmock.h>

#include "base/folder_testing.h"
#include "base/memory_testing.h"
#include "base/memory_use.h"
#include "scene/materials/material_matte.h"
#include "scene/shapes/curves.h"
#include "scene/shapes/shape_check.h"
#include "scene/shapes/shape_cone.h"
#include "scene/shapes/shape_cylinder.h"
#include "scene/shapes/shape_disk.h"
#include "scene/shapes/shape_hyperboloid.h"
#include "scene/shapes/shape_paraboloid.h"
#include "scene/shapes/shape_sphere.h"

namespace drc {
namespace {

// An alpha mask that is transparent where u < 0.5.
class HalfMask final : public FloatTexture {
  public:
    float eval(const TextureContext& at) const override { return at.uv.x < 0.5f ? 0 : 1; }
};

std::shared_ptr<Curves> bentCurves(CurveType type) {
    auto curves = std::make_shared<Curves>(type, false);
    curves->add({Vec3(-1, 0, 0), Vec3(-0.5f, 1, 0.4f), Vec3(0.5f, -0.6f, 0.8f), Vec3(1, 0.3f, -0.2f)}, {0.1f, 0.2f},
                {normalize(Vec3(0.1f, 0.2f, 1)), normalize(Vec3(0, -1, 1))});
    curves->add({Vec3(-1, -1, 0), Vec3(-0.5f, -1, 0), Vec3(0.5f, -1, 0), Vec3(1, -1, 0)}, {0.3f, 0.3f},
                {Vec3(0, 0, 1), Vec3(0, 0, 1)});
    return curves;
}

std::vector<ShapePtr> oneOfEach() {
    return {makeSphere({}),
            makeDisk({}),
            makeCylinder({}),
            makeCone({}),
            makeParaboloid({}),
            makeHyperboloid({.p1 = Vec3(1, -0.5f, -1), .p2 = Vec3(1, 0.5f, 1)}),
            bentCurves(CurveType::Flat),
            bentCurves(CurveType::Cylinder),
            bentCurves(CurveType::Tube),
            bentCurves(CurveType::Ribbon)};
}

Primitive primitiveOf(const ShapePtr& shape) {
    Primitive p;
    p.shape = shape;
    p.material = makeMatte({});
    return p;
}

TEST(Accel, HitsAreThoseOfTheShapes) {
    for (const ShapePtr& shape : oneOfEach()) {
        Scene scene;
        scene.primitives.push_back(primitiveOf(shape));
        const Accel accel(scene);
        int hits = 0, different = 0;
        forManyRays(2000, [&](const Ray& ray) {
            const auto expected = shape->intersect(ray, 0);
            SurfaceInteraction hit;
            const bool found = accel.intersect(ray, hit);
            EXPECT_EQ(found, accel.occluded(ray.o, ray.d, kInfinity, ray.time));
            hits += found;
            // Embree and the reference approximate curves by different line segments, so their silhouettes differ a
            // little.
            if (found != expected.has_value() ||
                (found && (std::abs(hit.t - expected->t) > 0.01f || std::abs(hit.uv.x - expected->uv.x) > 0.02f ||
                           std::abs(hit.uv.y - expected->uv.y) > 0.1f || dot(hit.ng, expected->ng) < 0.94f)))
                ++different;
        });
        EXPECT_GT(hits, 100);
        EXPECT_LT(different, shape->asCurves() ? hits / 25 + 1 : 1) << hits;
    }
}

TEST(Accel, MasksOfEveryShape) {
    int everBehind = 0;
    for (const ShapePtr& shape : oneOfEach()) {
        Scene scene;
        scene.primitives.push_back(primitiveOf(shape));
        scene.primitives[0].alpha = std::make_shared<HalfMask>();
        Scene shadowless;
        shadowless.primitives.push_back(primitiveOf(shape));
        shadowless.primitives[0].shadowAlpha = std::make_shared<HalfMask>();
        Scene clear;
        clear.primitives.push_back(primitiveOf(shape));
        clear.primitives[0].material = nullptr;
        const Accel holes(scene), shadowHoles(shadowless), none(clear);
        int kept = 0, behind = 0;
        forManyRays(1000, [&](const Ray& ray) {
            SurfaceInteraction whole, masked;
            const bool found = shadowHoles.intersect(ray, whole);
            if (holes.intersect(ray, masked)) {
                EXPECT_GE(masked.uv.x, 0.5f);
                ++kept;
                behind += masked.t > whole.t + 0.01f;
                EXPECT_TRUE(holes.occluded(ray.o, ray.d, kInfinity, ray.time));
                EXPECT_TRUE(shadowHoles.occluded(ray.o, ray.d, kInfinity, ray.time));
            } else {
                EXPECT_TRUE(!found || whole.uv.x < 0.5f);
                EXPECT_FALSE(holes.occluded(ray.o, ray.d, kInfinity, ray.time));
                EXPECT_FALSE(shadowHoles.occluded(ray.o, ray.d, kInfinity, ray.time));
            }
            EXPECT_FALSE(none.occluded(ray.o, ray.d, kInfinity, ray.time));
        });
        EXPECT_GT(kept, 20);
        everBehind += behind;
    }
    EXPECT_GT(everBehind, 0);  // some rays pass the hole and hit the far side of the shape
}

TEST(Accel, InstancedShapesAndCurves) {
    const Transform t =
        Transform::translate(Vec3(1, 2, 3)) * Transform::rotate(40, Vec3(1, 1, 0)) * Transform::scale(2, 2, 2);
    for (const ShapePtr& shape : oneOfEach()) {
        Scene scene;
        scene.objects.push_back({"o", {primitiveOf(shape)}});
        scene.instances.push_back({0, t});
        const Accel accel(scene);
        Scene plain;
        plain.primitives.push_back(primitiveOf(shape));
        const Accel reference(plain);
        int hits = 0, different = 0;
        forManyRays(500, [&](const Ray& ray) {
            SurfaceInteraction local, world;
            const bool found = reference.intersect(ray, local);
            const bool met = accel.intersect(rayFrom(t.point(ray.o), normalize(t.vector(ray.d))), world);
            different += met != found;
            if (!met || !found) return;
            ++hits;
            EXPECT_NEAR(world.t, 2 * local.t, 2e-2);
            EXPECT_LT(length(world.p - t.point(local.p)), 2e-2f);
            EXPECT_GT(dot(world.ng, normalize(t.normal(local.ng))), 0.97f);
            EXPECT_LT(length(world.dpdu - t.vector(local.dpdu)), 0.05f * length(world.dpdu));
        });
        EXPECT_GT(hits, 20);
        EXPECT_LE(different, hits / 100 + 1);
    }
}

// Without our check, Debian's build of Embree aborts on rays with invalid coordinates.
TEST(Accel, WhatIsNoRayMeetsNothing) {
    Scene scene;
    Primitive sphere;
    sphere.shape = makeSphere({});
    sphere.material = makeMatte({});
    scene.primitives.push_back(sphere);
    scene.objects.push_back({"small", {sphere}});
    scene.instances.push_back({0, Transform::translate(Vec3(5, 0, 0)) * Transform::scale(1e-8f, 1e-8f, 1e-8f)});
    const Accel accel(scene);
    SurfaceInteraction hit;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float bad : {nan, kInfinity, -kInfinity, 1e19f, -3e38f})
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 o(0, 0, -3), d(0, 0, 1);
            EXPECT_TRUE(accel.intersect(rayFrom(o, d), hit));
            o[axis] = bad;
            EXPECT_FALSE(accel.intersect(rayFrom(o, d), hit));
            EXPECT_FALSE(accel.occluded(o, d, 10, 0));
            o = Vec3(0, 0, -3);
            d[axis] = bad;
            EXPECT_FALSE(accel.intersect(rayFrom(o, d), hit));
            EXPECT_FALSE(accel.occluded(o, d, 10, 0));
        }
    // In the space of the instance the ray's origin is at 1e19.
    EXPECT_FALSE(accel.intersect(rayFrom(Vec3(5, 0, -1e11f), Vec3(0, 0, 1)), hit));
    EXPECT_TRUE(accel.intersect(rayFrom(Vec3(5, 0, -1), Vec3(0, 0, 1)), hit));
}

// A mesh of 250000 triangles takes 5 MB, and its acceleration structure 34 MB more.
TEST(Accel, ScenesThatNeedMoreThanThereIsAreRefused) {
    constexpr uint32_t kSide = 354;
    auto mesh = std::make_shared<TriangleMesh>();
    for (uint32_t y = 0; y <= kSide; ++y)
        for (uint32_t x = 0; x <= kSide; ++x) mesh->positions.push_back(Vec3(float(x), float(y), 0));
    for (uint32_t y = 0; y < kSide; ++y)
        for (uint32_t x = 0; x < kSide; ++x) {
            const uint32_t a = y * (kSide + 1) + x, c = a + kSide + 2;
            mesh->indices.insert(mesh->indices.end(), {a, a + 1, c, a, c, c - 1});
        }
    Scene scene;
    scene.objects.push_back({"o", {Primitive{}}});
    scene.objects[0].primitives[0].mesh = mesh;
    const std::string error = errorOf([&] {
        const AddressSpaceLimit limit(24 << 20);
        const Accel accel(scene);
    });
    EXPECT_THAT(error, testing::StartsWith("tracing rays in a scene of 2.51e+05 triangles and 0 pieces of curves needs "
                                           "about 33 MiB of memory"));
}

// What --stats says of the accelerator: Embree's trees and the copies of meshes, for as long as they live.
TEST(Accel, NotesItsMemory) {
    constexpr int kTriangles = 20000;
    auto mesh = std::make_shared<TriangleMesh>();
    for (int i = 0; i < kTriangles; ++i)
        for (int k = 0; k < 3; ++k) {
            mesh->positions.push_back(Vec3(float(i) + float(k == 1), float(i % 100) + float(k == 2), float(i % 7)));
            mesh->indices.push_back(uint32_t(3 * i + k));
        }
    Scene scene;
    scene.primitives.push_back(
        {.mesh = mesh, .shape = {}, .material = {}, .areaLight = {}, .alpha = {}, .shadowAlpha = {}});
    const int64_t before = memoryUse(MemoryUse::Accelerator);
    {
        const Accel accel(scene);
        const double perTriangle = double(memoryUse(MemoryUse::Accelerator) - before) / kTriangles;
        // Three vertices and a face, and at least its part of the tree.
        EXPECT_GT(perTriangle, 3 * 32 + 24 + 30);
        EXPECT_LT(perTriangle, 3 * 32 + 24 + 200);
    }
    EXPECT_EQ(memoryUse(MemoryUse::Accelerator), before);
}

}  // namespace
}  // namespace drc
