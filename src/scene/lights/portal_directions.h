// Directions in which a point sees an environment through a portal.
#pragma once
#include <memory>
#include <optional>

#include "scene/lights/light_reach.h"
#include "scene/lights/portal.h"
#include "scene/lights/rectified_environment.h"

namespace drc {

class PortalDirections {
  public:
    // tables: of portals that face the same way.
    PortalDirections(const Portal& portal, std::shared_ptr<const RectifiedEnvironment> tables)
        : portal_(portal), tables_(std::move(tables)) {}

    const Portal& portal() const { return portal_; }
    struct Sample {
        Vec3 wi;
        float pdf = 0;  // per solid angle, positive
    };
    // None from outside, and where nothing but black is seen.
    std::optional<Sample> sample(const Vec3& p, const Vec2& u) const;
    float pdf(const Vec3& p, const Vec3& wi) const { return inverse(p, wi, false).pdf; }
    // The pdf, and the u for which sample() gives this direction.
    struct Inverse {
        float pdf = 0;
        Vec2 u{0.f};
    };
    Inverse inverse(const Vec3& p, const Vec3& wi, bool withU = true) const;
    // As that of an area light in the portal.
    LightReach reach() const;

  private:
    Portal portal_;
    std::shared_ptr<const RectifiedEnvironment> tables_;
};

}  // namespace drc
