// Triangles with optional normals and texture coordinates.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "math/transform.h"
#include "math/vec.h"

namespace drc {

// The directions along which bump maps displace meshes that have normals or tangents of their own.
enum class BumpTangents {
    // The derivatives of position with respect to u and v, projected to the plane of the shading normal.
    Derivatives,
    // Unit vectors opposite to the shading frame's s and t, as in the pbrt-v3 program: bumps are turned inside out, and
    // as steep as if the mesh's texture were one unit wide.
    OppositeUnit,
};

// A bound on the distance, along the normal, between a point of a triangle and the plane in which a single-precision
// ray-triangle test places the triangle for a ray that starts at the point. The rounding of the point itself is not
// included. e1, e2: the edges from a corner. p: the point, relative to that corner.
//
// A ray-triangle test depends on the sign of dot(p, n), where n = cross(e1, e2). In each of the three products of
// dot(p, n), the factor of p has an error of one rounding, and the factor of n the errors of its two products and of
// their difference; p and the edges may be computed from coordinates relative to the ray's origin, which doubles the
// number of roundings. The factor below exceeds their sum; SpawnPoint's tests try it with triangles of all kinds.
inline float planeError(const Vec3& e1, const Vec3& e2, const Vec3& p) {
    const Vec3 x(std::abs(e1.y * e2.z) + std::abs(e1.z * e2.y), std::abs(e1.z * e2.x) + std::abs(e1.x * e2.z),
                 std::abs(e1.x * e2.y) + std::abs(e1.y * e2.x));
    const float n = length(cross(e1, e2));
    return n > 0 ? 0x1p-20f * (std::abs(p.x) * x.x + std::abs(p.y) * x.y + std::abs(p.z) * x.z) / n : 0;
}

struct TriangleMesh {
    std::vector<Vec3> positions;    // world space, or object space if the object is instanced
    std::vector<Vec3> normals;      // unit; empty or one per vertex
    std::vector<Vec2> uvs;          // empty or one per vertex
    std::vector<Vec3> tangents;     // replaces dpdu as direction of the shading frame's s; empty or one per vertex
    std::vector<uint32_t> indices;  // three per triangle
    // Flips the geometric normal (pbrt's ReverseOrientation xor a transform that swaps handedness). It does not affect
    // `normals`, which pbrt negates for ReverseOrientation when it reads the mesh.
    bool flipNormal = false;
    BumpTangents bumpTangents = BumpTangents::Derivatives;

    uint32_t triangleCount() const { return uint32_t(indices.size() / 3); }
    // Geometric normal, unit, oriented as in pbrt: by the winding and flipNormal, then flipped to the side of the
    // shading normals if there are any (PBR 3e, section 3.6.2). Zero for a degenerate triangle.
    Vec3 geometricNormal(uint32_t triangle) const;
    float area(uint32_t triangle) const;
    // (u, v) of the corners; without uvs, pbrt's default: (0,0), (1,0), (1,1).
    std::array<Vec2, 3> textureCoordinates(uint32_t triangle) const;
    // Transforms everything to another space, including normals and tangents, and adjusts flipNormal.
    void apply(const Transform& t);
};

using TriangleMeshPtr = std::shared_ptr<const TriangleMesh>;

}  // namespace drc
