// Functions that the material factories of both dialects share.
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
    std::span<const std::string_view> none;  // types without a surface, besides ""
};
bool isNone(const MaterialTable& table, std::string_view type);
// Throws Error at pos for types that are not in the table.
MaterialMaker makerOf(const MaterialTable& table, const std::string& type, const SourcePos& pos);
std::shared_ptr<const MaterialInstance> makeMaterialOf(const MaterialTable& table, const std::string& type,
                                                       ParamSet params, const MaterialSources& sources);

inline bool remapOf(const TextureParams& p) { return p.getBool("remaproughness", true); }

// The medium that the parameter "name" of a subsurface material names; none if the parameter is missing or empty. For
// an unknown name, throws Error at the parameter if mustBeKnown is set, otherwise warns and returns none.
std::optional<NamedMedium> mediumOf(const TextureParams& p, bool mustBeKnown);

// All parameters of hair except the reflectance and the relief, whose names differ between the dialects. Warns if the
// colour is given in several ways. colorName: name of the reflectance's parameter.
HairParams hairOf(const TextureParams& p, RgbTexturePtr reflectance, std::string_view colorName, Relief relief);

// Throws Error at pos if a material may have more lobes than a Bsdf can hold.
void checkLobes(const Material& material, const SourcePos& pos);

// A material that a mix refers to. Throws Error at pos if it is 'none'. If it is undefined, warns and returns null in
// pbrt-v3, and throws UndefinedName in pbrt-v4. `what` is used in messages.
MaterialPtr namedPart(const MaterialContext& c, const std::string& name, const std::string& what, const SourcePos& pos);

}  // namespace drc::pbrt
