// Many thin curves with one look: hair, fur, grass (PBR 3e, section 3.7). Each is a cubic Bezier curve whose width
// changes linearly along it; none has a thickness.
#pragma once
#include <array>
#include <mutex>
#include <vector>

#include "math/distribution.h"
#include "scene/shape.h"

namespace drc {

enum class CurveType {
    Flat,      // turns its broad side to whoever looks
    Cylinder,  // the same, with the normals of the inside of a round tube
    Ribbon,    // broad side along a given normal
};

// u runs along each curve and v across it, along dpdv. Flat curves and cylinders have dpdv along cross(ray direction,
// dpdu) as in pbrt, and normals towards the ray, or away from it for flipNormal. (pbrt's point away, where nobody could
// see what they emit.) Across a cylinder the normals turn the way that pbrt's program turns them, so that it is shaded
// as if it were hollow and one looked at its far side: pictures made with pbrt look so. The normal of a ribbon is the
// given one, or its opposite for flipNormal. In pbrt all this is so in the space of the shape: where its transformation
// mirrors, v runs the other way.
class Curves final : public Shape {
  public:
    Curves(CurveType type, bool flipNormal, bool mirrored = false)
        : type_(type), flipNormal_(flipNormal), mirrored_(mirrored) {}

    // Control points, and the widths and (for ribbons) unit normals at both ends. Nothing for a curve without length.
    void add(const std::array<Vec3, 4>& points, const std::array<float, 2>& widths,
             const std::array<Vec3, 2>& normals = {Vec3(0.f), Vec3(0.f)});
    // How many pieces that makes.
    int piecesOf(const std::array<Vec3, 4>& points, const std::array<float, 2>& widths,
                 const std::array<Vec3, 2>& normals = {Vec3(0.f), Vec3(0.f)}) const;
    // Makes room for so many pieces more. Throws Error if there is less memory than they and what rays need of them
    // take.
    void reserve(size_t pieces);
    bool looksLike(const Curves& other) const {
        return type_ == other.type_ && flipNormal_ == other.flipNormal_ && mirrored_ == other.mirrored_;
    }
    // Those of another set that looks like this one. Throws Error as reserve() does.
    void append(const Curves& other);

    // Curves are kept in pieces that kLines straight lines follow closely: four control points each.
    static constexpr int kLines = 8;
    struct ControlPoint {
        Vec3 p;
        float radius = 0;
    };
    struct ControlNormal {
        Vec3 n;
        float unused = 0;  // Embree loads 16 bytes
    };
    CurveType type() const { return type_; }
    uint32_t pieceCount() const { return uint32_t(ranges_.size()); }
    const std::vector<ControlPoint>& controlPoints() const { return points_; }
    const std::vector<ControlNormal>& controlNormals() const { return normals_; }  // ribbons only

    // The hit of a ray at distance t with a piece, at the parameter u of that piece.
    ShapeHit hitAt(uint32_t piece, float u, const Ray& ray, float t) const;

    const Curves* asCurves() const override { return this; }
    Bounds bounds() const override { return bounds_; }
    // Tries all pieces: for tests. Embree is for the rest.
    std::optional<ShapeHit> intersect(const Ray& ray, float tMin) const override;
    // Flat curves and cylinders have the area of round tubes: they show as much of it to all directions together.
    float area() const override;
    ShapeSample sample(const Vec2& u) const override;
    // On the broad side that p sees, where this density is known; hits tell their piece and uv.
    ShapeSample sampleFrom(const Vec3& p, const Vec2& u) const override;
    float pdfFrom(const Vec3& p, const Vec3& wi, const ShapePoint& hit) const override;

  private:
    // A point of a piece with its derivatives by the piece's parameter.
    struct Point {
        Vec3 p, d1, d2;
        float radius, radiusStep;
    };
    Point at(uint32_t piece, float u) const;
    Vec3 normalAt(uint32_t piece, float u, Vec3* derivative = nullptr) const;
    // Unit vector across the curve, in the broad side that is perpendicular to `facing`.
    static Vec3 across(const Vec3& facing, const Vec3& along);
    const Distribution1D& lengths() const;
    struct Chosen {
        uint32_t piece;
        float u, pdf;  // density by the piece's parameter
    };
    Chosen choose(float u) const;
    // Of sampleFrom(p): per solid angle, for the point a share s (-1 to 1) of the radius off the curve.
    float density(const Vec3& p, const Chosen& at, float s) const;

    CurveType type_;
    bool flipNormal_, mirrored_;
    std::vector<ControlPoint> points_;
    std::vector<ControlNormal> normals_;
    std::vector<Vec2> ranges_;  // of a piece: the whole curve's u where it begins and ends
    Bounds bounds_;
    mutable std::once_flag lengthsOnce_;
    mutable Distribution1D lengths_;  // radius times length along the pieces, in equal steps of their parameters
};

}  // namespace drc
