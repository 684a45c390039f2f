#include "pbrt/medium_factory.h"

#include <fmt/core.h>

#include "pbrt/named_media.h"
#include "pbrt/registry.h"

namespace drc::pbrt {
namespace {

// A colour without negative components; throws Error at the parameter otherwise.
Rgb coefficient(const ParamSet& params, std::string_view name, const Rgb& fallback) {
    const Rgb c = params.getColor(name, fallback);
    if (!(c.x >= 0 && c.y >= 0 && c.z >= 0))
        params.failAt(*params.find(name, {ParamType::Color}), "must not have a negative component");
    return c;
}

// Coefficients in the file are per unit of length; those of a preset are per millimetre.
Medium makeHomogeneous(const ParamSet& params, Dialect dialect) {
    const bool isV4 = dialect == Dialect::V4;
    // pbrt-v3's defaults are the coefficients of whole milk.
    Rgb sigmaA = isV4 ? Rgb(1.f) : Rgb(.0011f, .0024f, .014f), sigmaS = isV4 ? Rgb(1.f) : Rgb(2.55f, 3.21f, 3.77f);
    const std::string preset = params.getString("preset", "");
    if (!preset.empty()) {
        if (const auto named = namedMedium(preset)) {
            sigmaA = named->sigmaA;
            sigmaS = named->sigmaSPrime;
        } else {
            warn(params.find("preset", {ParamType::String})->valuePos, "unknown medium '" + preset + "'" +
                                                                           suggestion(preset, namesOfMedia()) +
                                                                           "; the other parameters count");
        }
    }
    const float scale = params.getNonNegativeFloat("scale", 1);
    Medium medium;
    medium.sigmaA = coefficient(params, "sigma_a", sigmaA) * scale;
    medium.sigmaS = coefficient(params, "sigma_s", sigmaS) * scale;
    medium.g = params.getFloat("g", 0);
    if (!(medium.g > -1 && medium.g < 1))
        params.failAt(*params.find("g", {ParamType::Float}),
                      fmt::format("must be between -1 and 1, both excluded, not {:g}", medium.g));
    if (isV4) medium.emission = coefficient(params, "Le", Rgb(0.f)) * params.getNonNegativeFloat("Lescale", 1);
    if (!isFinite(medium.sigmaT()) || !isFinite(medium.emission))
        fail(params.pos(), "the coefficients of " + params.owner() + " are too large");
    return medium;
}

using MediumMaker = Medium (*)(const ParamSet&, Dialect);
constexpr Registered<MediumMaker> kMedia[] = {{"homogeneous", makeHomogeneous}, {"heterogeneous", nullptr}};
constexpr Registered<MediumMaker> kMediaV4[] = {{"homogeneous", makeHomogeneous},
                                                {"cloud", nullptr},
                                                {"nanovdb", nullptr},
                                                {"rgbgrid", nullptr},
                                                {"uniformgrid", nullptr}};

}  // namespace

Medium makeMedium(const ParamSet& params, Dialect dialect) {
    const Param* type = params.find("type", {ParamType::String});
    if (type == nullptr) fail(params.pos(), "the " + params.owner() + " needs the parameter \"string type\"");
    using Table = std::span<const Registered<MediumMaker>>;
    const Table table = dialect == Dialect::V4 ? Table(kMediaV4) : Table(kMedia);
    const std::string name = params.getString("type", "");
    const MediumMaker make = findMaker(table, "medium", name, type->valuePos, "such media are left out");
    if (make != nullptr) return make(params, dialect);
    params.ignoreAll();
    return {};
}

}  // namespace drc::pbrt
