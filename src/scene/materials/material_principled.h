// A material for everyday surfaces. Its parameters are those of the Principled BSDF of Blender 4, so that Blender's
// scenes look the same. The layers, from the top, are sheen, coat, and below them metal, glass, or a dielectric over a
// diffuse base, mixed by "metallic" and "transmission".
//
// No layer gains energy: light that a layer reflects towards the viewer is subtracted from the layers below. The
// directional albedo is Blender's to the accuracy of the tables; the distribution over the directions of the light
// differs a little below layers, where the lobes here are reciprocal (see LayersAbove and LayeredDiffuse).
//
// Sources: Burley 2012 and 2015 (as in material_disney.h) for the parameters; Zeltner, Burley and Chiang, "Practical
// Multiple-Scattering Sheen Using Linearly Transformed Cosines", SIGGRAPH 2022 talks, for the albedo of the sheen; and
// the papers named in microfacet_albedo.h and fresnel.h.
#pragma once
#include "scene/materials/material.h"

namespace drc {

// The comments give the defaults for null textures. Weights are shares of the surface, in [0, 1].
struct PrincipledParams {
    RgbTexturePtr baseColor;              // 0.8
    FloatTexturePtr metallic;             // 0; weight
    FloatTexturePtr roughness;            // 0.5; alpha is its square
    FloatTexturePtr diffuseRoughness;     // 0; of the diffuse base, see RoughDiffuse
    FloatTexturePtr ior;                  // 1.5; index inside, relative to outside
    FloatTexturePtr specularLevel;        // 0.5; scales the dielectric's reflectance at normal incidence by twice this
    RgbTexturePtr specularTint;           // 1; tint of that reflectance, and of metal towards grazing angles
    FloatTexturePtr anisotropic;          // 0; up to 1, stretches highlights of metal and dielectric along the tangent
    FloatTexturePtr anisotropicRotation;  // 0; rotation of the tangent, in turns
    FloatTexturePtr transmission;         // 0; weight of glass
    RgbTexturePtr reflectionTint;         // 1; tint of the reflection off glass, except for a thin wall
    FloatTexturePtr coat;                 // 0; weight
    FloatTexturePtr coatRoughness;        // 0.03
    FloatTexturePtr coatIor;              // 1.5
    RgbTexturePtr coatTint;               // 1; transmittance of the coat along the normal, in and out together
    FloatTexturePtr sheen;                // 0; weight
    FloatTexturePtr sheenRoughness;       // 0.5
    RgbTexturePtr sheenTint;              // 1
    // 0; weight of subsurface scattering, which counts as diffuse reflection. In a thin wall, half of this light leaves
    // on the far side.
    FloatTexturePtr subsurface;
    FloatTexturePtr alpha;             // 1; share of rays that hit the surface (Material::opacity)
    RgbTexturePtr emission;            // 1; colour of the emitted light
    FloatTexturePtr emissionStrength;  // 0; radiance emitted on both sides (Material::emission)
    bool thinWall = false;             // the surface is a sheet without interior: glass does not bend light
    Relief relief;                     // none
};
MaterialPtr makePrincipled(PrincipledParams params);

}  // namespace drc
