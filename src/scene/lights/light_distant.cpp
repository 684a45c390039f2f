// Distant light: parallel rays from a point at infinity (PBR 3e, section 12.4).
#include "scene/lights/light.h"

namespace drc {
namespace {

class DistantLight final : public Light {
  public:
    DistantLight(const Vec3& direction, const Rgb& radiance) : direction_(normalize(direction)), radiance_(radiance) {}

    std::optional<LightSample> sample(const Vec3&, const Vec2&) const override {
        return LightSample{direction_, radiance_, 1, kInfinity, true};
    }
    std::optional<EmittedRay> emit(const Vec2&, const Vec2& uLeaving, const SceneSphere& scene) const override {
        const Vec3 d = -direction_;
        return EmittedRay{
            .p = scene.inFront(d, uLeaving), .d = d, .radiance = radiance_, .density = {1, scene.perFacingArea()}};
    }
    EmissionDensity emissionDensity(const EmitterHit&, const Vec3&, const SceneSphere& scene) const override {
        return {1, scene.perFacingArea()};
    }
    // The flux through the disk that the scene's bounding sphere presents to the light.
    Rgb power(float sceneRadius) const override { return radiance_ * (kPi * sqr(sceneRadius)); }
    bool isDelta() const override { return true; }
    bool isAtInfinity() const override { return true; }

  private:
    Vec3 direction_;  // towards the light
    Rgb radiance_;    // irradiance on a surface that faces the light, W / m^2
};

}  // namespace

LightPtr makeDistantLight(const Vec3& direction, const Rgb& radiance) {
    return std::make_shared<DistantLight>(direction, radiance);
}

}  // namespace drc
