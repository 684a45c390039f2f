#include "scene/shapes/shape_disk.h"

#include "math/warp.h"
#include "scene/shapes/quadric_space.h"

namespace drc {
namespace {

const Vec3d kObjectNormal(0, 0, 1);

class Disk final : public Shape {
  public:
    explicit Disk(const DiskParams& p)
        : space_(p.objectToWorld, p.reverseOrientation),
          height_(p.height),
          radius_(p.radius),
          innerRadius_(p.innerRadius),
          phiMax_(std::clamp(double(p.phiMax), 0.0, 360.0) * kPiD / 180),
          ng_(space_.normalToWorld(kObjectNormal)),
          area_(0.5 * phiMax_ * (radius_ * radius_ - innerRadius_ * innerRadius_) * space_.areaScale(kObjectNormal)) {}

    Bounds bounds() const override {
        Bounds box;
        for (int i = 0; i < 4; ++i)
            box.extend(
                Vec3(space_.pointToWorld(Vec3d(i & 1 ? radius_ : -radius_, i & 2 ? radius_ : -radius_, height_))));
        // Padded for the rounding of hit points to float. The padding also gives a flat box some thickness.
        const float pad = 1e-6f * (box.radius() + length(box.center()));
        box.min -= Vec3(pad, pad, pad);
        box.max += Vec3(pad, pad, pad);
        return box;
    }

    std::optional<ShapeHit> intersect(const Ray& ray, float tMin) const override {
        const Vec3d o = space_.pointToObject(ray.o), d = space_.vectorToObject(Vec3d(ray.d));
        if (d.z == 0) return {};
        const double t = (height_ - o.z) / d.z;
        if (!(t > tMin && t < ray.tMax)) return {};
        const Vec3d p(o.x + t * d.x, o.y + t * d.y, height_);
        const double r2 = p.x * p.x + p.y * p.y;
        if (r2 > radius_ * radius_ || r2 < innerRadius_ * innerRadius_) return {};
        if (phiOf(p) > phiMax_) return {};
        const double r = std::sqrt(r2), width = radius_ - innerRadius_;
        ShapeHit hit;
        hit.t = float(t);
        hit.p = Vec3(space_.pointToWorld(p));
        hit.ng = ng_;
        hit.uv = uvOf(p);
        hit.dpdu = Vec3(space_.vectorToWorld(Vec3d(-p.y, p.x, 0) * phiMax_));
        // At the centre, any radial direction will do.
        const Vec3d radial = r > 0 ? Vec3d(p.x / r, p.y / r, 0) : Vec3d(1, 0, 0);
        hit.dpdv = Vec3(space_.vectorToWorld(radial * -width));
        return hit;
    }

    float area() const override { return float(area_); }

    ShapeSample sample(const Vec2& u) const override {
        double x, y;
        if (innerRadius_ == 0 && phiMax_ == 2 * kPiD) {
            const Vec2 p = sampleConcentricDisk(u);
            x = radius_ * p.x;
            y = radius_ * p.y;
        } else {
            const double r = std::sqrt(innerRadius_ * innerRadius_ * (1 - u.x) + radius_ * radius_ * u.x);
            x = r * std::cos(u.y * phiMax_);
            y = r * std::sin(u.y * phiMax_);
        }
        const Vec3d p(x, y, height_);
        return {Vec3(space_.pointToWorld(p)), ng_, float(1 / area_), uvOf(p)};
    }

    std::optional<ShapeSpot> spotAt(const Vec2& uv) const override {
        const double width = radius_ - innerRadius_, r = radius_ - double(uv.y) * width, phi = double(uv.x) * phiMax_;
        return ShapeSpot{Vec3(space_.pointToWorld(Vec3d(r * std::cos(phi), r * std::sin(phi), height_))), ng_,
                         float(r * width * phiMax_ * space_.areaScale(kObjectNormal))};
    }

  private:
    // In object space, from 0 to 2 pi.
    static double phiOf(const Vec3d& p) {
        const double phi = std::atan2(p.y, p.x);
        return phi < 0 ? phi + 2 * kPiD : phi;
    }
    Vec2 uvOf(const Vec3d& p) const {
        return Vec2(float(phiOf(p) / phiMax_),
                    float(1 - (std::sqrt(p.x * p.x + p.y * p.y) - innerRadius_) / (radius_ - innerRadius_)));
    }

    QuadricSpace space_;
    double height_, radius_, innerRadius_, phiMax_;
    Vec3 ng_;
    double area_;
};

}  // namespace

ShapePtr makeDisk(const DiskParams& params) { return std::make_shared<Disk>(params); }

}  // namespace drc
