// Sampling of an environment through the windows of a room, where these are known: a sampling technique, not a mask, so
// that what the windows do not cover is still sampled, and the picture stays what it is.
//
// The unit square of random numbers is divided among the windows that face a point, by the irradiance that each could
// bring, and the environment as a whole, which keeps a quarter. A direction belongs to the first window that it passes;
// the other parts give nothing for it. So every direction has one u, as EnvironmentGuide needs.
#pragma once
#include <vector>

#include "scene/lights/light.h"
#include "scene/lights/portal_directions.h"

namespace drc {

class EnvironmentWindows {
  public:
    static constexpr size_t kMost = LightBounds::kCount;

    // environment: without a portal; must outlive this. With no windows, everything is as the environment has it.
    // Windows beyond kMost are left out.
    explicit EnvironmentWindows(const Light& environment, const std::vector<Portal>& windows = {});

    const Light& environment() const { return environment_; }
    size_t count() const { return windows_.size(); }

    // As Light::sample().
    std::optional<LightSample> sample(const Vec3& p, const Vec2& u) const;
    // The pdf of sample() for a direction, and the u for which it gives it.
    struct Inverse {
        float pdf = 0;
        Vec2 u{0.f};
    };
    Inverse inverse(const Vec3& from, const Vec3& wi) const;

  private:
    // Which part of [0, 1) each window has; the environment as a whole has the rest.
    struct Shares {
        float begin[kMost + 1];
        float of(size_t window) const { return begin[window + 1] - begin[window]; }
        float ofAll(size_t count) const { return begin[count]; }
    };
    Shares sharesAt(const Vec3& p) const;
    // The first window with a share that a ray passes; count() if there is none.
    size_t passedBy(const Vec3& p, const Vec3& wi, const Shares& shares) const;

    const Light& environment_;
    std::vector<PortalDirections> windows_;
    LightBounds bounds_;
};

}  // namespace drc
