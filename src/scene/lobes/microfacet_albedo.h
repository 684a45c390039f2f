// How much light surfaces of microfacets scatter in all directions together, and what it takes to give back the light
// that they lose in the model of single scattering.
//
// A facet's reflection may hit the next facet; the model of single scattering (PBR 3e, section 8.4) drops that light,
// up to half of it for rough surfaces. Here single scattering is divided by its albedo towards the viewer, so that a
// lossless surface reflects exactly what arrives, and absorbing facets take their share from each further bounce
// (Turquin, "Practical multiple scattering compensation for microfacet models", 2019; Kulla and Conty, "Revisiting
// Physically Based Shading at Imageworks", SIGGRAPH 2017 course, for the series of bounces). This is what Blender's
// Cycles does. It is not reciprocal: light paths use the factor of the direction in which their light goes on to the
// camera, so that all integrators compute the same picture.
//
// Tables are computed when they are first needed, in some hundredths of a second for a material.
#pragma once
#include "scene/lobes/cosine_curve.h"

namespace drc {

// The scale of single scattering that accounts for the rest.
class MultipleScattering {
  public:
    // None: the factor is 1.
    MultipleScattering() = default;
    // A surface that reflects. meanFresnel: the mean reflectance of a facet, weighted by the cosine.
    static MultipleScattering ofReflection(float alpha, const Rgb& meanFresnel);
    // A dielectric boundary, which loses nothing but what its colour absorbs. eta: the index on the side away from the
    // shading normal, relative to that on its side. transmittance: what each bounce between facets leaves of the light.
    static MultipleScattering ofBoundary(float alpha, float eta, const Rgb& transmittance);

    // wo: the direction in which light leaves towards the camera, in the shading frame.
    Rgb factor(const Vec3& wo) const;

  private:
    int rows_ = 0;
    // The tables' curves at the two nearest roughnesses (and indices), above and below the shading frame, and the share
    // of each.
    const CosineCurve* albedo_[2][4] = {};
    float share_[4] = {};
    Rgb left_[2];  // of the light scattered more than once, what the facets do not absorb
};

// The directional albedo of a rough (or, with alpha 0, smooth) dielectric's reflection from outside, with multiple
// scattering as by ofReflection(). atNormal: the possibly tinted reflectance at normal incidence.
CosineCurve dielectricAlbedo(float alpha, float eta, float atNormal);
// The mean reflectance of a smooth dielectric from outside, weighted by the cosine.
Rgb meanDielectricFresnel(float eta, const Rgb& atNormal);

// The single scattering albedo of lossless microfacets (for tests).
float singleScatteringAlbedo(float alpha, float cosTheta);

}  // namespace drc
