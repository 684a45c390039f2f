// Ideal diffuse reflection (PBR 3e, section 8.3.1). Both sides of the surface reflect.
#pragma once
#include "scene/lobes/lobe_sampling.h"

namespace drc {

class LambertReflection : public DiffuseReflectionLobe<LambertReflection> {
  public:
    explicit LambertReflection(const Rgb& reflectance) : reflectance_(reflectance) {}

    // Not zero for wi below the shading frame's horizon, as in pbrt: the Bsdf decides by the geometric normal.
    Rgb f(const Vec3&, const Vec3&) const { return reflectance_ * kInvPi; }
    Rgb albedo(const Vec3&) const { return reflectance_; }
    Rgb viewFactor(const Vec3&) const { return reflectance_; }

  private:
    Rgb reflectance_;
};

}  // namespace drc
