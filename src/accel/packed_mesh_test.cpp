#include "accel/packed_mesh.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

// Two triangles that share an edge. Positions, normals and texture coordinates differ at every vertex.
TriangleMesh mesh() {
    TriangleMesh m;
    m.positions = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 3, 0), Vec3(0, 3, 1)};
    m.indices = {0, 1, 2, 0, 2, 3};
    return m;
}

SurfaceInteraction at(const TriangleMesh& m, uint32_t triangle, float b1, float b2) {
    SurfaceInteraction hit;
    PackedMesh(m).fill(triangle, b1, b2, hit);
    return hit;
}

void expectNear(const Vec3& a, const Vec3& b) { EXPECT_LT(length(a - b), 1e-6f) << a << " and " << b; }

TEST(PackedMesh, PositionIsThatOfTheBarycentricCoordinates) {
    expectNear(at(mesh(), 0, 0, 0).p, Vec3(0, 0, 0));
    expectNear(at(mesh(), 0, 1, 0).p, Vec3(2, 0, 0));
    expectNear(at(mesh(), 1, 0.25f, 0.5f).p, Vec3(0.5f, 2.25f, 0.5f));
    EXPECT_EQ(at(mesh(), 1, 0.25f, 0.5f).triangle, 1u);
}

TEST(PackedMesh, NormalIsTheMeshesOwn) {
    TriangleMesh m = mesh();
    expectNear(at(m, 1, 0.2f, 0.2f).ng, m.geometricNormal(1));
    expectNear(at(m, 1, 0.2f, 0.2f).ns, m.geometricNormal(1));
    m.flipNormal = true;
    expectNear(at(m, 0, 0.2f, 0.2f).ng, Vec3(0, 0, -1));
}

TEST(PackedMesh, ShadingNormalIsInterpolated) {
    TriangleMesh m = mesh();
    m.normals = {Vec3(0, 0, 1), Vec3(0.6f, 0, 0.8f), Vec3(0, 0, 1), Vec3(0, 0.6f, 0.8f)};
    expectNear(at(m, 0, 1, 0).ns, Vec3(0.6f, 0, 0.8f));
    expectNear(at(m, 0, 0.5f, 0).ns, normalize(Vec3(0.3f, 0, 0.9f)));
    expectNear(at(m, 1, 0.5f, 0.5f).ns, normalize(Vec3(0, 0.3f, 0.9f)));
    // Where interpolated normals cancel, the geometric normal is used.
    m.normals = {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, 1)};
    const SurfaceInteraction hit = at(m, 0, 0.5f, 0);
    EXPECT_EQ(hit.ns, hit.ng);
}

TEST(PackedMesh, TangentsAreTheMeshesOwnOrDpdu) {
    TriangleMesh m = mesh();
    m.bumpTangents = BumpTangents::OppositeUnit;
    EXPECT_EQ(at(m, 0, 0.5f, 0).tangent, at(m, 0, 0.5f, 0).dpdu);
    EXPECT_EQ(at(m, 0, 0.5f, 0).bumpTangents, BumpTangents::Derivatives) << "it has no normals";
    m.tangents = {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, 0, 0)};
    expectNear(at(m, 0, 0.5f, 0.25f).tangent, Vec3(0.25f, 0.5f, 0.25f));
    EXPECT_EQ(at(m, 1, 0, 1).tangent, at(m, 1, 0, 1).dpdu) << "where they vanish";
    EXPECT_EQ(at(m, 0, 0.5f, 0).bumpTangents, BumpTangents::OppositeUnit);
    m.tangents.clear();
    m.normals = {Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1)};
    EXPECT_EQ(at(m, 0, 0.5f, 0).bumpTangents, BumpTangents::OppositeUnit);
}

TEST(PackedMesh, CoordinatesAndDerivatives) {
    TriangleMesh m = mesh();
    // Without texture coordinates, pbrt's defaults are used.
    EXPECT_EQ(at(m, 0, 1, 0).uv, Vec2(1, 0));
    EXPECT_EQ(at(m, 0, 0, 1).uv, Vec2(1, 1));
    m.uvs = {Vec2(0, 0), Vec2(1, 0), Vec2(1, 2), Vec2(0, 2)};
    for (const uint32_t triangle : {0u, 1u}) {
        const SurfaceInteraction a = at(m, triangle, 0.2f, 0.3f), b = at(m, triangle, 0.3f, 0.5f);
        const Vec2 step = b.uv - a.uv;
        EXPECT_LT(length(a.dpdu * step.x + a.dpdv * step.y - (b.p - a.p)), 1e-5f);
    }
    // Degenerate texture coordinates must still give two tangents in the triangle's plane.
    m.uvs = {Vec2(0, 0), Vec2(0, 0), Vec2(0, 0), Vec2(0, 0)};
    const SurfaceInteraction hit = at(m, 1, 0.2f, 0.3f);
    EXPECT_NEAR(dot(hit.dpdu, hit.ng), 0, 1e-6);
    EXPECT_NEAR(dot(hit.dpdv, hit.ng), 0, 1e-6);
    EXPECT_NEAR(length(cross(hit.dpdu, hit.dpdv)), 1, 1e-5);
}

}  // namespace
}  // namespace drc
