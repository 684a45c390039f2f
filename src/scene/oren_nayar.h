// Rough diffuse reflection: Oren and Nayar's V-shaped Lambertian grooves (PBR 3e, section 8.4.1).
#pragma once
#include "scene/lobe_sampling.h"

namespace drc {

class OrenNayar : public DiffuseReflectionLobe<OrenNayar> {
  public:
    // sigmaDegrees: standard deviation of the grooves' slope angle, in degrees.
    OrenNayar(const Rgb& reflectance, float sigmaDegrees);

    Rgb f(const Vec3& wo, const Vec3& wi) const;
    Rgb albedo(const Vec3&) const { return reflectance_; }

  private:
    Rgb reflectance_;
    float a_, b_;
};

}  // namespace drc
