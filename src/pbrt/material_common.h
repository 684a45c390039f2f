// What the makers of both dialects' materials have in common.
#pragma once
#include <string>
#include <string_view>

#include "pbrt/material_factory.h"
#include "scene/material_hair.h"

namespace drc::pbrt {

struct MaterialContext {
    const TextureParams& params;
    const NamedMaterials& materials;
};
using MaterialMaker = MaterialPtr (*)(const MaterialContext&);

inline bool remapOf(const TextureParams& p) { return p.getBool("remaproughness", true); }

// All of hair but its colour by reflectance and its bumps, which have a name of their own in each dialect. Warns if the
// colour is said in several ways; colorName is what the reflectance was called.
HairParams hairOf(const TextureParams& p, RgbTexturePtr reflectance, std::string_view colorName, FloatTexturePtr bump);

// A material that a mix names. Throws Error at pos for one that is not there or is none; what is for messages.
MaterialPtr namedPart(const MaterialContext& c, const std::string& name, const std::string& what, const SourcePos& pos);

}  // namespace drc::pbrt
