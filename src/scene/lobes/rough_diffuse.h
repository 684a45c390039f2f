// Rough diffuse reflection that loses no light: Fujii's form of Oren and Nayar's model, which is a simple function of
// the cosines, and the light that the grooves scatter more than once (Fujii, "A tiny improvement of Oren-Nayar
// reflectance model", 2012; Portsmouth, Kutz and Hill, "EON: A Practical Energy-Preserving Rough Diffuse BRDF", 2024).
// It is the rough diffuse of Blender.
#pragma once
#include "scene/lobes/diffuse_part.h"
#include "scene/lobes/lobe_sampling.h"

namespace drc {

class RoughDiffuse : public DiffuseReflectionLobe<RoughDiffuse> {
  public:
    // reflectance: of the grooves' own walls, clamped to [0, 1]; a white surface reflects all light. roughness: in [0,
    // 1]; 0 is Lambert's, of which nothing is left for the rest.
    RoughDiffuse(const Rgb& reflectance, float roughness, DiffusePart part);

    Rgb f(const Vec3& wo, const Vec3& wi) const;
    // Exact.
    Rgb albedo(const Vec3& wo) const;
    bool isSeparable() const { return part_ == DiffusePart::Separable; }
    Rgb viewFactor(const Vec3& wo) const { return reflectance_ * separableFactor(absCosTheta(wo)); }

  private:
    // Albedo of white walls for light that is scattered once.
    float albedoOnce(float cosTheta) const;
    // The separable part of what white walls scatter once is `even_` times this factor for wo, times that for wi. It is
    // the largest product below the model, whose grooves take away roughness sin theta_o sin theta_i where the azimuths
    // are opposite. With the roughness r and the sines a and b: (1 - r a^2) (1 - r b^2) <= (1 - r a b)^2.
    float separableFactor(float cosTheta) const { return safeSqrt(1 - roughness_ * (1 - cosTheta * cosTheta)); }
    Rgb separableAlbedo(float cosTheta) const;

    DiffusePart part_;
    float roughness_;
    Rgb reflectance_{0.f};
    float even_, grooves_;  // of white walls: the value without grooves, and the factor of what they add
    Rgb repeated_{0.f};     // the albedo of light that is scattered more than once
    float perMissing_;      // 1 / (pi times the mean share of it)
};

}  // namespace drc
