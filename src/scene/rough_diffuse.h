// Rough diffuse reflection that loses no light: Fujii's form of Oren and Nayar's model, which is a simple function of
// the cosines, and the light that the grooves scatter more than once (Fujii, "A tiny improvement of Oren-Nayar
// reflectance model", 2012; Portsmouth, Kutz and Hill, "EON: A Practical Energy-Preserving Rough Diffuse BRDF", 2024).
// It is the rough diffuse of Blender.
#pragma once
#include "scene/lobe_sampling.h"

namespace drc {

class RoughDiffuse : public DiffuseReflectionLobe<RoughDiffuse> {
  public:
    // reflectance: of the grooves' own walls, clamped to [0, 1]; a white surface reflects all light. roughness: in [0,
    // 1]; 0 is Lambert's.
    RoughDiffuse(const Rgb& reflectance, float roughness);

    Rgb f(const Vec3& wo, const Vec3& wi) const;
    // Exact.
    Rgb albedo(const Vec3& wo) const;

  private:
    // Of white walls, what is scattered once.
    float albedoOnce(float cosTheta) const;

    Rgb reflectance_{0.f};
    float even_, grooves_;  // of white walls: the value without grooves, and the factor of what they add
    Rgb repeated_{0.f};     // the albedo of light that is scattered more than once
    float perMissing_;      // 1 / (pi times the mean share of it)
};

}  // namespace drc
