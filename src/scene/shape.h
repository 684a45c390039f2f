// A shape that is not made of triangles: sphere, disk, ... (PBR 3e, chapter 3).
//
// The shape has its own transform to world space; every argument and result here is in world space (or in the space
// of the instanced object that it belongs to).
#pragma once
#include <cstdint>
#include <memory>
#include <optional>

#include "math/transform.h"
#include "math/vec.h"
#include "scene/ray.h"

namespace drc {

struct Bounds {
    Vec3 min{kInfinity, kInfinity, kInfinity};
    Vec3 max{-kInfinity, -kInfinity, -kInfinity};
    void extend(const Vec3& p) {
        for (int i = 0; i < 3; ++i) {
            min[i] = std::min(min[i], p[i]);
            max[i] = std::max(max[i], p[i]);
        }
    }
    // By nothing, if b is empty.
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
    Vec3 p;        // on the surface, which the ray at t is only to the rounding of its own length
    Vec3 ng;       // unit, oriented as pbrt does
    Vec3 ns{0.f};  // shading normal, unit, on the side of ng; zero: ng itself
    Vec2 uv;
    Vec3 dpdu, dpdv;
    uint32_t part = 0;  // of shapes that have several
};

struct ShapeSample {
    Vec3 p;
    Vec3 ng;        // unit
    float pdf = 0;  // per unit area
};

// What pdfFrom needs to know of a hit.
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
    // Uniform by area.
    virtual ShapeSample sample(const Vec2& u) const = 0;
    // A point seen from p, with its density per solid angle at p in `pdf`; by default sample() converted.
    virtual ShapeSample sampleFrom(const Vec3& p, const Vec2& u) const;
    // Density per solid angle of sampleFrom(p) for the direction wi, where wi hits the shape at `hit`.
    virtual float pdfFrom(const Vec3& p, const Vec3& wi, const ShapePoint& hit) const;
    // Curves, which Embree intersects by itself; null for any other shape.
    virtual const Curves* asCurves() const { return nullptr; }
};

using ShapePtr = std::shared_ptr<const Shape>;

}  // namespace drc
