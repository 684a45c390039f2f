// The directional albedo of microfacet surfaces, and the factor that restores the energy lost by the single-scattering
// model.
//
// Light reflected by a facet may hit another facet; the single-scattering model (PBR 3e, section 8.4) drops this light,
// up to half of it for rough surfaces. Here single scattering is divided by its albedo towards the viewer, so that a
// lossless surface reflects exactly what arrives, and absorbing facets absorb their share at each further bounce
// (Turquin, "Practical multiple scattering compensation for microfacet models", 2019; Kulla and Conty, "Revisiting
// Physically Based Shading at Imageworks", SIGGRAPH 2017 course, for the series of bounces). Blender's Cycles does the
// same. The result is not reciprocal: light paths use the factor of the direction in which their light continues to the
// camera, so that all integrators compute the same picture.
//
// Tables are computed when they are first needed, in some hundredths of a second for a material.
#pragma once
#include "scene/lobes/cosine_curve.h"

namespace drc {

// The factor by which single scattering is scaled to include multiple scattering.
class MultipleScattering {
  public:
    // No multiple scattering: the factor is 1.
    MultipleScattering() = default;
    // For a reflecting surface. meanFresnel: cosine-weighted mean reflectance of a facet.
    static MultipleScattering ofReflection(float alpha, const Rgb& meanFresnel);
    // For a dielectric boundary, which absorbs light only by its colour. eta: index on the side away from the shading
    // normal, relative to the index on the normal's side. transmittance: share of the light that is left after each
    // bounce between facets.
    static MultipleScattering ofBoundary(float alpha, float eta, const Rgb& transmittance);

    // wo: the direction in which light leaves towards the camera, in the shading frame.
    Rgb factor(const Vec3& wo) const;

  private:
    int rows_ = 0;
    // [side][row], with side 0 above the shading frame and 1 below it, and row < rows_: albedo curves of the tables
    // that factor() interpolates, of the two nearest roughnesses or, for boundaries, the 2 x 2 nearest roughnesses and
    // indices. share_: weight of each row.
    const CosineCurve* albedo_[2][4] = {};
    float share_[4] = {};
    Rgb left_[2];  // [side]: unabsorbed share of the light scattered more than once
};

// The directional albedo of a dielectric's reflection from outside, rough or (alpha 0) smooth, with multiple scattering
// as by ofReflection(). atNormal: reflectance at normal incidence, which may be tinted and then differs from that of
// eta.
CosineCurve dielectricAlbedo(float alpha, float eta, float atNormal);
// The cosine-weighted mean reflectance of a smooth dielectric from outside.
Rgb meanDielectricFresnel(float eta, const Rgb& atNormal);

// The single scattering albedo of lossless microfacets (for tests).
float singleScatteringAlbedo(float alpha, float cosTheta);

}  // namespace drc
