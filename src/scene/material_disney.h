// Burley's principled material (pbrt's "disney"; Burley, "Physically Based Shading at Disney", SIGGRAPH 2012 course,
// and "Extending the Disney BRDF to a BSDF with Integrated Subsurface Scattering", SIGGRAPH 2015 course).
#pragma once
#include "scene/material.h"

namespace drc {

// Null textures take the values given here, which are pbrt's. All but the colour and eta are meant to be in [0, 1]
// (diffTrans in [0, 2]).
struct DisneyParams {
    RgbTexturePtr color;             // 0.5
    FloatTexturePtr metallic;        // 0
    FloatTexturePtr eta;             // 1.5
    FloatTexturePtr roughness;       // 0.5; alpha is its square
    FloatTexturePtr specularTint;    // 0; how much the highlight takes of the colour's hue
    FloatTexturePtr anisotropic;     // 0
    FloatTexturePtr sheen;           // 0
    FloatTexturePtr sheenTint;       // 0.5
    FloatTexturePtr clearcoat;       // 0
    FloatTexturePtr clearcoatGloss;  // 1
    FloatTexturePtr specTrans;       // 0; part of what is not metallic that is glass
    FloatTexturePtr flatness;        // 0; thin surfaces only: blend towards shallow subsurface scattering
    FloatTexturePtr diffTrans;       // 1; thin surfaces only: 0 all diffuse light is reflected, 2 all is transmitted
    bool thin = false;               // a sheet without an inside
    FloatTexturePtr bump;            // none
};
MaterialPtr makeDisney(DisneyParams params);

}  // namespace drc
