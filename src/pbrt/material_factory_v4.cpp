#include "pbrt/material_factory_v4.h"

#include <fmt/core.h>

#include "pbrt/material_common.h"
#include "pbrt/material_principled_params.h"
#include "pbrt/normalized_name.h"
#include "scene/materials/material_coated.h"
#include "scene/materials/material_conductor.h"
#include "scene/materials/material_dielectric.h"
#include "scene/materials/material_diffuse_transmission.h"
#include "scene/materials/material_matte.h"
#include "scene/materials/material_measured.h"
#include "scene/materials/material_mix.h"
#include "scene/materials/material_subsurface.h"
#include "scene/textures/texture_convert.h"
#include "scene/textures/texture_imagemap.h"

namespace drc::pbrt {
namespace {

// A normal map's colours are vector components, so they are never decoded from sRGB.
Relief reliefOf(const MaterialContext& c) {
    FloatTexturePtr heights = c.params.scalarOrNull("displacement");
    const Param* map = c.params.own().findFile("normalmap");
    if (map == nullptr) return heights;
    const std::string path = c.sources.files.find(map->strings[0], map->valuePos, "normal map");
    if (heights)
        warn(map->valuePos,
             c.params.own().owner() + " has a 'normalmap' and a 'displacement'; as in pbrt, the normal map counts");
    return {nullptr,
            makeImageMap(c.sources.images.color(path, {.gamma = TexelGamma::Linear}, map->valuePos), ImageMapParams())};
}

// As in pbrt, an "rgb" outside [0, 1] is an error, whereas textures and spectra are clamped.
void checkRgb(const ParamSet& own, std::string_view name) {
    const Param* param = own.findIfTyped(name, {ParamType::Color});
    if (param == nullptr || param->typeName != "rgb") return;
    for (const double number : param->numbers)
        if (!(number >= 0 && number <= 1))
            fail(param->valuePos,
                 fmt::format("parameter '{}' of {} is the share of the light that is reflected, and must "
                             "be from 0 to 1, not {:g}",
                             name, own.owner(), number));
}

// A reflectance from 0 to `most`. A number instead of a colour is a grey.
RgbTexturePtr reflectanceOf(const TextureParams& p, std::string_view name = "reflectance", float most = 1) {
    checkRgb(p.own(), name);
    const bool isGrey = p.own().findIfTyped(name, {ParamType::Float}) != nullptr;
    const RgbTexturePtr given = isGrey ? constantTexture(Rgb(p.own().getFloat(name, 0))) : p.colorOrNull(name);
    return given ? makeClampedTexture(given, most) : nullptr;
}

// As in pbrt, a conductor's reflectance is limited to slightly less than 1.
constexpr float kMostOfConductor = .9999f;

// An index of refraction may be given as a spectrum. Its luminance is used, because there is no dispersion here.
FloatTexturePtr indexOf(const TextureParams& p, std::string_view name = "eta") {
    if (p.own().findIfTyped(name, {ParamType::Color}) != nullptr)
        return constantTexture(luminance(p.own().getColor(name, Rgb(1.f))));
    return p.scalarOrNull(name);
}

// As in pbrt, a conductor has either an index (eta and k) or a reflectance; giving both is an error.
void checkReflectance(const TextureParams& p, bool indices, bool reflectance, const std::string& prefix) {
    if (indices && reflectance)
        fail(p.own().pos(), p.own().owner() + " has both 'reflectance' and '" + prefix + "eta' or '" + prefix +
                                "k'; give the one or the other");
}

MaterialPtr diffuse(const MaterialContext& c) {
    // The roughness is DRC's own parameter. It is not named "roughness", a name that pbrt's diffuse does not have,
    // because an Attribute meant for other materials could then set it.
    return makeMatte({.kd = reflectanceOf(c.params),
                      .sigma = {},
                      .roughness = c.params.scalarOrNull("diffuseroughness"),
                      .relief = reliefOf(c)});
}

MaterialPtr conductor(const MaterialContext& c) {
    const TextureParams& p = c.params;
    ConductorParams made{.eta = p.colorOrNull("eta"),
                         .k = p.colorOrNull("k"),
                         .reflectance = reflectanceOf(p, "reflectance", kMostOfConductor),
                         .roughness = p.scalarOrNull("roughness"),
                         .uRoughness = p.scalarOrNull("uroughness"),
                         .vRoughness = p.scalarOrNull("vroughness"),
                         .remapRoughness = remapOf(p),
                         .relief = reliefOf(c)};
    checkReflectance(p, made.eta || made.k, made.reflectance != nullptr, "");
    return makeConductor(std::move(made));
}

MaterialPtr dielectric(const MaterialContext& c) {
    const TextureParams& p = c.params;
    return makeDielectric({.eta = indexOf(p),
                           .roughness = p.scalarOrNull("roughness"),
                           .uRoughness = p.scalarOrNull("uroughness"),
                           .vRoughness = p.scalarOrNull("vroughness"),
                           .remapRoughness = remapOf(p),
                           .relief = reliefOf(c)});
}

MaterialPtr thinDielectric(const MaterialContext& c) {
    return makeThinDielectric({.eta = indexOf(c.params), .relief = reliefOf(c)});
}

MaterialPtr diffuseTransmission(const MaterialContext& c) {
    const TextureParams& p = c.params;
    return makeDiffuseTransmission({.reflectance = reflectanceOf(p),
                                    .transmittance = reflectanceOf(p, "transmittance"),
                                    .scale = p.getFloat("scale", 1),
                                    .relief = reliefOf(c)});
}

// Parameters common to both coated materials, with names that begin with prefix.
CoatParams coatOf(const TextureParams& p, const std::string& prefix) {
    // These control pbrt's random walk, for which DRC has a closed form instead.
    p.own().ignore({"maxdepth", "nsamples"});
    return {.roughness = p.scalarOrNull(prefix + "roughness"),
            .uRoughness = p.scalarOrNull(prefix + "uroughness"),
            .vRoughness = p.scalarOrNull(prefix + "vroughness"),
            .eta = indexOf(p, prefix + "eta"),
            .thickness = p.scalarOrNull("thickness"),
            .albedo = reflectanceOf(p, "albedo"),
            .g = p.scalarOrNull("g")};
}

MaterialPtr coatedDiffuse(const MaterialContext& c) {
    const TextureParams& p = c.params;
    return makeCoatedDiffuse(
        {.coat = coatOf(p, ""), .reflectance = reflectanceOf(p), .remapRoughness = remapOf(p), .relief = reliefOf(c)});
}

MaterialPtr coatedConductor(const MaterialContext& c) {
    const TextureParams& p = c.params;
    CoatedConductorParams made{.coat = coatOf(p, "interface."),
                               .eta = p.colorOrNull("conductor.eta"),
                               .k = p.colorOrNull("conductor.k"),
                               .reflectance = reflectanceOf(p, "reflectance", kMostOfConductor),
                               .roughness = p.scalarOrNull("conductor.roughness"),
                               .uRoughness = p.scalarOrNull("conductor.uroughness"),
                               .vRoughness = p.scalarOrNull("conductor.vroughness"),
                               .remapRoughness = remapOf(p),
                               .relief = reliefOf(c)};
    checkReflectance(p, made.eta || made.k, made.reflectance != nullptr, "conductor.");
    return makeCoatedConductor(std::move(made));
}

MaterialPtr measured(const MaterialContext& c) {
    const Param& name = c.params.own().needFile("filename");
    const std::string path = c.sources.files.find(name.strings[0], name.valuePos, "BSDF file");
    return makeMeasured(c.sources.bsdfs.measured(path, name.valuePos), reliefOf(c));
}

MaterialPtr hair(const MaterialContext& c) {
    const TextureParams& p = c.params;
    RgbTexturePtr reflectance = reflectanceOf(p);
    const RgbTexturePtr color = reflectanceOf(p, "color");  // pbrt also accepts this name
    const std::string_view name = reflectance || !color ? "reflectance" : "color";
    return makeHair(hairOf(p, reflectance ? std::move(reflectance) : color, name, reliefOf(c)));
}

MaterialPtr principled(const MaterialContext& c) { return principledOf(c.params, reliefOf(c)); }
// The medium is given by its name, by its coefficients, or by the resulting reflectance.
MaterialPtr subsurface(const MaterialContext& c) {
    const TextureParams& p = c.params;
    // These set how far light spreads below the surface. Here light leaves where it enters, because a BSDF has no
    // spread.
    p.own().ignore({"scale", "mfp"});
    SubsurfaceParams made;
    made.sigmaA = p.colorOrNull("sigma_a");
    made.sigmaS = p.colorOrNull("sigma_s");
    made.g = p.getFloat("g", 0);
    made.reflectance = reflectanceOf(p);
    made.eta = p.getFloat("eta", 1.33f);
    made.roughness = p.scalarOrNull("roughness");
    made.uRoughness = p.scalarOrNull("uroughness");
    made.vRoughness = p.scalarOrNull("vroughness");
    made.scale = remapOf(p) ? SubsurfaceParams::Roughness::Squared : SubsurfaceParams::Roughness::Alpha;
    made.relief = reliefOf(c);
    const bool coefficients = made.sigmaA || made.sigmaS;
    if (const std::optional<NamedMedium> medium = mediumOf(p, true)) {
        if (coefficients || made.reflectance || made.g != 0)
            warn(p.own().pos(),
                 "the coefficients, 'g' and 'reflectance' of " + p.own().owner() + " are ignored, as 'name' is given");
        made.sigmaA = constantTexture(medium->sigmaA);
        made.sigmaS = constantTexture(medium->sigmaSPrime);
        made.g = 0;  // because the coefficients are reduced ones
        made.reflectance = nullptr;
    } else if (coefficients) {
        if (made.reflectance)
            fail(p.own().pos(),
                 p.own().owner() + " has both 'reflectance' and 'sigma_a' or 'sigma_s'; give the one or the other");
        if (!made.sigmaA || !made.sigmaS)
            fail(p.own().pos(), p.own().owner() + " has only one of 'sigma_a' and 'sigma_s'; give both");
    }
    return makeSubsurface(std::move(made));
}

// Unlike in pbrt-v3, the amount is a number, and weights the second material.
MaterialPtr mix(const MaterialContext& c) {
    const ParamSet& own = c.params.own();
    const Param* names = own.find("materials", {ParamType::String});
    if (names == nullptr) fail(own.pos(), own.owner() + " needs the parameter \"string materials\" with two names");
    if (names->count() != 2)
        own.failAt(*names, "must have two materials' names, not " + std::to_string(names->count()));
    const auto part = [&](size_t i, const std::string& what) {
        return namedPart(c, normalizedName(names->strings[i], Dialect::V4), what, names->valuePos);
    };
    const MaterialPtr first = part(0, "first of 'materials'"), second = part(1, "second of 'materials'");
    MaterialPtr whole =
        makeMix({.first = first, .second = second, .amount = makeRemainderTexture(c.params.scalar("amount", 0.5f))});
    checkLobes(*whole, own.pos());
    return whole;
}

constexpr Registered<MaterialMaker> kMaterials[] = {
    {"coatedconductor", coatedConductor},
    {"coateddiffuse", coatedDiffuse},
    {"conductor", conductor},
    {"dielectric", dielectric},
    {"diffuse", diffuse},
    {"diffusetransmission", diffuseTransmission},
    {"hair", hair},
    {"measured", measured},
    {"mix", mix},
    {"principled", principled},
    {"subsurface", subsurface},
    {"thindielectric", thinDielectric},
};

constexpr std::string_view kNone[] = {"interface", "none"};
constexpr MaterialTable kTable{kMaterials, kNone};

}  // namespace

std::shared_ptr<const MaterialInstance> makeMaterialV4(const std::string& type, ParamSet params,
                                                       const MaterialSources& sources) {
    return makeMaterialOf(kTable, type, std::move(params), sources);
}

}  // namespace drc::pbrt
