// A smooth glass sheet too thin to displace transmitted light, such as a window pane. All interreflections between its
// two faces are summed (pbrt-v4's "thindielectric"; PBR 4e, section 9.5.1).
#pragma once
#include "scene/lobe.h"

namespace drc {

class ThinDielectric : public SpecularLobe {
  public:
    explicit ThinDielectric(float eta) : eta_(eta) {}

    static constexpr LobeFlags flags() { return LobeFlags::Reflection | LobeFlags::Transmission | LobeFlags::Specular; }
    LobeSample sample(const Vec3& wo, float uLobe, const Vec2& u, TransportMode mode) const;
    // Nothing is absorbed.
    Rgb albedo(const Vec3&) const { return Rgb(1.f); }

    // Reflectance of both faces together.
    float reflectance(float cosTheta) const;

  private:
    float eta_;
};

}  // namespace drc
