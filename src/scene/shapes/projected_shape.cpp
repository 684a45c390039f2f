#include "scene/shapes/projected_shape.h"

#include <cmath>
#include <optional>

#include "base/error.h"

namespace drc {
namespace {

// Number of cells (two triangles each) around and along the shape. A silhouette of 256 edges deviates from a circle by
// less than a ten-thousandth of its radius.
constexpr uint32_t kAround = 256, kAlong = 128;

double wOf(const Transform& t, const Vec3& p) {
    return double(t.at(3, 0)) * p.x + double(t.at(3, 1)) * p.y + double(t.at(3, 2)) * p.z + t.at(3, 3);
}

// World-space unit normal at a spot of the shape. The tangent plane, as the four numbers (n, -dot(n, p)), is
// transformed by the inverse transpose of the 4x4 matrix.
Vec3 normalThrough(const Transform& t, const Transform& inverse, const ShapeSpot& spot) {
    const float plane[4] = {spot.ng.x, spot.ng.y, spot.ng.z, -dot(spot.ng, spot.p)};
    Vec3 n(0.f);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 4; ++j) n[i] += inverse.at(j, i) * plane[j];
    // Division by a negative w swaps the two sides of the plane.
    return normalize(wOf(t, spot.p) < 0 ? -n : n);
}

}  // namespace

bool isAffine(const Transform& t) {
    // The last row of an inverted affine matrix may have rounding errors.
    constexpr float kRounding = 1e-9f;
    return std::abs(t.at(3, 0)) < kRounding && std::abs(t.at(3, 1)) < kRounding && std::abs(t.at(3, 2)) < kRounding &&
           std::abs(t.at(3, 3) - 1) < 1e-5f;
}

TriangleMesh projectedShape(const Shape& shape, const Transform& toWorld) {
    TriangleMesh mesh;
    const Transform inverse = toWorld.inverse();
    std::vector<bool> exists;
    std::optional<bool> isInFront;
    for (uint32_t j = 0; j <= kAlong; ++j)
        for (uint32_t i = 0; i <= kAround; ++i) {
            const Vec2 uv(float(i) / kAround, float(j) / kAlong);
            const std::optional<ShapeSpot> spot = shape.spotAt(uv);
            if (!spot) throw Error("such a shape cannot have a transformation with perspective");
            const double w = wOf(toWorld, spot->p);
            if (w == 0 || isInFront.value_or(w > 0) != (w > 0))
                throw Error("its transformation has perspective and moves a part of it to infinity");
            isInFront = w > 0;
            mesh.positions.push_back(toWorld.point(spot->p));
            mesh.normals.push_back(normalThrough(toWorld, inverse, *spot));
            mesh.uvs.push_back(uv);
            // At a pole the area per unit of (u, v) is zero, although there is surface.
            exists.push_back(spot->area > 0 || j == 0 || j == kAlong);
        }
    for (uint32_t j = 0; j < kAlong; ++j)
        for (uint32_t i = 0; i < kAround; ++i) {
            const uint32_t a = j * (kAround + 1) + i, b = a + 1, c = a + kAround + 1, d = c + 1;
            if (!exists[a] || !exists[b] || !exists[c] || !exists[d]) continue;
            mesh.indices.insert(mesh.indices.end(), {a, b, d, a, d, c});
        }
    return mesh;
}

}  // namespace drc
