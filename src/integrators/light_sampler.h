// Chooses one light for a point, by the irradiance that each could bring there: all of few lights are weighed, among
// many a tree finds the way. Lights at infinity stand beside the tree.
#pragma once
#include <unordered_map>
#include <vector>

#include "math/distribution.h"
#include "scene/light_tree.h"
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
    bool weighsAll() const { return lights_.size() <= kMaxWeighed; }
    static_assert(kMaxWeighed % LightBounds::kCount == 0);
    // The probabilities of all lights, where they are few, and zeros behind them.
    void weigh(const Vec3& p, float (&probabilities)[kMaxWeighed]) const;
    // Among many: the probability that the light is one of those at infinity.
    float distantShare(const Vec3& p) const;

    // First those of finite size, then those at infinity.
    std::vector<const Light*> lights_;
    size_t finite_ = 0;
    std::vector<LightBounds> bounds_;  // of those of finite size, where the lights are few
    std::vector<float> distant_;       // of those at infinity, the irradiance on what faces them
    float uniform_[kMaxWeighed]{};     // what each has of its probability at every point, where the lights are few
    float distantSum_ = 0;
    LightTree tree_;               // over those of finite size, if there are many lights
    Distribution1D byIrradiance_;  // over those at infinity
    std::unordered_map<const Light*, int> index_;
    std::vector<const Light*> infinite_;
};

}  // namespace drc
