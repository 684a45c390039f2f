// Samples the directions in which a point sees an environment through a portal.
#pragma once
#include <memory>
#include <optional>

#include "scene/lights/light_reach.h"
#include "scene/lights/portal.h"
#include "scene/lights/rectified_environment.h"

namespace drc {

class PortalDirections {
  public:
    // tables: made for this portal or for another one with the same frame (Portal::frame()).
    PortalDirections(const Portal& portal, std::shared_ptr<const RectifiedEnvironment> tables)
        : portal_(portal), tables_(std::move(tables)) {}

    const Portal& portal() const { return portal_; }
    struct Sample {
        Vec3 wi;
        float pdf = 0;  // per solid angle, positive
    };
    // Empty if p is outside the portal, or sees only black through it.
    std::optional<Sample> sample(const Vec3& p, const Vec2& u) const;
    float pdf(const Vec3& p, const Vec3& wi) const { return inverse(p, wi, false).pdf; }
    // The pdf of sample() for a direction, and the u for which sample() returns that direction.
    struct Inverse {
        float pdf = 0;
        Vec2 u{0.f};
    };
    Inverse inverse(const Vec3& p, const Vec3& wi, bool withU = true) const;
    // The reach of an area light that fills the portal and has the same flux.
    LightReach reach() const;

  private:
    Portal portal_;
    std::shared_ptr<const RectifiedEnvironment> tables_;
};

}  // namespace drc
