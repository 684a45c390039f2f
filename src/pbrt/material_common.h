// What the makers of both dialects' materials have in common.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "pbrt/material_factory.h"
#include "pbrt/registry.h"
#include "scene/material_hair.h"

namespace drc::pbrt {

struct MaterialContext {
    const TextureParams& params;
    const NamedMaterials& materials;
};
using MaterialMaker = MaterialPtr (*)(const MaterialContext&);

// The materials of one dialect.
struct MaterialTable {
    std::span<const Registered<MaterialMaker>> makers;
    std::span<const std::string_view> none;      // types without a surface; so is ""
    std::string_view placeholder;                // type of the grey material that stands for what is not built
    std::span<const std::string_view> notBuilt;  // parameters of any material
};
bool isNone(const MaterialTable& table, std::string_view type);
// Null, with a warning, for what is not built. Throws Error at pos for a type that is not in the table.
MaterialMaker makerOf(const MaterialTable& table, const std::string& type, const SourcePos& pos);
std::shared_ptr<const MaterialInstance> makeMaterialOf(const MaterialTable& table, const std::string& type,
                                                       ParamSet params, const NamedTextures& textures,
                                                       const NamedMaterials& materials);

inline bool remapOf(const TextureParams& p) { return p.getBool("remaproughness", true); }

// All of hair but its colour by reflectance and its bumps, which have a name of their own in each dialect. Warns if the
// colour is said in several ways; colorName is what the reflectance was called.
HairParams hairOf(const TextureParams& p, RgbTexturePtr reflectance, std::string_view colorName, FloatTexturePtr bump);

// Throws Error, at pos, for a material that may have more lobes than a Bsdf takes.
void checkLobes(const Material& material, const SourcePos& pos);

// A material that a mix names. Throws Error at pos for one that is not there or is none; what is for messages.
MaterialPtr namedPart(const MaterialContext& c, const std::string& name, const std::string& what, const SourcePos& pos);

}  // namespace drc::pbrt
