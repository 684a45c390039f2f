// Triangles with optional normals and texture coordinates.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "math/transform.h"
#include "math/vec.h"

namespace drc {

// Along which directions bump maps displace a mesh that has normals or tangents of its own.
enum class BumpTangents {
    Derivatives,  // those of the position by u and v, in the shading normal's plane
    // Unit vectors in the directions opposite to those. pbrt-v3's program has it so: bumps are turned inside out, and
    // as steep as if the mesh's texture were one unit wide.
    OppositeUnit,
};

struct TriangleMesh {
    std::vector<Vec3> positions;    // world space; in an object's own space if the object is instanced
    std::vector<Vec3> normals;      // unit, empty or one a vertex
    std::vector<Vec2> uvs;          // empty or one a vertex
    std::vector<Vec3> tangents;     // that the shading frame's s goes along, in place of dpdu; empty or one a vertex
    std::vector<uint32_t> indices;  // three a triangle
    // Reverses the geometric normal (pbrt's ReverseOrientation xor a transform that swaps handedness). The normals
    // above are as they will be used: pbrt negates them for ReverseOrientation when it reads the mesh.
    bool flipNormal = false;
    BumpTangents bumpTangents = BumpTangents::Derivatives;

    uint32_t triangleCount() const { return uint32_t(indices.size() / 3); }
    // Geometric normal, unit, with the orientation that pbrt gives it: by winding and flipNormal, then turned to the
    // side of the shading normals where there are any (PBR 3e, section 3.6.2). Zero for a degenerate triangle.
    Vec3 geometricNormal(uint32_t triangle) const;
    float area(uint32_t triangle) const;
    // Moves everything to another space, normals and tangents included, and keeps flipNormal right.
    void apply(const Transform& t);
};

using TriangleMeshPtr = std::shared_ptr<const TriangleMesh>;

}  // namespace drc
