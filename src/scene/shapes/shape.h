// A shape that is not made of triangles: sphere, disk, ... (PBR 3e, chapter 3).
//
// A shape stores its own object-to-world transform. All arguments and results are in world space or, for a shape in an
// instanced object, in the object's space.
#pragma once
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>

#include "math/transform.h"
#include "math/vec.h"
#include "scene/ray.h"

namespace drc {

// Shapes are intersected in double precision.
inline constexpr double kPiD = std::numbers::pi;

struct Bounds {
    Vec3 min{kInfinity, kInfinity, kInfinity};
    Vec3 max{-kInfinity, -kInfinity, -kInfinity};
    void extend(const Vec3& p) {
        for (int i = 0; i < 3; ++i) {
            min[i] = std::min(min[i], p[i]);
            max[i] = std::max(max[i], p[i]);
        }
    }
    // Extends the bounds to contain b; no change if b is empty.
    void extend(const Bounds& b) {
        for (int i = 0; i < 3; ++i) {
            min[i] = std::min(min[i], b.min[i]);
            max[i] = std::max(max[i], b.max[i]);
        }
    }
    bool empty() const { return !(min.x <= max.x); }
    Vec3 center() const { return (min + max) * 0.5f; }
    float radius() const { return empty() ? 0 : length(max - min) * 0.5f; }
};

struct ShapeHit {
    float t = 0;
    Vec3 p;        // on the surface up to rounding of p; the rounding error of o + t d grows with t
    Vec3 ng;       // unit; each shape documents its side
    Vec3 ns{0.f};  // shading normal, unit, on the side of ng; zero if equal to ng
    Vec2 uv;
    Vec3 dpdu, dpdv;
    uint32_t part = 0;  // index of the part, for shapes that consist of several
};

struct ShapeSample {
    Vec3 p;
    Vec3 ng;        // unit
    float pdf = 0;  // per unit area
    Vec2 uv{0.f};   // that of a hit at p
    uint32_t part = 0;
};

// A point of a shape, given by its (u, v).
struct ShapeSpot {
    Vec3 p;
    Vec3 ng;         // unit
    float area = 0;  // per unit area of (u, v); zero where there is no surface
};

// The description of a hit that pdf() and pdfFrom() need.
struct ShapePoint {
    Vec3 p, ng;
    Vec2 uv{0.f};
    uint32_t part = 0;
};

class Curves;

class Shape {
  public:
    virtual ~Shape() = default;
    virtual Bounds bounds() const = 0;
    // Nearest hit with tMin < t < ray.tMax.
    virtual std::optional<ShapeHit> intersect(const Ray& ray, float tMin) const = 0;
    virtual float area() const = 0;
    // Samples a point uniformly by object-space area, or nearly so. The pdf per world-space area varies if the
    // transform stretches the shape unevenly.
    virtual ShapeSample sample(const Vec2& u) const = 0;
    // Pdf of sample() per unit area.
    virtual float pdf(const ShapePoint&) const { return 1 / area(); }
    // Samples a point that illuminates p; the pdf is per solid angle at p. The default is sample() with its pdf
    // converted.
    virtual ShapeSample sampleFrom(const Vec3& p, const Vec2& u) const;
    // Pdf of sampleFrom(p), per solid angle, for the direction wi, which hits the shape at `hit`.
    virtual float pdfFrom(const Vec3& p, const Vec3& wi, const ShapePoint& hit) const;
    // Whether sampleFrom() samples directions by solid angle rather than points by area.
    virtual bool samplesDirections() const { return false; }
    // The point at (u, v) in [0, 1]^2. Empty for shapes whose points are not determined by (u, v).
    virtual std::optional<ShapeSpot> spotAt(const Vec2&) const { return {}; }
    // The (u, v) of the hit of a ray with direction -d (d unit) at a sampled point. By default the sample's own; flat
    // curves turn towards the ray.
    virtual Vec2 uvSeenFrom(const ShapeSample& at, const Vec3& d) const;
    // Whether the surface turns towards each ray, so that rays from different directions find different points and
    // normals.
    virtual bool facesRays() const { return false; }
    // The curves, which Embree intersects itself; null for any other shape.
    virtual const Curves* asCurves() const { return nullptr; }
};

using ShapePtr = std::shared_ptr<const Shape>;

}  // namespace drc
