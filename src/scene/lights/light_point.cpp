// Point light (PBR 3e, section 12.3).
#include "scene/lights/light.h"

namespace drc {
namespace {

class PointLight final : public Light {
  public:
    PointLight(const Vec3& position, const Rgb& intensity) : position_(position), intensity_(intensity) {}

    std::optional<LightSample> sample(const Vec3& p, const Vec2&) const override {
        const Vec3 d = position_ - p;
        const float distance2 = lengthSquared(d);
        if (!(distance2 > 0)) return {};
        const float distance = std::sqrt(distance2);
        return LightSample{d / distance, intensity_ / distance2, 1, distance, true};
    }
    std::optional<EmittedRay> emit(const Vec2&, const Vec2& uLeaving, const SceneSphere&) const override {
        return EmittedRay{.p = position_,
                          .d = sampleUniformSphere(uLeaving),
                          .radiance = intensity_,
                          .density = {1, uniformSpherePdf()}};
    }
    EmissionDensity emissionDensity(const EmitterHit&, const Vec3&, const SceneSphere&) const override {
        return {1, uniformSpherePdf()};
    }
    Rgb power(float) const override { return intensity_ * (4 * kPi); }
    bool isDelta() const override { return true; }
    Bounds bounds() const override { return {position_, position_}; }

  private:
    Vec3 position_;
    Rgb intensity_;  // W / sr
};

}  // namespace

LightPtr makePointLight(const Vec3& position, const Rgb& intensity) {
    return std::make_shared<PointLight>(position, intensity);
}

}  // namespace drc
