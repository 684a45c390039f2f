// Samples an environment through the windows of a room, where these are known. This is a sampling technique, not a
// mask: directions that miss the windows are still sampled, and the picture converges to the same result.
//
// The unit square of random numbers is divided between the windows that face a point, in proportion to the irradiance
// that each could bring, and the environment as a whole, which keeps a quarter. A direction belongs to the first window
// that it passes through, else to the whole environment; samples of another part that find it are rejected. So every
// direction has exactly one u, as EnvironmentGuide needs.
#pragma once
#include <vector>

#include "scene/lights/light.h"
#include "scene/lights/portal_directions.h"

namespace drc {

class EnvironmentWindows {
  public:
    static constexpr size_t kMost = LightBounds::kCount;

    // environment: without a portal; must outlive this. With no windows, sampling is the environment's own. Windows
    // beyond kMost are ignored.
    explicit EnvironmentWindows(const Light& environment, const std::vector<Portal>& windows = {});

    const Light& environment() const { return environment_; }
    size_t count() const { return windows_.size(); }

    // As Light::sample().
    std::optional<LightSample> sample(const Vec3& p, const Vec2& u) const;
    // The pdf of sample() for a direction, and the u that sample() maps to that direction.
    struct Inverse {
        float pdf = 0;
        Vec2 u{0.f};
    };
    Inverse inverse(const Vec3& from, const Vec3& wi) const;

  private:
    // The interval of u.x in [0, 1) of each window; the rest belongs to the environment as a whole.
    struct Shares {
        float begin[kMost + 1];
        float of(size_t window) const { return begin[window + 1] - begin[window]; }
        float ofAll(size_t count) const { return begin[count]; }
    };
    Shares sharesAt(const Vec3& p) const;
    // Index of the first window with a positive share that the ray from p along wi passes through; count() if there is
    // none.
    size_t passedBy(const Vec3& p, const Vec3& wi, const Shares& shares) const;

    const Light& environment_;
    std::vector<PortalDirections> windows_;
    LightBounds bounds_;
};

}  // namespace drc
