// Perfect mirror reflection, scaled by a Fresnel term (PBR 3e, section 8.2.2).
#pragma once
#include "scene/fresnel.h"
#include "scene/lobe.h"
#include "scene/local_directions.h"

namespace drc {

class SpecularReflection {
  public:
    SpecularReflection(const Rgb& reflectance, const Fresnel& fresnel) : reflectance_(reflectance), fresnel_(fresnel) {}

    static constexpr LobeFlags flags() { return LobeFlags::Reflection | LobeFlags::Specular; }
    Rgb f(const Vec3&, const Vec3&) const { return Rgb(0.f); }
    float pdf(const Vec3&, const Vec3&) const { return 0; }
    LobeSample sample(const Vec3& wo, float, const Vec2&, TransportMode) const {
        LobeSample s;
        if (wo.z == 0) return s;
        s.wi = Vec3(-wo.x, -wo.y, wo.z);
        s.f = albedo(wo) * (1 / absCosTheta(s.wi));
        s.pdf = 1;
        s.flags = flags();
        return s;
    }
    Rgb albedo(const Vec3& wo) const { return reflectance_ * fresnel_.eval(wo.z); }

  private:
    Rgb reflectance_;
    Fresnel fresnel_;
};

}  // namespace drc
