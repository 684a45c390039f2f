// The flat pieces by which an emissive mesh is sampled: triangles, or pairs of them that form a parallelogram, with the
// (u, v) on them.
#pragma once
#include <span>
#include <vector>

#include "scene/shapes/parallelogram.h"
#include "scene/shapes/triangle_mesh.h"

namespace drc {

// A parallelogram, or the half of it at its corner: a triangle.
struct Facet {
    Parallelogram shape;
    Vec3 ng;  // unit
    float area = 0;
    uint32_t triangle = 0;  // of the mesh; the first of two in a parallelogram
    bool half = true;

    Vec3 at(const Vec2& xy) const { return shape.corner + shape.side0 * xy.x + shape.side1 * xy.y; }
    // The (x, y) of a point.
    Vec2 coordinatesOf(const Vec3& p) const;
    // See planeError(). In a parallelogram an upper bound for both triangles, whichever corner rays measure from.
    float planeErrorAt(const Vec3& p) const;
};

// Texture coordinates on a facet: corner + x side0 + y side1.
struct FacetCoordinates {
    Vec2 corner{0.f}, side0{0.f}, side1{0.f};
    bool half = true;
    Vec2 at(const Vec2& xy) const { return corner + side0 * xy.x + side1 * xy.y; }
};

Facet triangleFacet(const TriangleMesh& mesh, uint32_t triangle);
// Joins triangles to parallelograms; with sameCoordinates, only those on which the (u, v) of one continue those of the
// other. Takes time quadratic in the number of triangles. facetOf receives the facet of each triangle.
std::vector<Facet> joinedFacets(const TriangleMesh& mesh, bool sameCoordinates, std::vector<uint32_t>& facetOf);
FacetCoordinates coordinatesOn(const Facet& facet, const TriangleMesh& mesh);

// Area-preserving mapping from the unit square to (x, y) on a facet, and its inverse. It maps straight lines along the
// sides of the square to straight lines.
Vec2 pointOnFacet(const Vec2& u, bool half);
Vec2 squareOfFacet(const Vec2& xy, bool half);

}  // namespace drc
