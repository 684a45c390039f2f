// Many thin curves of the same type: hair, fur, grass (PBR 3e, section 3.7). Each follows a cubic Bezier curve and has
// no thickness; its width changes linearly along the curve.
#pragma once
#include <array>
#include <mutex>
#include <vector>

#include "math/distribution.h"
#include "scene/shapes/shape.h"

namespace drc {

enum class CurveType {
    Flat,      // always faces the viewer
    Cylinder,  // faces the viewer, with the normals of the inside of a round tube
    Tube,      // faces the viewer, with the normals of the outside of a round tube
    Ribbon,    // oriented by given normals
};

// u runs along each curve and v across it, along dpdv. For curves that face the viewer, dpdv is along cross(ray
// direction, dpdu) as in pbrt, and the normals face the ray, or face away with flipNormal. (In pbrt they face away,
// where nobody could see what the curves emit.) Across a Cylinder, the normals vary as in the pbrt program: those of
// the far inner wall of a hollow tube, which reproduces images made with pbrt. A Tube has the normals of the outside of
// a round tube, as hair has in other renderers. The normal of a Ribbon is the given one, or its opposite with
// flipNormal. In pbrt all of this holds in the shape's own space, so that v runs in the opposite direction if the
// shape's transform mirrors (`mirrored`).
class Curves final : public Shape {
  public:
    Curves(CurveType type, bool flipNormal, bool mirrored = false)
        : type_(type), flipNormal_(flipNormal), mirrored_(mirrored) {}

    // Adds a curve: its control points, and the widths and (for ribbons) unit normals at both ends. A curve whose
    // control points coincide is ignored.
    void add(const std::array<Vec3, 4>& points, const std::array<float, 2>& widths,
             const std::array<Vec3, 2>& normals = {Vec3(0.f), Vec3(0.f)});
    // Number of pieces into which add() would split the curve.
    int piecesOf(const std::array<Vec3, 4>& points, const std::array<float, 2>& widths,
                 const std::array<Vec3, 2>& normals = {Vec3(0.f), Vec3(0.f)}) const;
    // Makes room for the given number of additional pieces. Throws Error if memory does not suffice for them and their
    // acceleration structure.
    void reserve(size_t pieces);
    bool looksLike(const Curves& other) const {
        return type_ == other.type_ && flipNormal_ == other.flipNormal_ && mirrored_ == other.mirrored_;
    }
    // Adds the curves of another set of the same type. Throws Error as reserve() does.
    void append(const Curves& other);

    // Curves are split into pieces of four control points each, such that kLines straight segments approximate a piece
    // well.
    static constexpr int kLines = 8;
    struct ControlPoint {
        Vec3 p;
        float radius = 0;
    };
    struct ControlNormal {
        Vec3 n;
        float unused = 0;  // Embree loads 16 bytes at a time
    };
    CurveType type() const { return type_; }
    uint32_t pieceCount() const { return uint32_t(ranges_.size()); }
    const std::vector<ControlPoint>& controlPoints() const { return points_; }
    const std::vector<ControlNormal>& controlNormals() const { return normals_; }  // ribbons only

    // Describes the hit of a ray on a piece. u: parameter within the piece, in [0, 1]. t: distance along the ray.
    ShapeHit hitAt(uint32_t piece, float u, const Ray& ray, float t) const;

    const Curves* asCurves() const override { return this; }
    bool facesRays() const override { return type_ != CurveType::Ribbon; }
    Bounds bounds() const override { return bounds_; }
    // Tests all pieces, for unit tests. Rendering uses Embree.
    std::optional<ShapeHit> intersect(const Ray& ray, float tMin) const override;
    // Curves that face the ray count as round tubes, whose projected area, averaged over all directions, equals theirs.
    float area() const override;
    ShapeSample sample(const Vec2& u) const override;
    // Samples the side that faces p and returns the pdf per solid angle. `part` is the index of the piece.
    ShapeSample sampleFrom(const Vec3& p, const Vec2& u) const override;
    float pdfFrom(const Vec3& p, const Vec3& wi, const ShapePoint& hit) const override;
    Vec2 uvSeenFrom(const ShapeSample& at, const Vec3& d) const override;

  private:
    // A point of a piece's axis, its first and second derivative with respect to the piece's parameter, the radius
    // (half the width) and the derivative of the radius.
    struct Point {
        Vec3 p, d1, d2;
        float radius, radiusStep;
    };
    Point at(uint32_t piece, float u) const;
    Vec3 normalAt(uint32_t piece, float u, Vec3* derivative = nullptr) const;
    // Converts u of the whole curve to the parameter of the piece.
    float inPiece(uint32_t piece, float u) const;
    // Unit vector across the curve: perpendicular to its direction `along` and to the normal `facing`.
    static Vec3 across(const Vec3& facing, const Vec3& along);
    const Distribution1D& lengths() const;
    struct Chosen {
        uint32_t piece;
        float u, pdf;  // parameter within the piece, and pdf per unit of that parameter
    };
    Chosen choose(float u) const;
    // Pdf of sampleFrom(p), per solid angle at p, for the point at the signed distance s * radius from the curve's
    // axis, s in [-1, 1].
    float density(const Vec3& p, const Chosen& at, float s) const;

    CurveType type_;
    bool flipNormal_, mirrored_;
    std::vector<ControlPoint> points_;
    std::vector<ControlNormal> normals_;
    std::vector<Vec2> ranges_;  // for each piece, u of the whole curve at the piece's ends
    Bounds bounds_;
    mutable std::once_flag lengthsOnce_;
    mutable Distribution1D lengths_;  // radius * length of each of the kStepsPerPiece steps of each piece
};

}  // namespace drc
