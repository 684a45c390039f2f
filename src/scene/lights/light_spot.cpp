// Spotlight: a point light that emits into a cone with a soft edge (PBR 3e, section 12.3.1).
#include "scene/lights/light_directed_point.h"

namespace drc {
namespace {

class SpotLight final : public DirectedPointLight {
  public:
    SpotLight(const Transform& lightToWorld, const Rgb& intensity, const SpotFalloff& falloff)
        : DirectedPointLight(lightToWorld, intensity), falloff_(falloff) {}

    Rgb power(float) const override { return intensity_ * falloff_.solidAngle(); }
    LightReach reach() const override {
        LightReach r{bounds(), axis_};
        r.intensity = luminance(intensity_);
        if (worldToLight_.keepsAngles()) r.narrowTo(falloff_);
        return r;
    }

  private:
    float leastCosine() const override { return falloff_.cosEdge; }
    Rgb share(const Vec3& w) const override { return Rgb(falloff_.at(normalize(w).z)); }

    SpotFalloff falloff_;
};

}  // namespace

LightPtr makeSpotLight(const Transform& lightToWorld, const Rgb& intensity, const SpotFalloff& falloff) {
    return std::make_shared<SpotLight>(lightToWorld, intensity, falloff);
}

}  // namespace drc
