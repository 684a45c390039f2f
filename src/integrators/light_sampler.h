// Chooses one light for a point: by the irradiance that each could bring there where lights are few, by power where
// they are many.
#pragma once
#include <unordered_map>
#include <vector>

#include "math/distribution.h"
#include "scene/scene.h"

namespace drc {

class LightSampler {
  public:
    explicit LightSampler(const Scene& scene);

    struct Choice {
        const Light* light = nullptr;  // null: there is no light
        float probability = 0;
    };
    // u in [0, 1).
    Choice sample(const Vec3& p, float u) const;
    // Probability with which sample(p) chooses this light; 0 if it is none of the scene's.
    float probability(const Vec3& p, const Light* light) const;
    const std::vector<const Light*>& infiniteLights() const { return infinite_; }

  private:
    // At most this many lights are weighed at every point.
    static constexpr size_t kMaxWeighed = 32;
    float importance(size_t i, const Vec3& p) const;

    std::vector<const Light*> lights_;
    std::vector<const Light*> infinite_;
    std::vector<float> power_;  // luminance of each light's power
    std::vector<Vec3> center_;
    std::vector<float> radius_;  // negative: at infinity
    std::unordered_map<const Light*, int> index_;
    Distribution1D byPower_;
    float sceneRadius_ = 0;
};

}  // namespace drc
