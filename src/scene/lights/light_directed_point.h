// Base class of point lights whose intensity depends on direction: spot, goniometric and projection lights (PBR 3e,
// sections 12.3.1 to 12.3.3).
#pragma once
#include "scene/lights/light.h"
#include "scene/lights/turn.h"

namespace drc {

class DirectedPointLight : public Light {
  public:
    std::optional<LightSample> sample(const Vec3& p, const Vec2&) const final {
        const Vec3 d = position_ - p;
        const float distance2 = lengthSquared(d);
        if (!(distance2 > 0)) return {};
        const Rgb intensity = intensity_ * share(worldToLight_(-d));
        if (isBlack(intensity)) return {};
        const float distance = std::sqrt(distance2);
        return LightSample{d / distance, intensity / distance2, 1, distance, true};
    }
    std::optional<EmittedRay> emit(const Vec2&, const Vec2& uLeaving, const SceneSphere&) const final {
        const float edge = coneCosine();
        const Vec3 d = Frame::fromNormal(axis_).toWorld(edge > -1 ? sampleUniformCone(uLeaving, edge)
                                                                  : sampleUniformSphere(uLeaving));
        const Rgb intensity = intensity_ * share(worldToLight_(d));
        if (isBlack(intensity)) return {};
        return EmittedRay{.p = position_, .d = d, .radiance = intensity, .density = {1, coneDensity(edge)}};
    }
    EmissionDensity emissionDensity(const EmitterHit&, const Vec3& d, const SceneSphere&) const final {
        const float edge = coneCosine();
        return {1, dot(d, axis_) >= edge ? coneDensity(edge) : 0};
    }
    bool isDelta() const final { return true; }
    Bounds bounds() const final { return {position_, position_}; }

  protected:
    DirectedPointLight(const Transform& lightToWorld, const Rgb& intensity)
        : position_(lightToWorld.point(Vec3(0, 0, 0))),
          worldToLight_(lightToWorld.inverse()),
          intensity_(intensity),
          axis_(normalize(lightToWorld.vector(Vec3(0, 0, 1)))) {}

    // Cosine of the half-angle of the cone around +z that contains all of the light, in light space.
    virtual float leastCosine() const { return -1; }
    // Factor of intensity_ in direction w, which is in light space and of any length.
    virtual Rgb share(const Vec3& w) const = 0;

    Vec3 position_;
    Turn worldToLight_;
    Rgb intensity_;  // W / sr
    Vec3 axis_;      // the light's +z in world space

  private:
    // Cosine of the cone's half-angle in world space; -1 for all directions.
    float coneCosine() const { return worldToLight_.keepsAngles() ? leastCosine() : -1; }
    static float coneDensity(float edge) { return edge > -1 ? uniformConePdf(edge) : uniformSpherePdf(); }
};

}  // namespace drc
