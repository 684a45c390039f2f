// Alpha masks that depend on position.
#include <gtest/gtest.h>

#include "accel/accel.h"
#include "scene/materials/material_matte.h"
#include "scene/shapes/shape_sphere.h"
#include "scene/textures/texture_checkerboard.h"

namespace drc {
namespace {

TEST(Alpha, SolidTexturesHideTheSamePartsOfAShapeFromEveryRay) {
    Scene scene;
    Primitive sphere;
    sphere.shape = makeSphere({});
    sphere.material = makeMatte({});
    sphere.alpha = makeSolidCheckerboardTexture<float>(constantTexture(1.f), constantTexture(0.f),
                                                       Mapping3D(Transform::scale(3, 3, 0.1f)));
    scene.primitives.push_back(sphere);
    const Accel accel(scene);
    int holes = 0, hits = 0;
    for (float x = -0.63f; x < 0.65f; x += 0.05f)
        for (float y = -0.63f; y < 0.65f; y += 0.05f) {
            // From the inside, so that the ray crosses the surface once, at z > 0.
            const Vec3 o(x, y, 0), d(0, 0, 1);
            Ray ray;
            ray.o = o;
            ray.d = d;
            SurfaceInteraction hit;
            const bool isHole = int(std::floor(3 * x) + std::floor(3 * y)) % 2 != 0;
            EXPECT_EQ(accel.intersect(ray, hit), !isHole) << x << " " << y;
            EXPECT_EQ(accel.occluded(o, d, 5, 0), !isHole) << x << " " << y;
            ++(isHole ? holes : hits);
        }
    EXPECT_GT(holes, 100);
    EXPECT_GT(hits, 100);
}

// By rays from the camera alone; whatever stands behind is hit.
TEST(Alpha, SurfacesMayBeHiddenFromTheCamera) {
    for (const bool isMesh : {false, true}) {
        Scene scene;
        Primitive front;
        if (isMesh) {
            auto mesh = std::make_shared<TriangleMesh>();
            mesh->positions = {Vec3(-1, -1, 1), Vec3(3, -1, 1), Vec3(-1, 3, 1)};
            mesh->indices = {0, 1, 2};
            front.mesh = mesh;
        } else {
            front.shape = makeSphere({.objectToWorld = Transform::translate(Vec3(0, 0, 2))});
        }
        front.material = makeMatte({});
        front.visibleToCamera = false;
        Primitive back;
        back.shape = makeSphere({.objectToWorld = Transform::translate(Vec3(0, 0, 6))});
        back.material = front.material;
        scene.primitives = {front, back};
        const Accel accel(scene);
        EXPECT_TRUE(accel.hidesFromCamera());
        Ray ray;
        ray.o = Vec3(0, 0, 0);
        ray.d = Vec3(0, 0, 1);
        SurfaceInteraction hit;
        ASSERT_TRUE(accel.intersect(ray, hit));
        EXPECT_FLOAT_EQ(hit.t, 1);
        // What it spawns is no ray of the camera's any more; what goes on is.
        ray.fromCamera = true;
        EXPECT_FALSE(hit.spawnRay(ray.d).fromCamera);
        EXPECT_TRUE(hit.onward(ray).fromCamera);
        ASSERT_TRUE(accel.intersect(ray, hit));
        EXPECT_FLOAT_EQ(hit.t, 5);
        EXPECT_EQ(hit.primitive, &scene.primitives[1]);
        // It casts its shadow.
        EXPECT_TRUE(accel.occluded(ray.o, ray.d, 3, 0));
    }
}

}  // namespace
}  // namespace drc
