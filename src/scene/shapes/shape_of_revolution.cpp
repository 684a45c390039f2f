#include "scene/shapes/shape_of_revolution.h"

#include <array>
#include <vector>

namespace drc {
namespace {

// Integral of the area element over [a, b], by Gauss-Legendre quadrature with five points.
double integralOfArea(const RevolutionProfile& profile, double a, double b) {
    constexpr double node[3] = {0, 0.5384693101056831, 0.9061798459386640};
    constexpr double weight[3] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
    double sum = weight[0] * profile.areaElement(middle);
    for (int i = 1; i < 3; ++i)
        sum +=
            weight[i] * (profile.areaElement(middle - half * node[i]) + profile.areaElement(middle + half * node[i]));
    return sum * half;
}

// Ends of the sections of [vMin, 1]: vMin, the zeros of radiusSquared in between, and 1. On one side of a zero there
// may be no surface.
std::vector<double> sectionsOf(const RevolutionProfile& profile) {
    std::vector<double> ends = {profile.vMin};
    const auto& c = profile.c;
    const double discriminant = 0.25 * c[1] * c[1] - c[0] * c[2];
    if (c[2] != 0 && discriminant > 0) {
        const double middle = -0.5 * c[1] / c[2], away = std::sqrt(discriminant) / std::abs(c[2]);
        for (const double v : {middle - away, middle + away})
            if (v > profile.vMin && v < 1) ends.push_back(v);
    }
    ends.push_back(1);
    return ends;
}

// Samples v in proportion to the area element.
class AreaTable {
  public:
    explicit AreaTable(const RevolutionProfile& profile) : profile_(profile) {
        const std::vector<double> ends = sectionsOf(profile);
        for (size_t s = 0; s + 1 < ends.size(); ++s) {
            const bool empty = profile.radiusSquared(0.5 * (ends[s] + ends[s + 1])) < 0;
            const int cells = empty ? 1 : kCells;
            for (int i = 0; i < cells; ++i) {
                edges_.push_back(ends[s] + (ends[s + 1] - ends[s]) * i / cells);
                const double next = ends[s] + (ends[s + 1] - ends[s]) * (i + 1) / cells;
                sums_.push_back(sums_.back() + (empty ? 0 : integralOfArea(profile_, edges_.back(), next)));
            }
        }
        edges_.push_back(1);
    }
    double total() const { return sums_.back(); }
    double sample(double u) const {
        const double target = u * total();
        const auto above = std::upper_bound(sums_.begin() + 1, sums_.end() - 1, target);
        const size_t cell = size_t(above - sums_.begin()) - 1;
        const double a = edges_[cell], b = edges_[cell + 1], inCell = target - sums_[cell];
        // Newton's method, which starts at the solution for a constant area element.
        double v = a + (b - a) * inCell / (sums_[cell + 1] - sums_[cell]);
        for (int i = 0; i < 3; ++i) {
            const double element = profile_.areaElement(v);
            if (!(element > 0)) break;
            v = std::clamp(v - (integralOfArea(profile_, a, v) - inCell) / element, a, b);
        }
        return v;
    }

  private:
    static constexpr int kCells = 32;  // per section

    RevolutionProfile profile_;
    std::vector<double> edges_;     // of the cells
    std::vector<double> sums_{0.};  // cumulative areas at the edges
};

class ShapeOfRevolution final : public Shape {
  public:
    ShapeOfRevolution(const Transform& objectToWorld, bool reverseOrientation, float phiMax,
                      const RevolutionProfile& profile)
        : space_(objectToWorld, reverseOrientation),
          profile_(profile),
          maxRadius_(profile.maxRadius()),
          phiMax_(std::clamp(double(phiMax), 0.0, 360.0) * kPiD / 180),
          table_(profile),
          objectArea_(phiMax_ * table_.total()),
          area_(objectArea_) {
        std::array<double, QuadricSpace::kAreaSteps> along;
        for (size_t i = 0; i < along.size(); ++i) along[i] = table_.sample((double(i) + 0.5) / double(along.size()));
        area_ *= space_.meanAreaScale([&](double u, double v) {
            const double at = along[size_t(v * double(along.size()))];
            return normalAt(pointAt(u, at), at);
        });
    }

    // Bounds of a cylinder around the shape.
    Bounds bounds() const override {
        Bounds box;
        const Vec3d x = space_.vectorToWorld(Vec3d(1, 0, 0)), y = space_.vectorToWorld(Vec3d(0, 1, 0));
        for (const double v : {profile_.vMin, 1.0}) {
            const Vec3d centre = space_.pointToWorld(Vec3d(0, 0, profile_.z0 + v * profile_.dz));
            Vec3 low, high;
            for (int i = 0; i < 3; ++i) {
                const double extent = maxRadius_ * std::hypot(x[i], y[i]);
                // Padded for the rounding of hit points to float.
                const double pad = 1e-6 * (std::abs(centre[i]) + extent + std::abs(profile_.dz) * space_.extent(i));
                low[i] = float(centre[i] - extent - pad);
                high[i] = float(centre[i] + extent + pad);
            }
            box.extend(low);
            box.extend(high);
        }
        return box;
    }

    std::optional<ShapeHit> intersect(const Ray& ray, float tMin) const override {
        // d is not normalised, so that t has the same meaning in both spaces.
        const Vec3d origin = space_.pointToObject(ray.o), d = space_.vectorToObject(Vec3d(ray.d));
        // The ray's origin is moved next to the shape, because the coefficients would suffer from cancellation if it
        // were far away.
        const Vec3d centre(0, 0, profile_.z0 + 0.5 * profile_.dz);
        const double start = (centre - origin).dot(d) / d.length2();
        const Vec3d o = origin + d * start;
        const double v = (o.z - profile_.z0) / profile_.dz, dv = d.z / profile_.dz;
        const auto& c = profile_.c;
        const double a2 = d.x * d.x + d.y * d.y - c[2] * dv * dv;
        const double a1 = o.x * d.x + o.y * d.y - dv * (0.5 * c[1] + c[2] * v);  // half the linear coefficient
        const double a0 = o.x * o.x + o.y * o.y - (c[0] + v * (c[1] + v * c[2]));
        const double discriminant = a1 * a1 - a2 * a0;
        if (!(discriminant >= 0)) return {};
        // If a2 is zero, one of the two solutions below is infinite and the other one is the root of the linear
        // equation.
        const double q = -(a1 + std::copysign(std::sqrt(discriminant), a1));
        return nearerHit(start + q / a2, start + a0 / q, tMin, ray.tMax,
                         [&](double t) { return hitAt(origin + d * t, t); });
    }

    float area() const override { return float(area_); }

    ShapeSample sample(const Vec2& u) const override {
        const double v = table_.sample(u.y);
        const Vec3d p = pointAt(u.x, v), n = normalAt(p, v);
        return {Vec3(space_.pointToWorld(p)), space_.normalToWorld(n), areaPdf(n), Vec2(u.x, float(v))};
    }
    float pdf(const ShapePoint& at) const override { return areaPdf(space_.normalToObject(at.ng)); }

    std::optional<ShapeSpot> spotAt(const Vec2& uv) const override {
        const double v = double(uv.y);
        const Vec3d p = pointAt(double(uv.x), v), n = normalAt(p, v);
        const bool exists = v >= profile_.vMin && profile_.radiusSquared(v) >= 0;
        const double area = exists ? profile_.areaElement(v) * phiMax_ * space_.areaScale(n) : 0;
        return ShapeSpot{Vec3(space_.pointToWorld(p)), space_.normalToWorld(n), float(area)};
    }

    ShapeSample sampleFrom(const Vec3& p, const Vec2& u) const override {
        ShapeSample s = sample(u);
        s.pdf = toSolidAngle(s.pdf, p, s.p, s.ng);
        return s;
    }

    float pdfFrom(const Vec3& p, const Vec3&, const ShapePoint& hit) const override {
        return toSolidAngle(areaPdf(space_.normalToObject(hit.ng)), p, hit.p, hit.ng);
    }

  private:
    Vec3d pointAt(double u, double v) const {
        const Vec3d g = profile_.at(v);
        const double cosine = std::cos(u * phiMax_), sine = std::sin(u * phiMax_);
        return Vec3d(g.x * cosine - g.y * sine, g.x * sine + g.y * cosine, g.z);
    }
    // Unit normal along cross(dpdu, dpdv): the gradient of x^2 + y^2 - radiusSquared.
    Vec3d normalAt(const Vec3d& p, double v) const {
        const Vec3d n(p.x * profile_.dz, p.y * profile_.dz, -0.5 * profile_.slope(v));
        const double l = n.length();
        return l > 0 ? n / l : Vec3d(1, 0, 0);  // at the apex of a cone, any normal will do
    }
    // Pdf of sample() per unit world area, where the object-space normal is n.
    float areaPdf(const Vec3d& n) const { return float(1 / (objectArea_ * space_.areaScale(n))); }

    std::optional<ShapeHit> hitAt(Vec3d p, double t) const {
        const double v = (p.z - profile_.z0) / profile_.dz;
        if (!(v >= profile_.vMin && v <= 1)) return {};
        const Vec3d g = profile_.at(v);
        // The angle by which the curve's point must be rotated to reach p.
        double phi = std::atan2(p.y * g.x - p.x * g.y, p.x * g.x + p.y * g.y);
        if (phi < 0) phi += 2 * kPiD;
        if (phi > phiMax_) return {};
        const double cosine = std::cos(phi), sine = std::sin(phi), radius = profile_.radius(v);
        // Moves p exactly onto the surface. On the axis, derivatives are computed at a small distance from it.
        const double away = std::max(radius, 1e-5 * maxRadius_);
        const Vec3d outward = radius > 0 ? Vec3d(g.x * cosine - g.y * sine, g.x * sine + g.y * cosine, 0) / radius
                                         : Vec3d(cosine, sine, 0);
        p = Vec3d(radius * outward.x, radius * outward.y, p.z);
        ShapeHit hit;
        hit.t = float(t);
        hit.p = Vec3(space_.pointToWorld(p));
        hit.uv = Vec2(float(phi / phiMax_), float(v));
        hit.dpdu = Vec3(space_.vectorToWorld(Vec3d(-outward.y, outward.x, 0) * (away * phiMax_)));
        const Vec3d step = profile_.kind == RevolutionProfile::Kind::Parabola
                               ? Vec3d(0.5 * profile_.slope(v) / away, 0, profile_.dz)
                               : profile_.p2 - profile_.p1;
        const Vec3d along(step.x * cosine - step.y * sine, step.x * sine + step.y * cosine, step.z);
        hit.dpdv = Vec3(space_.vectorToWorld(along));
        hit.ng = space_.normalToWorld(normalAt(p, v));
        if (profile_.kind == RevolutionProfile::Kind::Hyperbola) {
            const Vec3d across(-outward.y, outward.x, 0);
            hit.ns = faceForward(space_.normalToWorld(across.cross(along).normalized()), hit.ng);
        }
        return hit;
    }

    QuadricSpace space_;
    RevolutionProfile profile_;
    double maxRadius_, phiMax_;
    AreaTable table_;
    double objectArea_, area_;
};

}  // namespace

RevolutionProfile RevolutionProfile::line(const Vec3d& p1, const Vec3d& p2) {
    RevolutionProfile profile;
    const Vec3d d = p2 - p1;
    profile.z0 = p1.z;
    profile.dz = d.z;
    profile.c[0] = p1.x * p1.x + p1.y * p1.y;
    profile.c[1] = 2 * (p1.x * d.x + p1.y * d.y);
    profile.c[2] = d.x * d.x + d.y * d.y;
    profile.p1 = p1;
    profile.p2 = p2;
    return profile;
}

RevolutionProfile RevolutionProfile::parabola(double radius, double zMin, double zMax) {
    RevolutionProfile profile;
    profile.z0 = zMin;
    profile.dz = zMax - zMin;
    const double perZ = radius * radius / zMax;
    profile.c[0] = perZ * zMin;
    profile.c[1] = perZ * profile.dz;
    profile.c[2] = 0;
    profile.vMin = std::max(0.0, -zMin / profile.dz);
    profile.kind = Kind::Parabola;
    return profile;
}

RevolutionProfile RevolutionProfile::hyperbola(const Vec3d& p1, const Vec3d& p2, double width, double height) {
    RevolutionProfile profile = line(p1, p2);
    profile.c[0] = (1 + height * profile.z0 * profile.z0) / width;
    profile.c[1] = 2 * height * profile.z0 * profile.dz / width;
    profile.c[2] = height * profile.dz * profile.dz / width;
    profile.kind = Kind::Hyperbola;
    return profile;
}

double RevolutionProfile::maxRadius() const {
    const double ends = std::max(radius(vMin), radius(1));
    const double top = -c[1] / (2 * c[2]);  // v of the extremum of the squared radius
    return top > vMin && top < 1 ? std::max(ends, radius(top)) : ends;
}

Vec3d RevolutionProfile::at(double v) const {
    if (kind == Kind::Parabola) return Vec3d(radius(v), 0, z0 + v * dz);
    Vec3d p = p1 + (p2 - p1) * v;
    if (kind == Kind::Line) return p;
    const double away = std::hypot(p.x, p.y);
    if (!(away > 0)) return Vec3d(radius(v), 0, p.z);
    const double k = radius(v) / away;
    return Vec3d(p.x * k, p.y * k, p.z);
}

double RevolutionProfile::areaElement(double v) const {
    // |dp/dphi x dp/dv| = r sqrt(z'^2 + r'^2) for a surface of revolution, where r r' is half the derivative of r^2. If
    // phi depends on v, as for a line that does not intersect the axis, dp/dv changes only along dp/dphi.
    return std::hypot(dz * radius(v), 0.5 * slope(v));
}

ShapePtr makeShapeOfRevolution(const Transform& objectToWorld, bool reverseOrientation, float phiMax,
                               const RevolutionProfile& profile) {
    if (!(AreaTable(profile).total() > 0)) return nullptr;
    return std::make_shared<ShapeOfRevolution>(objectToWorld, reverseOrientation, phiMax, profile);
}

}  // namespace drc
