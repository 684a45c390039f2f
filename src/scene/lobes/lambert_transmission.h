// Ideal diffuse transmission: light from one side leaves the other side uniformly in all directions (PBR 3e,
// section 8.3.1).
#pragma once
#include "math/warp.h"
#include "scene/lobes/lobe.h"
#include "scene/lobes/local_directions.h"

namespace drc {

class LambertTransmission {
  public:
    explicit LambertTransmission(const Rgb& transmittance) : transmittance_(transmittance) {}

    static constexpr LobeFlags flags() { return LobeFlags::Transmission | LobeFlags::Diffuse; }
    static constexpr float alpha() { return kDiffuseAlpha; }
    Rgb f(const Vec3&, const Vec3&) const { return transmittance_ * kInvPi; }
    float pdf(const Vec3& wo, const Vec3& wi) const { return sameHemisphere(wo, wi) ? 0 : absCosTheta(wi) * kInvPi; }
    LobeSample sample(const Vec3& wo, float, const Vec2& u, TransportMode) const {
        LobeSample s;
        s.wi = sampleCosineHemisphere(u);
        if (wo.z > 0) s.wi.z = -s.wi.z;
        s.f = f(wo, s.wi);
        s.pdf = pdf(wo, s.wi);
        s.flags = flags();
        return s;
    }
    Rgb albedo(const Vec3&) const { return transmittance_; }
    Rgb viewFactor(const Vec3&) const { return transmittance_; }

  private:
    Rgb transmittance_;
};

}  // namespace drc
