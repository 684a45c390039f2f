#include "accel/packed_mesh.h"

#include "base/parallel.h"

namespace drc {
namespace {

constexpr int kGrain = 4096;
// Largest barycentric coordinate to which a point is moved to keep it off an edge.
constexpr float kFarthestInside = 0.05f;

}  // namespace

PackedMesh::PackedMesh(const TriangleMesh& mesh)
    : tangents_(mesh.tangents),
      hasNormals_(!mesh.normals.empty()),
      hasUvs_(!mesh.uvs.empty()),
      bumpTangents_(hasNormals_ || !tangents_.empty() ? mesh.bumpTangents : BumpTangents::Derivatives) {
    vertices_.resize(mesh.positions.size());
    parallelFor(0, int(vertices_.size()), kGrain, [&](int begin, int end) {
        for (auto i = size_t(begin); i < size_t(end); ++i)
            vertices_[i] = {mesh.positions[i], hasNormals_ ? mesh.normals[i] : Vec3(0.f),
                            hasUvs_ ? mesh.uvs[i] : Vec2(0.f)};
    });
    faces_.resize(mesh.triangleCount());
    parallelFor(0, int(faces_.size()), kGrain, [&](int begin, int end) {
        for (auto i = size_t(begin); i < size_t(end); ++i)
            faces_[i] = {{mesh.indices[3 * i], mesh.indices[3 * i + 1], mesh.indices[3 * i + 2]},
                         mesh.geometricNormal(uint32_t(i))};
    });
}

void PackedMesh::fill(uint32_t triangle, float b1, float b2, SurfaceInteraction& hit) const {
    const Face& face = faces_[triangle];
    const Vertex &v0 = vertices_[face.v[0]], &v1 = vertices_[face.v[1]], &v2 = vertices_[face.v[2]];
    const float b0 = 1 - b1 - b2;
    const Vec3 e1 = v1.p - v0.p, e2 = v2.p - v0.p;
    hit.triangle = triangle;
    hit.p = v0.p * b0 + v1.p * b1 + v2.p * b2;
    hit.ng = face.ng;
    hit.error = planeError(e1, e2, hit.p - v0.p);

    // pbrt's default texture coordinates for triangles without any: (0,0), (1,0), (1,1).
    const Vec2 uv0 = hasUvs_ ? v0.uv : Vec2(0, 0);
    const Vec2 d1 = hasUvs_ ? v1.uv - uv0 : Vec2(1, 0), d2 = hasUvs_ ? v2.uv - uv0 : Vec2(1, 1);
    hit.uv = uv0 + d1 * b1 + d2 * b2;
    const float determinant = d1.x * d2.y - d1.y * d2.x;
    if (std::abs(determinant) > 1e-12f) {
        const float inv = 1 / determinant;
        hit.dpdu = (e1 * d2.y - e2 * d1.y) * inv;
        hit.dpdv = (e2 * d1.x - e1 * d2.x) * inv;
    } else {
        const Frame f = Frame::fromNormal(hit.ng);
        hit.dpdu = f.s;
        hit.dpdv = f.t;
    }

    hit.bumpTangents = bumpTangents_;
    hit.tangent = hit.dpdu;
    if (!tangents_.empty()) {
        const Vec3 s = tangents_[face.v[0]] * b0 + tangents_[face.v[1]] * b1 + tangents_[face.v[2]] * b2;
        if (lengthSquared(s) > 0) hit.tangent = s;
    }

    hit.ns = hit.ng;
    if (hasNormals_) {
        const Vec3 n = v0.n * b0 + v1.n * b1 + v2.n * b2;
        const float l2 = lengthSquared(n);
        if (l2 > 1e-12f) hit.ns = faceForward(n * (1 / std::sqrt(l2)), hit.ng);
    }
}

void PackedMesh::keepOffEdges(uint32_t triangle, float b1, float b2, float rounding, SurfaceInteraction& hit) const {
    const float b0 = 1 - b1 - b2, nearest = std::min({b0, b1, b2});
    if (nearest >= kFarthestInside) return;
    const Face& face = faces_[triangle];
    const Vec3 &v0 = vertices_[face.v[0]].p, &v1 = vertices_[face.v[1]].p, &v2 = vertices_[face.v[2]].p;
    const Vec3 e1 = v1 - v0, e2 = v2 - v0;
    // The least height of the triangle is the one above the longest edge. far: twice the error, relative to this
    // height.
    const float longest = std::max({lengthSquared(e1), lengthSquared(e2), lengthSquared(e2 - e1)});
    const float far = 2 * (hit.error + rounding) * std::sqrt(longest / lengthSquared(cross(e1, e2)));
    if (!(nearest < far)) return;
    const float least = std::min(far, kFarthestInside);
    const float inside0 = std::max(b0, least), inside1 = std::max(b1, least), inside2 = std::max(b2, least);
    hit.p = (v0 * inside0 + v1 * inside1 + v2 * inside2) * (1 / (inside0 + inside1 + inside2));
}

}  // namespace drc
