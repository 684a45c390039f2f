// A Lambertian base under a dielectric coat (pbrt-v4's "coateddiffuse" in closed form; see docs/layered-materials.md).
// The reflection off the coat itself is a separate lobe.
#pragma once
#include "scene/lobes/dielectric_coat.h"
#include "scene/lobes/lobe_sampling.h"

namespace drc {

class CoatedDiffuse : public DiffuseReflectionLobe<CoatedDiffuse> {
  public:
    CoatedDiffuse(const Rgb& reflectance, const DielectricCoat& coat);

    Rgb f(const Vec3& wo, const Vec3& wi) const;
    Rgb albedo(const Vec3& wo) const;  // exact
    Rgb viewFactor(const Vec3& wo) const { return albedo(wo); }

  private:
    DielectricCoat coat_;
    Rgb scattered_;  // reflectance of the base for light inside the coat, with all interreflections, divided by eta^2
};

}  // namespace drc
