// How the radiance of an emitter depends on direction, as a factor. By default it is the same in all directions.
#pragma once
#include <memory>

#include "scene/lights/spot_falloff.h"

namespace drc {

class EmissionProfile {
  public:
    // A spotlight's: the cone is around one axis (unit, world space), whatever the normal of the surface.
    struct Spot {
        Vec3 axis;
        SpotFalloff falloff;
    };

    EmissionProfile() = default;
    explicit EmissionProfile(const Spot& spot) : spot_(std::make_shared<const Spot>(spot)) {}
    // Light that leaves within a cone around the normal, as behind a honeycomb: at an angle t from the normal, the
    // factor is proportional to 1 - tan(t) / tan(degrees / 2), and the emitted power stays the same. degrees: the whole
    // angle of the cone, in (0, 180]; 180: all directions alike. This is the spread of area lights in Blender.
    static EmissionProfile narrowed(float degrees);

    bool isEven() const { return tanHalf_ == kInfinity && !spot_; }
    // ng: normal of the emitter. d: of the light. Both are unit, in world space.
    float share(const Vec3& ng, const Vec3& d) const {
        if (spot_) return spot_->falloff.at(dot(d, spot_->axis));
        if (tanHalf_ == kInfinity) return 1;
        const float tangent = length(cross(ng, d)) / absDot(ng, d);  // accurate for small angles
        return tangent < tanHalf_ ? (tanHalf_ - tangent) * scale_ : 0;
    }
    // The emitted power, as a share of what an even profile gives. For a spot, that of a sphere.
    float power() const { return spot_ ? spot_->falloff.solidAngle() / (4 * kPi) : 1; }
    // Sine of the greatest angle from the normal at which light leaves, in (0, 1].
    float sinReach() const { return sinReach_; }
    const Spot* spot() const { return spot_.get(); }

  private:
    float tanHalf_ = kInfinity, scale_ = 1, sinReach_ = 1;
    std::shared_ptr<const Spot> spot_;
};

}  // namespace drc
