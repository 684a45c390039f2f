// A smooth sheet of glass too thin to shift light that passes: a window pane. What is reflected back and forth between
// its two faces is summed (pbrt-v4's "thindielectric"; PBR 4e, section 9.5.1).
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

    // Of both faces together.
    float reflectance(float cosTheta) const;

  private:
    float eta_;
};

}  // namespace drc
