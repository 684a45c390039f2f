// Rays that leave a surface must neither hit it again nor miss what is close behind.
#include "accel/spawn_point.h"

#include <gtest/gtest.h>

#include <cmath>

#include "accel/accel.h"
#include "math/warp.h"
#include "scene/materials/material_matte.h"
#include "scene/ray_testing.h"

namespace drc {
namespace {

struct Kind {
    const char* name;
    float size;      // of the triangle
    float slimness;  // its width, as a share of its size
    float away;      // from the origin
};
const Kind kKinds[] = {{"usual", 1, 1, 3},
                       {"at the origin", 1, 1, 0},
                       {"huge", 1e5f, 1, 10},
                       {"tiny", 1e-5f, 1, 1},
                       {"tiny, at the origin", 1e-6f, 1, 0},
                       {"slim", 1, 1e-3f, 3},
                       {"far", 1, 1, 1e4f},
                       {"very slim", 1, 1e-5f, 0},
                       {"huge and slim", 1e4f, 1e-3f, 1},
                       {"far and slim", 1, 0.01f, 1e3f}};

class Triangles {
  public:
    explicit Triangles(const Kind& kind) : kind_(kind) {}
    // Two parallel triangles: the second is moved by `gap` along the first one's normal.
    TriangleMesh next(float gap) {
        const Vec3 centre = sampleUniformSphere(rng_.nextVec2()) * kind_.away;
        const Frame f = Frame::fromNormal(sampleUniformSphere(rng_.nextVec2()));
        TriangleMesh mesh;
        for (int i = 0; i < 3; ++i) {
            const Vec2 u = rng_.nextVec2() * 2.f - Vec2(1.f);
            mesh.positions.push_back(centre + (f.s * u.x + f.t * (u.y * kind_.slimness)) * kind_.size);
        }
        mesh.indices = {0, 1, 2};
        const Vec3 n = mesh.geometricNormal(0);
        for (int i = 0; i < 3; ++i) mesh.positions.push_back(mesh.positions[size_t(i)] + n * gap);
        if (gap > 0) mesh.indices.insert(mesh.indices.end(), {3, 4, 5});
        return mesh;
    }
    Pcg32& random() { return rng_; }

  private:
    Kind kind_;
    Pcg32 rng_{11};
};

Primitive primitiveOf(const TriangleMesh& mesh) {
    Primitive p;
    p.mesh = std::make_shared<const TriangleMesh>(mesh);
    p.material = makeMatte({});
    return p;
}

// A hit at random barycentric coordinates, by a ray from nearby.
std::optional<SurfaceInteraction> hitOn(const Accel& accel, const Vec3 corners[3], const Vec3& n, float size,
                                        Pcg32& rng) {
    const Vec2 b = sampleUniformTriangle(rng.nextVec2());
    const Vec3 p = corners[0] * (1 - b.x - b.y) + corners[1] * b.x + corners[2] * b.y;
    const float side = rng.nextFloat() < 0.5f ? -1.f : 1.f;
    const Vec3 d = normalize(n * -side + sampleUniformSphere(rng.nextVec2()) * 0.8f);
    SurfaceInteraction hit;
    if (!accel.intersect(rayFrom(p - d * (0.1f * size), d), hit)) return {};
    return hit;
}

// From grazing ones to those along the normal.
Vec3 directionFrom(const Vec3& n, Pcg32& rng) {
    const Frame f = Frame::fromNormal(n);
    const float phi = 2 * kPi * rng.nextFloat(), elevation = std::pow(10.f, -7 * rng.nextFloat());
    const float side = rng.nextFloat() < 0.5f ? -1.f : 1.f;
    return normalize(f.s * std::cos(phi) + f.t * std::sin(phi) + n * (side * elevation));
}

int hitsAgain(const Accel& accel, const Vec3 corners[3], const Vec3& n, const Kind& kind, Pcg32& rng, int& tried) {
    int again = 0;
    for (int k = 0; k < 20; ++k) {
        const auto hit = hitOn(accel, corners, n, kind.size * kind.slimness, rng);
        if (!hit) continue;
        ++tried;
        SurfaceInteraction next;
        again += accel.intersect(hit->spawnRay(directionFrom(hit->ng, rng)), next);
    }
    return again;
}

Transform randomPlacing(Pcg32& rng) {
    return Transform::translate(sampleUniformSphere(rng.nextVec2()) * 30.f * rng.nextFloat()) *
           Transform::rotate(360 * rng.nextFloat(), sampleUniformSphere(rng.nextVec2())) *
           Transform::scale(0.2f + 3 * rng.nextFloat(), 1.5f, 0.7f);
}

class SpawnPoints : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(On, SpawnPoints, testing::Bool(),
                         [](const auto& i) { return i.param ? "Instances" : "Meshes"; });

TEST_P(SpawnPoints, DoNotHitTheirTriangleAgain) {
    const bool instanced = GetParam();
    for (const Kind& kind : kKinds) {
        SCOPED_TRACE(kind.name);
        Triangles triangles(kind);
        int again = 0, tried = 0;
        for (int i = 0; i < 1000; ++i) {
            TriangleMesh mesh = triangles.next(0);
            if (!(mesh.area(0) > 0)) continue;
            Scene scene;
            if (instanced) {
                const Transform toWorld = randomPlacing(triangles.random());
                scene.objects.push_back({"o", {}});
                scene.objects[0].primitives.push_back(primitiveOf(mesh));
                scene.instances.push_back({0, AnimatedTransform(toWorld, toWorld)});
                mesh.apply(toWorld);
            } else {
                scene.primitives.push_back(primitiveOf(mesh));
            }
            again += hitsAgain(Accel(scene), mesh.positions.data(), mesh.geometricNormal(0), kind, triangles.random(),
                               tried);
        }
        // Rays that are aimed at tiny triangles far away often miss them.
        EXPECT_GT(tried, 1500);
        EXPECT_EQ(again, 0) << "of " << tried;
    }
}

// Gaps of a hundred thousandth of the coordinates, or of the triangle's own size.
TEST(SpawnPoint, WhatIsCloseBehindIsFound) {
    for (const Kind& kind : kKinds) {
        if (kind.slimness < 1) continue;  // the test would miss the other triangle beside it
        SCOPED_TRACE(kind.name);
        const float gap = 2e-5f * std::max(kind.size, kind.away);
        Triangles triangles(kind);
        int found = 0, tried = 0;
        for (int i = 0; i < 1000; ++i) {
            const TriangleMesh mesh = triangles.next(gap);
            if (!(mesh.area(0) > 0.1f * sqr(kind.size))) continue;
            Scene scene;
            scene.primitives.push_back(primitiveOf(mesh));
            const Accel accel(scene);
            const Vec3 n = mesh.geometricNormal(0);
            // From inside the gap to the first triangle, and back.
            const Vec3 p = mesh.positions[0] * 0.4f + mesh.positions[1] * 0.3f + mesh.positions[2] * 0.3f;
            SurfaceInteraction hit, next;
            if (!accel.intersect(rayFrom(p - n * kind.size, n), hit) || hit.triangle != 0) continue;
            ++tried;
            found += accel.intersect(hit.spawnRay(n), next) && next.triangle == 1 && next.t < 2 * gap;
        }
        EXPECT_GT(tried, 200);
        EXPECT_EQ(found, tried);
    }
}

}  // namespace
}  // namespace drc
