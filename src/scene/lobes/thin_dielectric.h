// A smooth glass sheet too thin to displace transmitted light, such as a window pane. All interreflections between its
// two faces are summed (pbrt-v4's "thindielectric"; PBR 4e, section 9.5.1).
#pragma once
#include "scene/lobes/lobe.h"

namespace drc {

class ThinDielectric : public SpecularLobe {
  public:
    // transmittance: multiplies the light that the faces let pass.
    explicit ThinDielectric(float eta, const Rgb& transmittance = Rgb(1.f))
        : eta_(eta), transmittance_(transmittance) {}

    static constexpr LobeFlags flags() { return LobeFlags::Reflection | LobeFlags::Transmission | LobeFlags::Specular; }
    LobeSample sample(const Vec3& wo, float uLobe, const Vec2& u, TransportMode mode) const;
    Rgb albedo(const Vec3& wo) const {
        const float r = reflectance(wo.z);
        return Rgb(r) + transmittance_ * (1 - r);
    }

    // Reflectance of both faces together, with all interreflections.
    float reflectance(float cosTheta) const;

  private:
    float eta_;
    Rgb transmittance_;
};

}  // namespace drc
