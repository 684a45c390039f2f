// Perfect refraction between dielectrics (PBR 3e, section 8.2.3).
#pragma once
#include "scene/lobes/lobe.h"

namespace drc {

class SpecularTransmission : public SpecularLobe {
  public:
    // etaA: index of refraction on the side of the shading normal; etaB: on the other.
    SpecularTransmission(const Rgb& transmittance, float etaA, float etaB)
        : transmittance_(transmittance), etaA_(etaA), etaB_(etaB) {}

    static constexpr LobeFlags flags() { return LobeFlags::Transmission | LobeFlags::Specular; }
    LobeSample sample(const Vec3& wo, float uLobe, const Vec2& u, TransportMode mode) const;
    Rgb albedo(const Vec3& wo) const;

  private:
    Rgb transmittance_;
    float etaA_, etaB_;
};

}  // namespace drc
