// A factor by which an emitter's radiance depends on direction. By default it is 1 in all directions.
#pragma once
#include <memory>

#include "scene/lights/spot_falloff.h"

namespace drc {

class EmissionProfile {
  public:
    // The profile of a spotlight: its cone is around a fixed axis (unit, world space) instead of the surface normal.
    struct Spot {
        Vec3 axis;
        SpotFalloff falloff;
    };

    EmissionProfile() = default;
    explicit EmissionProfile(const Spot& spot) : spot_(std::make_shared<const Spot>(spot)) {}
    // Confines light to a cone around the normal, as a honeycomb grid does: at an angle t from the normal, the factor
    // is proportional to 1 - tan(t) / tan(degrees / 2), normalised so that the emitted power stays the same. degrees:
    // full opening angle of the cone, in (0, 180]; 180 gives an even profile. Blender calls this the spread of an area
    // light.
    static EmissionProfile narrowed(float degrees);

    bool isEven() const { return tanHalf_ == kInfinity && !spot_; }
    // The factor for light that leaves in direction d from a point with the normal ng; both are unit, in world space.
    float share(const Vec3& ng, const Vec3& d) const {
        if (spot_) return spot_->falloff.at(dot(d, spot_->axis));
        if (tanHalf_ == kInfinity) return 1;
        const float tangent = length(cross(ng, d)) / absDot(ng, d);  // accurate for small angles
        return tangent < tanHalf_ ? (tanHalf_ - tangent) * scale_ : 0;
    }
    // Ratio of the emitted power to that of an even profile. For a spot, the ratio for an emitter that is a sphere.
    float power() const { return spot_ ? spot_->falloff.solidAngle() / (4 * kPi) : 1; }
    // Sine of the largest angle to the normal at which light leaves, in (0, 1].
    float sinReach() const { return sinReach_; }
    const Spot* spot() const { return spot_.get(); }

  private:
    float tanHalf_ = kInfinity, scale_ = 1, sinReach_ = 1;
    std::shared_ptr<const Spot> spot_;
};

}  // namespace drc
