// Flat pieces for sampling an emissive mesh, with their (u, v): a piece is a triangle, or two triangles that form a
// parallelogram.
#pragma once
#include <span>
#include <vector>

#include "scene/shapes/parallelogram.h"
#include "scene/shapes/triangle_mesh.h"

namespace drc {

// A parallelogram, or (half) the triangle between its corner and its two sides.
struct Facet {
    Parallelogram shape;
    Vec3 ng;  // unit
    float area = 0;
    uint32_t triangle = 0;  // index in the mesh; for a parallelogram, of its first triangle
    bool half = true;

    Vec3 at(const Vec2& xy) const { return shape.corner + shape.side0 * xy.x + shape.side1 * xy.y; }
    // Inverse of at(), for a point in the facet's plane.
    Vec2 coordinatesOf(const Vec3& p) const;
    // planeError() at p. For a parallelogram, an upper bound that holds for both triangles and any of their corners as
    // the origin of planeError()'s edges.
    float planeErrorAt(const Vec3& p) const;
};

// Texture coordinates on a facet: corner + x side0 + y side1.
struct FacetCoordinates {
    Vec2 corner{0.f}, side0{0.f}, side1{0.f};
    bool half = true;
    Vec2 at(const Vec2& xy) const { return corner + side0 * xy.x + side1 * xy.y; }
};

Facet triangleFacet(const TriangleMesh& mesh, uint32_t triangle);
// Joins pairs of triangles that form a parallelogram; with sameCoordinates, only pairs whose (u, v) are one affine
// mapping. The time is quadratic in the number of triangles. facetOf receives the index of each triangle's facet.
std::vector<Facet> joinedFacets(const TriangleMesh& mesh, bool sameCoordinates, std::vector<uint32_t>& facetOf);
FacetCoordinates coordinatesOn(const Facet& facet, const TriangleMesh& mesh);

// Mapping from the unit square to (x, y) on a facet, area-preserving up to a constant factor, and its inverse. It maps
// lines parallel to the sides of the square to straight lines.
Vec2 pointOnFacet(const Vec2& u, bool half);
Vec2 squareOfFacet(const Vec2& xy, bool half);

}  // namespace drc
