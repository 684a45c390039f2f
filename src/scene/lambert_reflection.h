// Ideal diffuse reflection (PBR 3e, section 8.3.1). Both sides of the surface reflect.
#pragma once
#include "scene/lobe_sampling.h"

namespace drc {

class LambertReflection {
  public:
    explicit LambertReflection(const Rgb& reflectance) : reflectance_(reflectance) {}

    static constexpr LobeFlags flags() { return LobeFlags::Reflection | LobeFlags::Diffuse; }
    // Like pbrt's, not cut off where wi is below the shading frame: the Bsdf cuts by the geometric normal.
    Rgb f(const Vec3&, const Vec3&) const { return reflectance_ * kInvPi; }
    float pdf(const Vec3& wo, const Vec3& wi) const { return cosinePdf(wo, wi); }
    LobeSample sample(const Vec3& wo, float, const Vec2& u, TransportMode) const {
        return sampleByCosine(*this, wo, u);
    }
    Rgb albedo(const Vec3&) const { return reflectance_; }

  private:
    Rgb reflectance_;
};

}  // namespace drc
