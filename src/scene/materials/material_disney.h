// Burley's principled material (pbrt's "disney"; Burley, "Physically Based Shading at Disney", SIGGRAPH 2012 course,
// and "Extending the Disney BRDF to a BSDF with Integrated Subsurface Scattering", SIGGRAPH 2015 course).
#pragma once
#include "scene/materials/material.h"

namespace drc {

// The comments give the defaults for null textures, which are those of pbrt. All parameters except color and eta should
// be in [0, 1] (diffTrans in [0, 2]).
struct DisneyParams {
    RgbTexturePtr color;             // 0.5
    FloatTexturePtr metallic;        // 0
    FloatTexturePtr eta;             // 1.5
    FloatTexturePtr roughness;       // 0.5; alpha is its square
    FloatTexturePtr specularTint;    // 0; from 0 (white highlight) to 1 (highlight with the hue of the colour)
    FloatTexturePtr anisotropic;     // 0
    FloatTexturePtr sheen;           // 0
    FloatTexturePtr sheenTint;       // 0.5
    FloatTexturePtr clearcoat;       // 0
    FloatTexturePtr clearcoatGloss;  // 1
    FloatTexturePtr specTrans;       // 0; share of the dielectric part that is glass
    FloatTexturePtr flatness;        // 0; thin surfaces only: blend towards shallow subsurface scattering
    FloatTexturePtr
        diffTrans;      // 1; thin surfaces only: from 0 (all diffuse light is reflected) to 2 (all is transmitted)
    bool thin = false;  // a sheet without interior
    Relief relief;      // none
};
MaterialPtr makeDisney(DisneyParams params);

}  // namespace drc
