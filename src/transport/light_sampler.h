// Chooses one light for a surface point in proportion to an estimate of the irradiance that each could contribute
// there. A few lights are all estimated; for many, a light tree is traversed. Lights at infinity are kept outside the
// tree.
#pragma once
#include <unordered_map>
#include <vector>

#include "math/distribution.h"
#include "scene/lights/light_tree.h"
#include "scene/scene.h"

namespace drc {

class LightSampler {
  public:
    // The scene must outlive the sampler. seesBackdrop: whether the camera sees lights at infinity, as on every film
    // that is not transparent.
    LightSampler(const Scene& scene, bool seesBackdrop);
    // Uses the film of the scene's own file.
    explicit LightSampler(const Scene& scene) : LightSampler(scene, !scene.sensor.settings.transparentFilm) {}

    struct Choice {
        const Light* light = nullptr;  // null if there are no lights
        float probability = 0;
    };
    // u in [0, 1).
    Choice sample(const Vec3& p, float u) const;
    // Probability with which sample(p) chooses this light; 0 if the light does not belong to the scene.
    float probability(const Vec3& p, const Light* light) const;
    // Lights at infinity that illuminate surfaces.
    const std::vector<const Light*>& infiniteLights() const { return infinite_; }
    // Lights at infinity that the camera sees.
    const std::vector<const Light*>& backdrop() const { return backdrop_; }

  private:
    // Up to this number of lights, the irradiance of every light is estimated at every point.
    static constexpr size_t kMaxWeighed = 32;
    bool weighsAll() const { return lights_.size() <= kMaxWeighed; }
    static_assert(kMaxWeighed % LightBounds::kCount == 0);
    // The probabilities of all lights, followed by zeros. Only for at most kMaxWeighed lights.
    void weigh(const Vec3& p, float (&probabilities)[kMaxWeighed]) const;
    // Probability of choosing a light at infinity, if there are many lights.
    float distantShare(const Vec3& p) const;

    // Lights of finite size, followed by lights at infinity.
    std::vector<const Light*> lights_;
    size_t finite_ = 0;
    std::vector<LightBounds> bounds_;  // of the finite lights, if there are few lights
    std::vector<float> distant_;       // irradiance of each light at infinity on a surface that faces it
    float uniform_[kMaxWeighed]{};     // the position-independent part of each probability, if there are few lights
    float distantSum_ = 0;
    LightTree tree_;               // over the finite lights, if there are many lights
    Distribution1D byIrradiance_;  // over the lights at infinity
    std::unordered_map<const Light*, int> index_;
    std::vector<const Light*> infinite_, backdrop_;
};

}  // namespace drc
