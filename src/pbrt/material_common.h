// Shared by the material factories of both dialects.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "pbrt/material_factory.h"
#include "pbrt/named_media.h"
#include "pbrt/registry.h"
#include "scene/materials/material_hair.h"

namespace drc::pbrt {

struct MaterialContext {
    const TextureParams& params;
    const MaterialSources& sources;
};
using MaterialMaker = MaterialPtr (*)(const MaterialContext&);

// The materials of one dialect.
struct MaterialTable {
    std::span<const Registered<MaterialMaker>> makers;
    std::span<const std::string_view> none;  // types without a surface; so is ""
};
bool isNone(const MaterialTable& table, std::string_view type);
// Throws Error at pos for types that are not in the table.
MaterialMaker makerOf(const MaterialTable& table, const std::string& type, const SourcePos& pos);
std::shared_ptr<const MaterialInstance> makeMaterialOf(const MaterialTable& table, const std::string& type,
                                                       ParamSet params, const MaterialSources& sources);

inline bool remapOf(const TextureParams& p) { return p.getBool("remaproughness", true); }

// The medium that the parameter "name" of a subsurface material names; none if there is no such parameter or if it is
// empty. For a name that is not known: throws Error at the parameter if it must be, else warns and returns none.
std::optional<NamedMedium> mediumOf(const TextureParams& p, bool mustBeKnown);

// All parameters of hair except its colour as a reflectance and its bump map, which have different names in the
// dialects. Warns if the colour is given in several ways; colorName is the name of the reflectance's parameter.
HairParams hairOf(const TextureParams& p, RgbTexturePtr reflectance, std::string_view colorName, Relief relief);

// Throws Error at pos if a material may have more lobes than a Bsdf can hold.
void checkLobes(const Material& material, const SourcePos& pos);

// A material that a mix names. Throws Error at pos if it is 'none'. If it is undefined, it is null in pbrt-v3, with a
// warning; in pbrt-v4 UndefinedName is thrown. `what` is used in messages.
MaterialPtr namedPart(const MaterialContext& c, const std::string& name, const std::string& what, const SourcePos& pos);

}  // namespace drc::pbrt
