// Smooth glass: specular reflection and refraction in a single lobe, which chooses between them in proportion to the
// light that each carries (PBR 3e, sections 8.2 and 14.1.3). It matches only masks with both Reflection and
// Transmission.
#pragma once
#include "scene/lobes/lobe.h"

namespace drc {

class FresnelSpecular : public SpecularLobe {
  public:
    // etaA: index of refraction on the side of the shading normal; etaB: on the opposite side.
    FresnelSpecular(const Rgb& reflectance, const Rgb& transmittance, float etaA, float etaB)
        : reflectance_(reflectance), transmittance_(transmittance), etaA_(etaA), etaB_(etaB) {}

    static constexpr LobeFlags flags() { return LobeFlags::Reflection | LobeFlags::Transmission | LobeFlags::Specular; }
    LobeSample sample(const Vec3& wo, float uLobe, const Vec2& u, TransportMode mode) const;
    Rgb albedo(const Vec3& wo) const;

  private:
    Rgb reflectance_, transmittance_;
    float etaA_, etaB_;
};

}  // namespace drc
