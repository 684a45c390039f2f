#include "pbrt/material_common.h"

#include <algorithm>

#include "base/suggest.h"
#include "pbrt/undefined_name.h"

namespace drc::pbrt {

bool isNone(const MaterialTable& table, std::string_view type) {
    return type.empty() || std::find(table.none.begin(), table.none.end(), type) != table.none.end();
}

MaterialMaker makerOf(const MaterialTable& table, const std::string& type, const SourcePos& pos) {
    return findMaker(table.makers, "material", type, pos, "");
}

std::shared_ptr<const MaterialInstance> makeMaterialOf(const MaterialTable& table, const std::string& type,
                                                       ParamSet params, const MaterialSources& sources) {
    auto instance = std::make_shared<MaterialInstance>();
    instance->type = type;
    instance->params = std::move(params);
    const ParamSet& own = instance->params;
    own.ignore({"type"});  // belongs to MakeNamedMaterial
    if (isNone(table, type)) {
        own.ignoreAll();
        return instance;
    }
    const TextureParams textureParams(own, sources.textures);
    instance->material = makerOf(table, type, own.pos())({textureParams, sources});
    own.warnUnused();
    return instance;
}

std::optional<NamedMedium> mediumOf(const TextureParams& p, bool mustBeKnown) {
    const std::string name = p.getString("name", "");
    if (name.empty()) return std::nullopt;
    std::optional<NamedMedium> medium = namedMedium(name);
    if (medium) return medium;
    const Param* param = p.own().find("name", {ParamType::String});
    const SourcePos pos = param != nullptr ? param->valuePos : p.own().pos();
    const std::string complaint = "unknown medium '" + name + "'" + suggestion(name, namesOfMedia());
    if (mustBeKnown) fail(pos, complaint);
    warn(pos, complaint + "; the other parameters count");
    return std::nullopt;
}

HairParams hairOf(const TextureParams& p, RgbTexturePtr reflectance, std::string_view colorName, Relief relief) {
    HairParams hair{.sigmaA = p.colorOrNull("sigma_a"),
                    .color = std::move(reflectance),
                    .eumelanin = p.scalarOrNull("eumelanin"),
                    .pheomelanin = p.scalarOrNull("pheomelanin"),
                    .eta = p.scalarOrNull("eta"),
                    .betaM = p.scalarOrNull("beta_m"),
                    .betaN = p.scalarOrNull("beta_n"),
                    .alpha = p.scalarOrNull("alpha"),
                    .relief = std::move(relief)};
    const std::string_view counts = hair.sigmaA ? "sigma_a" : colorName;
    const auto ignored = [&](bool given, std::string_view name) {
        if (given)
            warn(p.own().pos(), "parameter '" + std::string(name) + "' of " + p.own().owner() + " is ignored, as '" +
                                    std::string(counts) + "' is given");
    };
    if (hair.sigmaA) ignored(hair.color != nullptr, colorName);
    if (hair.sigmaA || hair.color) {
        ignored(hair.eumelanin != nullptr, "eumelanin");
        ignored(hair.pheomelanin != nullptr, "pheomelanin");
    }
    return hair;
}

void checkLobes(const Material& material, const SourcePos& pos) {
    if (material.maxLobes() > Bsdf::kMaxLobes)
        fail(pos, "the mix has up to " + std::to_string(material.maxLobes()) + " lobes, which is more than the " +
                      std::to_string(Bsdf::kMaxLobes) + " that one surface may have; mix fewer or simpler materials");
}

MaterialPtr namedPart(const MaterialContext& c, const std::string& name, const std::string& what,
                      const SourcePos& pos) {
    const auto found = c.sources.materials.find(name);
    if (!found || found->awaited) {
        const std::string complaint = "the mix material's " + what + " '" + name + "' has not been defined",
                          advice = suggestion(name, c.sources.materials.names());
        if (c.sources.textures.dialect == Dialect::V4)
            throw UndefinedName(kMaterialName, name, pos, complaint + advice);
        warn(pos, complaint + "; 'matte' is mixed in its place" + advice);
        return nullptr;
    }
    if (!found->material) fail(pos, "the mix material's " + what + " '" + name + "' is 'none'");
    return found->material;
}

}  // namespace drc::pbrt
