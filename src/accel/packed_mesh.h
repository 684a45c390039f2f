// A mesh as hits read it: what a hit needs of a triangle lies in four or five cache lines instead of a dozen.
#pragma once
#include <cstdint>
#include <vector>

#include "accel/interaction.h"

namespace drc {

class PackedMesh {
  public:
    // On all cores. Copies what it needs of the mesh.
    explicit PackedMesh(const TriangleMesh& mesh);

    // Position, normals, uv, derivatives and triangle of the point with barycentric coordinates b1, b2 of the second
    // and third vertex, in the mesh's own space; the rest of the hit stays as it is.
    void fill(uint32_t triangle, float b1, float b2, SurfaceInteraction& hit) const;

    // Starts to fetch what fill() reads first.
    void prefetch(uint32_t triangle) const { __builtin_prefetch(&faces_[triangle]); }

    // For Embree, which reads the position alone: 16 bytes from there on are within the vertex.
    struct alignas(32) Vertex {
        Vec3 p;
        Vec3 n;  // unit, or zero if the mesh has none
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
    std::vector<Vec3> tangents_;  // of vertices; empty if the mesh has none
    bool hasNormals_, hasUvs_;
    BumpTangents bumpTangents_;
};

}  // namespace drc
