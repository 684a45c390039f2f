// Rough diffuse reflection that loses no light: Fujii's form of Oren and Nayar's model, which is a simple function of
// the cosines, and the light that the grooves scatter more than once (Fujii, "A tiny improvement of Oren-Nayar
// reflectance model", 2012; Portsmouth, Kutz and Hill, "EON: A Practical Energy-Preserving Rough Diffuse BRDF", 2024).
// Blender uses the same model.
#pragma once
#include "scene/lobes/diffuse_part.h"
#include "scene/lobes/lobe_sampling.h"

namespace drc {

class RoughDiffuse : public DiffuseReflectionLobe<RoughDiffuse> {
  public:
    // reflectance: of the grooves' walls, clamped to [0, 1]; with 1 the surface reflects all light. roughness: in [0,
    // 1]; 0 gives Lambert's model, whose DiffusePart::Rest is zero.
    RoughDiffuse(const Rgb& reflectance, float roughness, DiffusePart part);

    Rgb f(const Vec3& wo, const Vec3& wi) const;
    // Exact.
    Rgb albedo(const Vec3& wo) const;
    bool isSeparable() const { return part_ == DiffusePart::Separable; }
    Rgb viewFactor(const Vec3& wo) const { return reflectance_ * separableFactor(absCosTheta(wo)); }

  private:
    // Albedo of white walls for single scattering.
    float albedoOnce(float cosTheta) const;
    // For white walls, the separable part of single scattering is even_ * separableFactor(cos theta_o) *
    // separableFactor(cos theta_i). It is the largest product that stays below the model, from which the grooves
    // subtract even_ * roughness * sin theta_o * sin theta_i at opposite azimuths: with the roughness r and the sines a
    // and b, (1 - r a^2) (1 - r b^2) <= (1 - r a b)^2.
    float separableFactor(float cosTheta) const { return safeSqrt(1 - roughness_ * (1 - cosTheta * cosTheta)); }
    Rgb separableAlbedo(float cosTheta) const;

    DiffusePart part_;
    float roughness_;
    Rgb reflectance_{0.f};
    float even_, grooves_;  // for white walls: f without grooves, and the factor of the grooves' term
    Rgb repeated_{0.f};     // albedo of the light that is scattered more than once
    float perMissing_;      // 1 / (pi times the mean share of this light)
};

}  // namespace drc
