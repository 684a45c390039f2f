// What is diffuse in Burley's models ("Physically Based Shading at Disney", SIGGRAPH 2012 course, section 5.3, and
// "Extending the Disney BRDF to a BSDF with Integrated Subsurface Scattering", SIGGRAPH 2015 course, sections 4 and 5):
// a base that darkens towards grazing angles, the flatter look of shallow subsurface scattering, retro-reflection of
// rough surfaces, and the sheen of cloth. One lobe, because all four are broad and sampled alike.
//
// The parts are as Burley fitted them to measurements, not as energy would have it: near the horizon a white base of
// full roughness gives back more than it receives.
#pragma once
#include "scene/lobe_sampling.h"

namespace drc {

struct DisneyDiffuseColors {
    Rgb base{0.f};
    Rgb flat{0.f};   // of the approximation to subsurface scattering
    Rgb retro{0.f};  // of retro-reflection
    Rgb sheen{0.f};
};

class DisneyDiffuse : public DiffuseReflectionLobe<DisneyDiffuse> {
  public:
    DisneyDiffuse(const DisneyDiffuseColors& colors, float roughness) : colors_(colors), roughness_(roughness) {}

    Rgb f(const Vec3& wo, const Vec3& wi) const;
    Rgb albedo(const Vec3& wo) const;

  private:
    // cos2D: squared cosine between wi and the half vector. schlickO, schlickI: schlickWeight of each direction.
    float flatness(float schlickO, float schlickI, float cos2D, float inverseCosines) const;
    float retroReflection(float schlickO, float schlickI, float cos2D) const;

    DisneyDiffuseColors colors_;
    float roughness_;
};

}  // namespace drc
