// The diffuse part of Burley's models ("Physically Based Shading at Disney", SIGGRAPH 2012 course, section 5.3, and
// "Extending the Disney BRDF to a BSDF with Integrated Subsurface Scattering", SIGGRAPH 2015 course, sections 4 and 5):
// a diffuse base that darkens towards grazing angles, the flatter look of shallow subsurface scattering,
// retro-reflection of rough surfaces, and the sheen of cloth. One class covers all four terms, because all are broad
// and cosine-sampled. Materials add the base as a separate lobe, because only the base is separable
// (Bsdf::separableLobes).
//
// Burley fitted the terms to measurements without regard to energy conservation: near the horizon, a white base of full
// roughness reflects more light than it receives.
#pragma once
#include "scene/lobes/lobe_sampling.h"

namespace drc {

struct DisneyDiffuseColors {
    Rgb base{0.f};
    Rgb flat{0.f};   // colour of the approximate subsurface scattering
    Rgb retro{0.f};  // colour of the retro-reflection
    Rgb sheen{0.f};
    bool areBlack() const { return isBlack(base) && isBlack(flat) && isBlack(retro) && isBlack(sheen); }
};

class DisneyDiffuse : public DiffuseReflectionLobe<DisneyDiffuse> {
  public:
    DisneyDiffuse(const DisneyDiffuseColors& colors, float roughness) : colors_(colors), roughness_(roughness) {}

    Rgb f(const Vec3& wo, const Vec3& wi) const;
    Rgb albedo(const Vec3& wo) const;
    // Only the base term is a product of a function of wo and one of wi.
    bool isSeparable() const { return isBlack(colors_.flat) && isBlack(colors_.retro) && isBlack(colors_.sheen); }
    Rgb viewFactor(const Vec3& wo) const;

  private:
    // cos2D: squared cosine between wi and the half vector. schlickO and schlickI: schlickWeight() of both directions.
    float flatness(float schlickO, float schlickI, float cos2D, float inverseCosines) const;
    float retroReflection(float schlickO, float schlickI, float cos2D) const;

    DisneyDiffuseColors colors_;
    float roughness_;
};

}  // namespace drc
