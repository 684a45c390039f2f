// Triangles with optional normals and texture coordinates.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "math/transform.h"
#include "math/vec.h"

namespace drc {

// The directions along which bump maps displace meshes that have normals or tangents of their own.
enum class BumpTangents {
    Derivatives,  // the derivatives of position with respect to u and v, projected to the plane of the shading normal
                  // Unit vectors in the opposite directions, as in the pbrt-v3 program: bumps are turned inside out,
                  // and as steep as if the mesh's texture were one unit wide.
    OppositeUnit,
};

struct TriangleMesh {
    std::vector<Vec3> positions;    // world space, or object space if the object is instanced
    std::vector<Vec3> normals;      // unit; empty or one per vertex
    std::vector<Vec2> uvs;          // empty or one per vertex
    std::vector<Vec3> tangents;     // direction of the shading frame's s in place of dpdu; empty or one per vertex
    std::vector<uint32_t> indices;  // three per triangle
    // Flips the geometric normal (pbrt's ReverseOrientation xor a transform that swaps handedness). The normals above
    // are final: pbrt negates them for ReverseOrientation when it reads the mesh.
    bool flipNormal = false;
    BumpTangents bumpTangents = BumpTangents::Derivatives;

    uint32_t triangleCount() const { return uint32_t(indices.size() / 3); }
    // Geometric normal, unit, oriented as in pbrt: by the winding and flipNormal, then flipped to the side of the
    // shading normals if there are any (PBR 3e, section 3.6.2). Zero for a degenerate triangle.
    Vec3 geometricNormal(uint32_t triangle) const;
    float area(uint32_t triangle) const;
    // Transforms everything to another space, including normals and tangents, and adjusts flipNormal.
    void apply(const Transform& t);
};

using TriangleMeshPtr = std::shared_ptr<const TriangleMesh>;

}  // namespace drc
