// Perfect mirror reflection, scaled by a Fresnel term (PBR 3e, section 8.2.2).
#pragma once
#include "scene/lobes/fresnel.h"
#include "scene/lobes/lobe_sampling.h"

namespace drc {

class SpecularReflection : public MirrorLobe<SpecularReflection> {
  public:
    SpecularReflection(const Rgb& reflectance, const Fresnel& fresnel) : reflectance_(reflectance), fresnel_(fresnel) {}

    Rgb albedo(const Vec3& wo) const { return reflectance_ * fresnel_.eval(wo.z); }

  private:
    Rgb reflectance_;
    Fresnel fresnel_;
};

}  // namespace drc
