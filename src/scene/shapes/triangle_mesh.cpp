#include "scene/shapes/triangle_mesh.h"

namespace drc {
namespace {

// Normal given by the winding; its length is twice the area. pbrt uses the two edges from the third vertex; the cross
// product of any two edges in the order of the winding is the same.
Imath::V3d windingNormal(const TriangleMesh& mesh, uint32_t triangle) {
    const uint32_t* v = &mesh.indices[3 * size_t(triangle)];
    const Imath::V3d p2(mesh.positions[v[2]]);
    return (Imath::V3d(mesh.positions[v[0]]) - p2).cross(Imath::V3d(mesh.positions[v[1]]) - p2);
}

}  // namespace

Vec3 TriangleMesh::geometricNormal(uint32_t triangle) const {
    const Imath::V3d cross = windingNormal(*this, triangle);
    const double l = cross.length();
    if (!(l > 0)) return Vec3(0, 0, 0);
    const Vec3 n(cross * ((flipNormal ? -1 : 1) / l));
    if (normals.empty()) return n;
    const uint32_t* v = &indices[3 * size_t(triangle)];
    return faceForward(n, normals[v[0]] + normals[v[1]] + normals[v[2]]);
}

float TriangleMesh::area(uint32_t triangle) const {
    return static_cast<float>(0.5 * windingNormal(*this, triangle).length());
}

std::array<Vec2, 3> TriangleMesh::textureCoordinates(uint32_t triangle) const {
    if (uvs.empty()) return {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)};
    const uint32_t* v = &indices[3 * size_t(triangle)];
    return {uvs[v[0]], uvs[v[1]], uvs[v[2]]};
}

void TriangleMesh::apply(const Transform& t) {
    for (Vec3& p : positions) p = t.point(p);
    for (Vec3& n : normals) n = normalize(t.normal(n));
    for (Vec3& s : tangents) s = t.vector(s);
    // Normals transform by the inverse transpose; cross products of edges are multiplied by the determinant as well.
    flipNormal ^= t.swapsHandedness();
}

}  // namespace drc
