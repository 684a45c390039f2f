// Rough diffuse reflection: Oren and Nayar's V-shaped Lambertian grooves (PBR 3e, section 8.4.1).
#pragma once
#include "scene/lobes/diffuse_part.h"
#include "scene/lobes/lobe_sampling.h"

namespace drc {

class OrenNayar : public DiffuseReflectionLobe<OrenNayar> {
  public:
    // sigmaDegrees: standard deviation of the grooves' slope angle, in degrees. The separable part is the model's
    // constant term A, a Lambertian lobe.
    OrenNayar(const Rgb& reflectance, float sigmaDegrees, DiffusePart part);

    Rgb f(const Vec3& wo, const Vec3& wi) const;
    Rgb albedo(const Vec3& wo) const;  // exact
    bool isSeparable() const { return b_ == 0; }
    Rgb viewFactor(const Vec3&) const { return reflectance_ * a_; }

  private:
    Rgb reflectance_;
    float a_ = 0, b_ = 0;  // the model's A and B; 0 if the term belongs to the other part
};

}  // namespace drc
