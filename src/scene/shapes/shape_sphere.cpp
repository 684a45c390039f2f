#include "scene/shapes/shape_sphere.h"

#include "math/frame.h"
#include "scene/shapes/quadric_space.h"

namespace drc {
namespace {

class Sphere final : public Shape {
  public:
    explicit Sphere(const SphereParams& p)
        : space_(p.objectToWorld, p.reverseOrientation),
          radius_(p.radius),
          zMin_(std::clamp<double>(std::min(p.zMin, p.zMax), -radius_, radius_)),
          zMax_(std::clamp<double>(std::max(p.zMin, p.zMax), -radius_, radius_)),
          thetaMin_(std::acos(std::clamp(zMin_ / radius_, -1.0, 1.0))),
          thetaMax_(std::acos(std::clamp(zMax_ / radius_, -1.0, 1.0))),
          phiMax_(std::clamp(double(p.phiMax), 0.0, 360.0) * kPiD / 180),
          full_(zMin_ == -radius_ && zMax_ == radius_ && p.phiMax >= 360),
          objectArea_(phiMax_ * radius_ * (zMax_ - zMin_)),
          area_(objectArea_ * space_.meanAreaScale([&](double u, double v) { return pointAt(u, v) / radius_; })) {}

    Bounds bounds() const override {
        // The transformed object-space box, but not larger than the bounds of the whole sphere.
        Bounds box;
        for (int i = 0; i < 8; ++i)
            box.extend(Vec3(space_.pointToWorld(
                Vec3d(i & 1 ? radius_ : -radius_, i & 2 ? radius_ : -radius_, i & 4 ? zMax_ : zMin_))));
        for (int i = 0; i < 3; ++i) {
            const double c = space_.origin()[i], e = radius_ * space_.extent(i);
            // Padded for the rounding of hit points to float.
            const double pad = 1e-6 * (std::abs(c) + e);
            box.min[i] = float(std::max(double(box.min[i]), c - e) - pad);
            box.max[i] = float(std::min(double(box.max[i]), c + e) + pad);
        }
        return box;
    }

    std::optional<ShapeHit> intersect(const Ray& ray, float tMin) const override {
        // d is not normalised, so that t has the same meaning in both spaces.
        const Vec3d o = space_.pointToObject(ray.o), d = space_.vectorToObject(Vec3d(ray.d));
        const double a = d.length2(), b = o.dot(d), c = o.length2() - radius_ * radius_;
        // The discriminant is computed from the distance of the line to the centre, because b^2 - a c cancels for
        // distant or grazing rays.
        const double discriminant = a * (radius_ * radius_ - (o - d * (b / a)).length2());
        if (!(discriminant >= 0)) return {};
        const double q = -(b + std::copysign(std::sqrt(discriminant), b));
        const double t0 = q / a, t1 = q != 0 ? c / q : t0;
        return nearerHit(t0, t1, tMin, ray.tMax, [&](double t) { return hitAt(o + d * t, t); });
    }

    float area() const override { return float(area_); }

    ShapeSample sample(const Vec2& u) const override {
        const Vec3d p = pointAt(u.x, u.y);
        return {Vec3(space_.pointToWorld(p)), space_.normalToWorld(p / radius_), areaPdf(p / radius_), uvOf(p)};
    }
    float pdf(const ShapePoint& at) const override { return areaPdf(space_.normalToObject(at.ng)); }
    bool samplesDirections() const override { return full_ && space_.conformal(); }

    std::optional<ShapeSpot> spotAt(const Vec2& uv) const override {
        const double theta = thetaMin_ + double(uv.y) * (thetaMax_ - thetaMin_), phi = double(uv.x) * phiMax_;
        const Vec3d n(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
        const double area = radius_ * radius_ * std::sin(theta) * std::abs(thetaMax_ - thetaMin_) * phiMax_;
        return ShapeSpot{Vec3(space_.pointToWorld(n * radius_)), space_.normalToWorld(n),
                         float(area * space_.areaScale(n))};
    }

    // Uniform over the cone that the sphere subtends (PBR 3e, section 14.2.2); by area if there is no such cone.
    ShapeSample sampleFrom(const Vec3& p, const Vec2& u) const override {
        const std::optional<Cone> cone = coneFrom(p);
        if (!cone) {
            ShapeSample s = sample(u);
            s.pdf = toSolidAngle(s.pdf, p, s.p, s.ng);
            return s;
        }
        const double h = u.x * cone->oneMinusCos, sin2 = h * (2 - h), cosine = 1 - h;  // h = 1 - cos theta
        const double r = radius_ * space_.scale(), distance = cone->distance;
        // Distance from p to the near intersection, and the angle at the centre between the intersection and p.
        const double hit = distance * cosine - std::sqrt(std::max(0.0, r * r - distance * distance * sin2));
        const double cosAlpha = std::clamp((distance - hit * cosine) / r, -1.0, 1.0);
        const double sinAlpha = std::min(1.0, hit * std::sqrt(std::max(0.0, sin2)) / r);
        const double phi = 2 * kPiD * u.y;
        const Frame frame = Frame::fromNormal(Vec3(-cone->axis));
        const Vec3d n = (Vec3d(frame.s) * (sinAlpha * std::cos(phi)) + Vec3d(frame.t) * (sinAlpha * std::sin(phi)) +
                         Vec3d(frame.n) * cosAlpha)
                            .normalized();
        const Vec3d inObject = space_.normalToObject(Vec3(n));
        return {Vec3(space_.origin() + n * r), space_.normalToWorld(inObject), cone->pdf(), uvOf(inObject * radius_)};
    }

    float pdfFrom(const Vec3& p, const Vec3&, const ShapePoint& hit) const override {
        if (const std::optional<Cone> cone = coneFrom(p)) {
            // Only the near side is sampled, but a ray may hit the far side through a hole of an alpha mask.
            const Vec3d at(hit.p);
            return (at - space_.origin()).dot(Vec3d(p) - at) >= 0 ? cone->pdf() : 0;
        }
        return toSolidAngle(areaPdf(space_.normalToObject(hit.ng)), p, hit.p, hit.ng);
    }

  private:
    struct Cone {
        Vec3d axis;          // unit, towards the centre
        double distance;     // from p to the centre
        double oneMinusCos;  // of the half-angle
        float pdf() const { return float(1 / (2 * kPiD * oneMinusCos)); }
    };

    // Empty for partial spheres and ellipsoids, and if p is inside the sphere or too close.
    std::optional<Cone> coneFrom(const Vec3& p) const {
        if (!full_ || !space_.conformal()) return {};
        const Vec3d toCentre = space_.origin() - Vec3d(p);
        const double d2 = toCentre.length2(), r = radius_ * space_.scale();
        if (d2 <= 1.0001 * r * r) return {};
        const double sin2 = r * r / d2, distance = std::sqrt(d2);
        return Cone{toCentre / distance, distance, sin2 / (1 + std::sqrt(1 - sin2))};
    }

    // A point uniform by area in object space.
    Vec3d pointAt(double u, double v) const {
        const double z = zMin_ + v * (zMax_ - zMin_), r = std::sqrt(std::max(0.0, radius_ * radius_ - z * z));
        return Vec3d(r * std::cos(u * phiMax_), r * std::sin(u * phiMax_), z);
    }
    // Pdf of sample() per unit world area, where the object-space normal is n.
    float areaPdf(const Vec3d& n) const { return float(1 / (objectArea_ * space_.areaScale(n))); }

    // In object space, from 0 to 2 pi.
    static double phiOf(const Vec3d& p) {
        const double phi = std::atan2(p.y, p.x);
        return phi < 0 ? phi + 2 * kPiD : phi;
    }
    Vec2 uvOf(const Vec3d& p) const {
        const double theta = std::acos(std::clamp(p.z / radius_, -1.0, 1.0));
        return Vec2(float(phiOf(p) / phiMax_), float((theta - thetaMin_) / (thetaMax_ - thetaMin_)));
    }

    std::optional<ShapeHit> hitAt(Vec3d p, double t) const {
        p *= radius_ / p.length();
        if (p.x == 0 && p.y == 0) p.x = 1e-5 * radius_;
        if ((zMin_ > -radius_ && p.z < zMin_) || (zMax_ < radius_ && p.z > zMax_) || phiOf(p) > phiMax_) return {};
        const double thetaRange = thetaMax_ - thetaMin_;
        const double rho = std::sqrt(p.x * p.x + p.y * p.y);
        ShapeHit hit;
        hit.t = float(t);
        hit.p = Vec3(space_.pointToWorld(p));
        hit.uv = uvOf(p);
        hit.dpdu = Vec3(space_.vectorToWorld(Vec3d(-p.y, p.x, 0) * phiMax_));
        hit.dpdv = Vec3(space_.vectorToWorld(Vec3d(p.z * p.x / rho, p.z * p.y / rho, -rho) * thetaRange));
        hit.ng = space_.normalToWorld(p / radius_);
        return hit;
    }

    QuadricSpace space_;
    double radius_, zMin_, zMax_, thetaMin_, thetaMax_, phiMax_;
    bool full_;
    double objectArea_, area_;
};

}  // namespace

ShapePtr makeSphere(const SphereParams& params) { return std::make_shared<Sphere>(params); }

}  // namespace drc
