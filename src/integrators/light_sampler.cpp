#include "integrators/light_sampler.h"

namespace drc {
namespace {

// Share of the choice that ignores distance, so that no light that matters is starved.
constexpr float kUniformShare = 0.1f;

}  // namespace

LightSampler::LightSampler(const Scene& scene) : sceneRadius_(std::max(1e-6f, scene.bounds().radius())) {
    for (const LightPtr& light : scene.lights) {
        const float power = luminance(light->power(sceneRadius_));
        if (!(power > 0)) continue;
        index_[light.get()] = int(lights_.size());
        lights_.push_back(light.get());
        power_.push_back(power);
        const Bounds b = light->bounds();
        center_.push_back(b.empty() ? Vec3(0, 0, 0) : b.center());
        radius_.push_back(b.empty() ? -1.f : b.radius());
        if (light->isInfinite()) infinite_.push_back(light.get());
    }
    if (!lights_.empty()) byPower_ = Distribution1D(power_);
}

float LightSampler::importance(size_t i, const Vec3& p) const {
    // Power over the area that it spreads on: a sphere about a near light, the scene's disk for one at infinity.
    if (radius_[i] < 0) return power_[i] / sqr(sceneRadius_);
    return power_[i] / (4 * std::max(lengthSquared(p - center_[i]), sqr(radius_[i])));
}

LightSampler::Choice LightSampler::sample(const Vec3& p, float u) const {
    if (lights_.empty()) return {};
    if (lights_.size() == 1) return {lights_[0], 1};
    if (lights_.size() > kMaxWeighed) {
        const DiscreteSample s = byPower_.sampleDiscrete(u);
        return {lights_[size_t(s.index)], s.probability};
    }
    float weights[kMaxWeighed];
    float sum = 0;
    for (size_t i = 0; i < lights_.size(); ++i) sum += weights[i] = importance(i, p);
    const float uniform = kUniformShare / float(lights_.size());
    float cdf = 0;
    size_t i = 0;
    float probability = 0;
    for (;; ++i) {
        probability = uniform + (1 - kUniformShare) * weights[i] / sum;
        cdf += probability;
        if (u < cdf || i + 1 == lights_.size()) break;
    }
    return {lights_[i], probability};
}

float LightSampler::probability(const Vec3& p, const Light* light) const {
    const auto it = index_.find(light);
    if (it == index_.end()) return 0;
    if (lights_.size() == 1) return 1;
    const auto index = size_t(it->second);
    if (lights_.size() > kMaxWeighed) return byPower_.probability(int(index));
    float sum = 0;
    for (size_t i = 0; i < lights_.size(); ++i) sum += importance(i, p);
    return kUniformShare / float(lights_.size()) + (1 - kUniformShare) * importance(index, p) / sum;
}

}  // namespace drc
