#include "transport/light_sampler.h"

#include "math/eight_sums.h"

namespace drc {
namespace {

// Share of the probability that ignores the lights' estimated contributions, so that no light is starved: the estimates
// ignore visibility, and the most promising lights may be occluded.
constexpr float kUniformShare = 0.1f;

}  // namespace

LightSampler::LightSampler(const Scene& scene, bool seesBackdrop) {
    const float sceneRadius = std::max(1e-18f, scene.bounds().radius());
    std::vector<const Light*> distant;
    std::vector<LightReach> reaches;
    for (const LightPtr& light : scene.lights) {
        const float power = luminance(light->power(sceneRadius));
        if (!(power > 0)) continue;
        if (light->isInfinite()) {
            if (light->visibleToCamera() && seesBackdrop) backdrop_.push_back(light.get());
            if (light->illuminates()) infinite_.push_back(light.get());
        }
        if (!light->illuminates()) continue;
        if (light->bounds().empty()) {
            distant.push_back(light.get());
            distant_.push_back(power / sqr(sceneRadius));
            distantSum_ += distant_.back();
        } else {
            lights_.push_back(light.get());
            reaches.push_back(light->reach());
        }
    }
    finite_ = lights_.size();
    lights_.insert(lights_.end(), distant.begin(), distant.end());
    for (size_t i = 0; i < lights_.size(); ++i) index_[lights_[i]] = int(i);
    byIrradiance_ = Distribution1D(distant_);
    if (!weighsAll()) {
        tree_ = LightTree(reaches);
        return;
    }
    bounds_.resize((lights_.size() + LightBounds::kCount - 1) / LightBounds::kCount);
    for (size_t i = 0; i < finite_; ++i)
        bounds_[i / LightBounds::kCount].set(int(i % LightBounds::kCount), LightBound(reaches[i]));
    std::fill_n(uniform_, lights_.size(), kUniformShare / float(lights_.size()));
}

void LightSampler::weigh(const Vec3& p, float (&probabilities)[kMaxWeighed]) const {
    constexpr size_t kBlock = LightBounds::kCount;
    for (size_t b = 0; b < bounds_.size(); ++b) bounds_[b].irradiance(p, probabilities + b * kBlock);
    std::copy(distant_.begin(), distant_.end(), probabilities + finite_);
    float sum = 0;
    for (size_t b = 0; b < bounds_.size(); ++b) sum += EightSums(probabilities + b * kBlock).total();
    const bool known = sum > 0 && std::isfinite(sum);
    // Uniform if no light has a positive estimate.
    const float scale = known ? (1 - kUniformShare) / sum : 0, share = known ? 1 : 1 / kUniformShare;
    for (size_t i = 0; i < bounds_.size() * kBlock; ++i)
        probabilities[i] = share * uniform_[i] + scale * (known ? probabilities[i] : 0.f);
}

float LightSampler::distantShare(const Vec3& p) const {
    if (finite_ == 0) return 1;
    if (distant_.empty()) return 0;
    const float near = tree_.empty() ? 0 : tree_.bound().irradiance(p);
    return lerp(kUniformShare, distantSum_ / (distantSum_ + near), 0.5f);
}

LightSampler::Choice LightSampler::sample(const Vec3& p, float u) const {
    if (lights_.empty()) return {};
    if (lights_.size() == 1) return {lights_[0], 1};
    if (weighsAll()) {
        alignas(32) float probabilities[kMaxWeighed];
        weigh(p, probabilities);
        float before = 0;
        for (size_t b = 0; b < bounds_.size(); ++b) {
            const EightSums sums(probabilities + b * EightSums::kCount, before);
            const size_t i = b * EightSums::kCount + size_t(sums.find(u));
            if (i < (b + 1) * EightSums::kCount) return {lights_[i], probabilities[i]};
            before = sums.total();
        }
        return {lights_.back(), probabilities[lights_.size() - 1]};  // reached only by rounding
    }
    const float distant = distantShare(p);
    if (u < distant) {
        const DiscreteSample s = byIrradiance_.sampleDiscrete(std::min(u / distant, kOneMinusEpsilon));
        return {lights_[finite_ + size_t(s.index)], distant * s.probability};
    }
    const LightTree::Choice s = tree_.sample(p, std::min((u - distant) / (1 - distant), kOneMinusEpsilon));
    if (s.index < 0) return {};
    return {lights_[size_t(s.index)], (1 - distant) * s.probability};
}

float LightSampler::probability(const Vec3& p, const Light* light) const {
    const auto it = index_.find(light);
    if (it == index_.end()) return 0;
    if (lights_.size() == 1) return 1;
    const auto index = size_t(it->second);
    if (weighsAll()) {
        alignas(32) float probabilities[kMaxWeighed];
        weigh(p, probabilities);
        return probabilities[index];
    }
    const float distant = distantShare(p);
    if (index >= finite_) return distant * byIrradiance_.probability(int(index - finite_));
    return (1 - distant) * tree_.probability(p, int(index));
}

}  // namespace drc
