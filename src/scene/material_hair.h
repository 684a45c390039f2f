// Hair and fur (pbrt's "hair"; Chiang et al., "A Practical and Controllable Hair and Fur Model for Production Path
// Tracing", 2016). The point across the fibre that light meets is its v coordinate: on curves it runs from one edge to
// the other.
#pragma once
#include "scene/material.h"

namespace drc {

// What is absorbed by two kinds of pigment, in these concentrations: sigma_a, per radius of the fibre (d'Eon et al.,
// "An Energy-Conserving Hair Reflectance Model", 2011).
Rgb hairAbsorptionOfPigments(float eumelanin, float pheomelanin);
// The absorption that gives thick hair, in which light is scattered many times, about this colour (Chiang et al.,
// equation 9). betaN: roughness around the fibre.
Rgb hairAbsorptionOfColor(const Rgb& color, float betaN);

// Null textures take the values given here, which are pbrt's. What is absorbed follows from the first of sigmaA, color
// and the pigments that is given; without any it is that of brown hair, a concentration of 1.3 of eumelanin.
struct HairParams {
    RgbTexturePtr sigmaA;         // per radius of the fibre
    RgbTexturePtr color;          // of thick hair
    FloatTexturePtr eumelanin;    // concentration; brown and black
    FloatTexturePtr pheomelanin;  // concentration; red
    FloatTexturePtr eta;          // 1.55
    FloatTexturePtr betaM;        // 0.3; roughness along the fibre, [0, 1]
    FloatTexturePtr betaN;        // 0.3; roughness around it, [0, 1]
    FloatTexturePtr alpha;        // 2; angle of the scales, degrees
    FloatTexturePtr bump;         // none
};
MaterialPtr makeHair(HairParams params);

}  // namespace drc
