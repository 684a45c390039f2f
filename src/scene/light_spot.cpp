// Spotlight: a point light within a cone, whose edge fades (PBR 3e, section 12.3.1).
#include "scene/light.h"
#include "scene/turn.h"

namespace drc {
namespace {

class SpotLight final : public Light {
  public:
    SpotLight(const Transform& lightToWorld, const Rgb& intensity, float coneDegrees, float fadeDegrees, SpotEdge edge)
        : edge_(edge),
          position_(lightToWorld.point(Vec3(0, 0, 0))),
          worldToLight_(lightToWorld.inverse()),
          intensity_(intensity),
          cosEdge_(std::cos(coneDegrees * kPi / 180)),
          cosFull_(std::cos(std::max(0.f, coneDegrees - fadeDegrees) * kPi / 180)),
          cone_(coneDegrees * kPi / 180),
          axis_(normalize(lightToWorld.vector(Vec3(0, 0, 1)))),
          keepsAngles_(worldToLight_.keepsAngles()) {}

    std::optional<LightSample> sample(const Vec3& p, const Vec2&) const override {
        const Vec3 d = position_ - p;
        const float distance2 = lengthSquared(d);
        if (!(distance2 > 0)) return {};
        const float share = falloff(normalize(worldToLight_(-d)).z);
        if (!(share > 0)) return {};
        const float distance = std::sqrt(distance2);
        return LightSample{d / distance, intensity_ * (share / distance2), 1, distance, true};
    }
    // The fading edge holds a fifth, or a half, of what it would hold unfaded: the integral over x.
    Rgb power(float) const override {
        const float share = edge_ == SpotEdge::Steep ? 0.2f : 0.5f;
        return intensity_ * (2 * kPi * ((1 - cosFull_) + (cosFull_ - cosEdge_) * share));
    }
    bool isDelta() const override { return true; }
    Bounds bounds() const override { return {position_, position_}; }
    LightReach reach() const override {
        LightReach r{bounds(), axis_};
        r.intensity = luminance(intensity_);
        if (!keepsAngles_) return r;
        const float full = std::acos(cosFull_);
        r.spread = full;
        r.falloff = cone_ - full;
        return r;
    }

  private:
    float falloff(float cosTheta) const {
        if (cosTheta <= cosEdge_) return 0;
        if (cosTheta >= cosFull_) return 1;
        const float x = (cosTheta - cosEdge_) / (cosFull_ - cosEdge_);
        return edge_ == SpotEdge::Steep ? sqr(sqr(x)) : sqr(x) * (3 - 2 * x);
    }

    SpotEdge edge_;
    Vec3 position_;
    Turn worldToLight_;  // the light shines along its own +z
    Rgb intensity_;      // W / sr, on the axis
    float cosEdge_, cosFull_;
    float cone_;  // radians from the axis to the edge
    Vec3 axis_;   // world space
    bool keepsAngles_;
};

}  // namespace

LightPtr makeSpotLight(const Transform& lightToWorld, const Rgb& intensity, float coneDegrees, float fadeDegrees,
                       SpotEdge edge) {
    return std::make_shared<SpotLight>(lightToWorld, intensity, coneDegrees, fadeDegrees, edge);
}

}  // namespace drc
