// A triangle mesh laid out for shading: a hit reads four or five cache lines of it rather than a dozen.
#pragma once
#include <cstdint>
#include <vector>

#include "accel/interaction.h"

namespace drc {

class PackedMesh {
  public:
    // Uses all cores. Copies the data that it needs from the mesh.
    explicit PackedMesh(const TriangleMesh& mesh);

    // Fills in position, normals, uv, derivatives and triangle index for the point with barycentric coordinates b1, b2
    // of the second and third vertex, in the mesh's own space. Leaves the other members of the hit unchanged.
    void fill(uint32_t triangle, float b1, float b2, SurfaceInteraction& hit) const;
    // Moves the hit point that fill() has set inwards if its distance from an edge is less than twice its error: it
    // could lie behind another face that shares the edge, and its rays would escape from a closed box. rounding: a
    // bound, in the mesh's space, on the rounding errors of the point in this space and in world space.
    void keepOffEdges(uint32_t triangle, float b1, float b2, float rounding, SurfaceInteraction& hit) const;

    // Prefetches the face, which fill() reads first.
    void prefetch(uint32_t triangle) const { __builtin_prefetch(&faces_[triangle]); }

    // Embree reads only the position, but with 16-byte loads, which stay within the vertex.
    struct alignas(32) Vertex {
        Vec3 p;
        Vec3 n;  // unit; zero if the mesh has no normals
        Vec2 uv;
    };
    struct Face {
        uint32_t v[3];
        Vec3 ng;  // TriangleMesh::geometricNormal
    };
    const std::vector<Vertex>& vertices() const { return vertices_; }
    const std::vector<Face>& faces() const { return faces_; }

  private:
    std::vector<Vertex> vertices_;
    std::vector<Face> faces_;
    std::vector<Vec3> tangents_;  // per vertex; empty if the mesh has none
    bool hasNormals_, hasUvs_;
    BumpTangents bumpTangents_;
};

}  // namespace drc
