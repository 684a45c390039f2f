#include "scene/lights/facet.h"

#include <algorithm>

#include "math/warp.h"

namespace drc {
namespace {

// Tolerance for the (u, v) of two triangles that share one affine mapping, relative to the magnitude of (u, v).
constexpr float kSameCoordinates = 1e-5f;

std::array<Vec3, 3> cornersOf(const TriangleMesh& mesh, uint32_t triangle) {
    std::array<Vec3, 3> corners;
    for (size_t k = 0; k < 3; ++k) corners[k] = mesh.positions[mesh.indices[3 * size_t(triangle) + k]];
    return corners;
}

// Whether the triangle, which is one half of the parallelogram `whole`, has the (u, v) that `coordinates` gives at its
// corners.
bool continues(const FacetCoordinates& coordinates, const Facet& whole, const TriangleMesh& mesh, uint32_t triangle) {
    const std::array<Vec3, 3> corners = cornersOf(mesh, triangle);
    const std::array<Vec2, 3> uv = mesh.textureCoordinates(triangle);
    for (size_t k = 0; k < 3; ++k) {
        const Vec2 xy = whole.coordinatesOf(corners[k]),
                   expected = coordinates.at(Vec2(std::round(xy.x), std::round(xy.y)));
        const float scale = std::max({1.f, std::abs(expected.x), std::abs(expected.y)});
        if (!((uv[k] - expected).length() <= kSameCoordinates * scale)) return false;
    }
    return true;
}

}  // namespace

Vec2 Facet::coordinatesOf(const Vec3& p) const {
    const Vec3 n = cross(shape.side0, shape.side1), d = p - shape.corner;
    const float squared = lengthSquared(n);
    return Vec2(dot(cross(d, shape.side1), n) / squared, dot(cross(shape.side0, d), n) / squared);
}

float Facet::planeErrorAt(const Vec3& p) const {
    const Vec3 &a = shape.side0, &b = shape.side1;
    const Vec3 farthest(std::abs(a.x) + std::abs(b.x), std::abs(a.y) + std::abs(b.y), std::abs(a.z) + std::abs(b.z));
    return planeError(a, b, half ? p - shape.corner : farthest);
}

Facet triangleFacet(const TriangleMesh& mesh, uint32_t triangle) {
    const auto [a, b, c] = cornersOf(mesh, triangle);
    return {{a, b - a, c - a}, mesh.geometricNormal(triangle), mesh.area(triangle), triangle, true};
}

std::vector<Facet> joinedFacets(const TriangleMesh& mesh, bool sameCoordinates, std::vector<uint32_t>& facetOf) {
    const uint32_t count = mesh.triangleCount();
    std::vector<Facet> facets;
    std::vector<bool> taken(count);
    facetOf.resize(count);
    for (uint32_t i = 0; i < count; ++i) {
        if (taken[i]) continue;
        Facet facet = triangleFacet(mesh, i);
        facetOf[i] = uint32_t(facets.size());
        for (uint32_t j = i + 1; j < count && facet.half; ++j) {
            // Shading normals may have flipped the geometric normal of one of the two.
            if (taken[j] || !(dot(facet.ng, mesh.geometricNormal(j)) > 0)) continue;
            const auto shape = parallelogramOf(cornersOf(mesh, i), cornersOf(mesh, j));
            if (!shape) continue;
            const Facet whole{*shape, facet.ng, facet.area + mesh.area(j), i, false};
            if (sameCoordinates && !continues(coordinatesOn(whole, mesh), whole, mesh, j)) continue;
            facet = whole;
            taken[j] = true;
            facetOf[j] = facetOf[i];
        }
        facets.push_back(facet);
    }
    return facets;
}

FacetCoordinates coordinatesOn(const Facet& facet, const TriangleMesh& mesh) {
    const std::array<Vec3, 3> corners = cornersOf(mesh, facet.triangle);
    const std::array<Vec2, 3> uv = mesh.textureCoordinates(facet.triangle);
    // The facet's corner is a vertex of its triangle.
    const auto first = std::ranges::find(corners, facet.shape.corner) - corners.begin();
    const auto at = [&](ptrdiff_t k) { return uv[size_t((first + k) % 3)]; };
    return {at(0), at(1) - at(0), at(2) - at(0), facet.half};
}

Vec2 pointOnFacet(const Vec2& u, bool half) {
    if (!half) return u;
    const Vec2 b = sampleUniformTriangle(u);
    return Vec2(b.y, 1 - b.x - b.y);
}

Vec2 squareOfFacet(const Vec2& xy, bool half) {
    if (!half) return xy;
    const float s = xy.x + xy.y;
    return Vec2(s * s, s > 0 ? xy.x / s : 0);
}

}  // namespace drc
