#include "pbrt/material_principled_params.h"

#include "scene/materials/material_principled.h"

namespace drc::pbrt {

MaterialPtr principledOf(const TextureParams& p, Relief relief) {
    return makePrincipled({.baseColor = p.colorOrNull("basecolor"),
                           .metallic = p.scalarOrNull("metallic"),
                           .roughness = p.scalarOrNull("roughness"),
                           .diffuseRoughness = p.scalarOrNull("diffuseroughness"),
                           .ior = p.scalarOrNull("ior"),
                           .specularLevel = p.scalarOrNull("specularlevel"),
                           .specularTint = p.colorOrNull("speculartint"),
                           .anisotropic = p.scalarOrNull("anisotropic"),
                           .anisotropicRotation = p.scalarOrNull("anisotropicrotation"),
                           .transmission = p.scalarOrNull("transmission"),
                           .reflectionTint = p.colorOrNull("reflectiontint"),
                           .coat = p.scalarOrNull("coat"),
                           .coatRoughness = p.scalarOrNull("coatroughness"),
                           .coatIor = p.scalarOrNull("coatior"),
                           .coatTint = p.colorOrNull("coattint"),
                           .sheen = p.scalarOrNull("sheen"),
                           .sheenRoughness = p.scalarOrNull("sheenroughness"),
                           .sheenTint = p.colorOrNull("sheentint"),
                           .subsurface = p.scalarOrNull("subsurface"),
                           .alpha = p.scalarOrNull("alpha"),
                           .emission = p.colorOrNull("emission"),
                           .emissionStrength = p.scalarOrNull("emissionstrength"),
                           .thinWall = p.getBool("thinwall", false),
                           .relief = std::move(relief)});
}

}  // namespace drc::pbrt
