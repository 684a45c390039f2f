// Spotlight: a point light that emits into a cone with a soft edge (PBR 3e, section 12.3.1).
#include "scene/light_directed_point.h"

namespace drc {
namespace {

class SpotLight final : public DirectedPointLight {
  public:
    SpotLight(const Transform& lightToWorld, const Rgb& intensity, float coneDegrees, float fadeDegrees, SpotEdge edge)
        : DirectedPointLight(lightToWorld, intensity),
          edge_(edge),
          cosEdge_(std::cos(coneDegrees * kPi / 180)),
          cosFull_(std::cos(std::max(0.f, coneDegrees - fadeDegrees) * kPi / 180)),
          cone_(coneDegrees * kPi / 180) {}

    // The soft edge has a fifth (x^4) or a half (smoothstep) of the power that it would have at full intensity: the
    // integral over x.
    Rgb power(float) const override {
        const float share = edge_ == SpotEdge::Steep ? 0.2f : 0.5f;
        return intensity_ * (2 * kPi * ((1 - cosFull_) + (cosFull_ - cosEdge_) * share));
    }
    LightReach reach() const override {
        LightReach r{bounds(), axis_};
        r.intensity = luminance(intensity_);
        if (!worldToLight_.keepsAngles()) return r;
        const float full = std::acos(cosFull_);
        r.spread = full;
        r.falloff = cone_ - full;
        return r;
    }

  private:
    float leastCosine() const override { return cosEdge_; }
    Rgb share(const Vec3& w) const override { return Rgb(falloff(normalize(w).z)); }
    float falloff(float cosTheta) const {
        if (cosTheta <= cosEdge_) return 0;
        if (cosTheta >= cosFull_) return 1;
        const float x = (cosTheta - cosEdge_) / (cosFull_ - cosEdge_);
        return edge_ == SpotEdge::Steep ? sqr(sqr(x)) : sqr(x) * (3 - 2 * x);
    }

    SpotEdge edge_;
    float cosEdge_, cosFull_;
    float cone_;  // radians from the axis to the edge
};

}  // namespace

LightPtr makeSpotLight(const Transform& lightToWorld, const Rgb& intensity, float coneDegrees, float fadeDegrees,
                       SpotEdge edge) {
    return std::make_shared<SpotLight>(lightToWorld, intensity, coneDegrees, fadeDegrees, edge);
}

}  // namespace drc
