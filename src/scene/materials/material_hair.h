// Hair and fur (pbrt's "hair"; Chiang et al., "A Practical and Controllable Hair and Fur Model for Production Path
// Tracing", 2016). The texture coordinate v gives the offset across the fibre at which light enters; on curves it runs
// from one edge to the other.
#pragma once
#include "scene/materials/material.h"

namespace drc {

// Absorption coefficient sigma_a for the given concentrations of the two pigments, per fibre radius (d'Eon et al., "An
// Energy-Conserving Hair Reflectance Model", 2011).
Rgb hairAbsorptionOfPigments(float eumelanin, float pheomelanin);
// Absorption coefficient for which dense hair, with its multiple scattering, has about this colour (Chiang et al.,
// equation 9). betaN: azimuthal roughness.
Rgb hairAbsorptionOfColor(const Rgb& color, float betaN);

// The comments give the defaults for null textures, which are those of pbrt. Absorption follows from the first of
// sigmaA, color and the pigments that is not null. If all are null, it follows from a eumelanin concentration of 1.3,
// which is brown.
struct HairParams {
    RgbTexturePtr sigmaA;         // per fibre radius
    RgbTexturePtr color;          // colour of dense hair
    FloatTexturePtr eumelanin;    // concentration; brown and black
    FloatTexturePtr pheomelanin;  // concentration; red
    FloatTexturePtr eta;          // 1.55
    FloatTexturePtr betaM;        // 0.3; longitudinal roughness, in [0, 1]
    FloatTexturePtr betaN;        // 0.3; azimuthal roughness, in [0, 1]
    FloatTexturePtr alpha;        // 2; angle of the scales, degrees
    Relief relief;                // none
};
MaterialPtr makeHair(HairParams params);

}  // namespace drc
