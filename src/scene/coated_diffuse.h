// A Lambertian base under a dielectric coat, without what the coat itself reflects: that is a lobe of its own
// (pbrt-v4's "coateddiffuse" in closed form; see docs/layered-materials.md).
#pragma once
#include "scene/dielectric_coat.h"
#include "scene/lobe_sampling.h"

namespace drc {

class CoatedDiffuse : public DiffuseReflectionLobe<CoatedDiffuse> {
  public:
    CoatedDiffuse(const Rgb& reflectance, const DielectricCoat& coat);

    Rgb f(const Vec3& wo, const Vec3& wi) const;
    Rgb albedo(const Vec3& wo) const;  // exact

  private:
    DielectricCoat coat_;
    Rgb scattered_;  // of the light that has entered: reflectance with all reflections inside, over eta^2
};

}  // namespace drc
