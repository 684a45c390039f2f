#include "pbrt/material_factory.h"

#include "pbrt/material_common.h"
#include "pbrt/material_principled_params.h"
#include "scene/materials/material_disney.h"
#include "scene/materials/material_fourier.h"
#include "scene/materials/material_glass.h"
#include "scene/materials/material_matte.h"
#include "scene/materials/material_metal.h"
#include "scene/materials/material_mirror.h"
#include "scene/materials/material_mix.h"
#include "scene/materials/material_plastic.h"
#include "scene/materials/material_substrate.h"
#include "scene/materials/material_subsurface.h"
#include "scene/materials/material_translucent.h"
#include "scene/materials/material_uber.h"

namespace drc::pbrt {
namespace {

Relief reliefOf(const TextureParams& p) { return p.scalarOrNull("bumpmap"); }
// pbrt has two names for the index of refraction; "eta" takes precedence.
FloatTexturePtr indexOf(const TextureParams& p) {
    const FloatTexturePtr index = p.scalarOrNull("index");
    const FloatTexturePtr eta = p.scalarOrNull("eta");
    return eta ? eta : index;
}

MaterialPtr matte(const MaterialContext& c) {
    const TextureParams& p = c.params;
    return makeMatte({.kd = p.colorOrNull("Kd"), .sigma = p.scalarOrNull("sigma"), .relief = reliefOf(p)});
}

MaterialPtr plastic(const MaterialContext& c) {
    const TextureParams& p = c.params;
    return makePlastic({.kd = p.colorOrNull("Kd"),
                        .ks = p.colorOrNull("Ks"),
                        .roughness = p.scalarOrNull("roughness"),
                        .remapRoughness = remapOf(p),
                        .relief = reliefOf(p)});
}

MaterialPtr metal(const MaterialContext& c) {
    const TextureParams& p = c.params;
    return makeMetal({.eta = p.colorOrNull("eta"),
                      .k = p.colorOrNull("k"),
                      .roughness = p.scalarOrNull("roughness"),
                      .uRoughness = p.scalarOrNull("uroughness"),
                      .vRoughness = p.scalarOrNull("vroughness"),
                      .remapRoughness = remapOf(p),
                      .relief = reliefOf(p)});
}

MaterialPtr mirror(const MaterialContext& c) {
    return makeMirror({.kr = c.params.colorOrNull("Kr"), .relief = reliefOf(c.params)});
}

MaterialPtr glass(const MaterialContext& c) {
    const TextureParams& p = c.params;
    return makeGlass({.kr = p.colorOrNull("Kr"),
                      .kt = p.colorOrNull("Kt"),
                      .eta = indexOf(p),
                      .uRoughness = p.scalarOrNull("uroughness"),
                      .vRoughness = p.scalarOrNull("vroughness"),
                      .remapRoughness = remapOf(p),
                      .relief = reliefOf(p)});
}

MaterialPtr uber(const MaterialContext& c) {
    const TextureParams& p = c.params;
    return makeUber({.kd = p.colorOrNull("Kd"),
                     .ks = p.colorOrNull("Ks"),
                     .kr = p.colorOrNull("Kr"),
                     .kt = p.colorOrNull("Kt"),
                     .opacity = p.colorOrNull("opacity"),
                     .roughness = p.scalarOrNull("roughness"),
                     .uRoughness = p.scalarOrNull("uroughness"),
                     .vRoughness = p.scalarOrNull("vroughness"),
                     .eta = indexOf(p),
                     .remapRoughness = remapOf(p),
                     .relief = reliefOf(p)});
}

MaterialPtr substrate(const MaterialContext& c) {
    const TextureParams& p = c.params;
    return makeSubstrate({.kd = p.colorOrNull("Kd"),
                          .ks = p.colorOrNull("Ks"),
                          .uRoughness = p.scalarOrNull("uroughness"),
                          .vRoughness = p.scalarOrNull("vroughness"),
                          .remapRoughness = remapOf(p),
                          .relief = reliefOf(p)});
}

MaterialPtr translucent(const MaterialContext& c) {
    const TextureParams& p = c.params;
    return makeTranslucent({.kd = p.colorOrNull("Kd"),
                            .ks = p.colorOrNull("Ks"),
                            .reflect = p.colorOrNull("reflect"),
                            .transmit = p.colorOrNull("transmit"),
                            .roughness = p.scalarOrNull("roughness"),
                            .remapRoughness = remapOf(p),
                            .relief = reliefOf(p)});
}

MaterialPtr disney(const MaterialContext& c) {
    const TextureParams& p = c.params;
    const RgbTexturePtr scatter = p.colorOrNull("scatterdistance");
    if (scatter && !(scatter->isConstant() && isBlack(scatter->eval({}))))
        warn(p.own().pos(), "parameter 'scatterdistance' of " + p.own().owner() +
                                " is not supported yet; the surface is diffuse, without scattering below it");
    return makeDisney({.color = p.colorOrNull("color"),
                       .metallic = p.scalarOrNull("metallic"),
                       .eta = p.scalarOrNull("eta"),
                       .roughness = p.scalarOrNull("roughness"),
                       .specularTint = p.scalarOrNull("speculartint"),
                       .anisotropic = p.scalarOrNull("anisotropic"),
                       .sheen = p.scalarOrNull("sheen"),
                       .sheenTint = p.scalarOrNull("sheentint"),
                       .clearcoat = p.scalarOrNull("clearcoat"),
                       .clearcoatGloss = p.scalarOrNull("clearcoatgloss"),
                       .specTrans = p.scalarOrNull("spectrans"),
                       .flatness = p.scalarOrNull("flatness"),
                       .diffTrans = p.scalarOrNull("difftrans"),
                       .thin = p.getBool("thin", false),
                       .relief = reliefOf(p)});
}

MaterialPtr hair(const MaterialContext& c) {
    return makeHair(hairOf(c.params, c.params.colorOrNull("color"), "color", reliefOf(c.params)));
}

MaterialPtr principled(const MaterialContext& c) { return principledOf(c.params, reliefOf(c.params)); }

MaterialPtr mix(const MaterialContext& c) {
    const auto part = [&](const std::string& param) {
        MaterialPtr named = namedPart(c, c.params.getString(param, ""), param, c.params.own().pos());
        return named ? named : makeMatte({});
    };
    const MaterialPtr first = part("namedmaterial1");
    MaterialPtr whole =
        makeMix({.first = first, .second = part("namedmaterial2"), .amount = c.params.colorOrNull("amount")});
    checkLobes(*whole, c.params.own().pos());
    return whole;
}

MaterialPtr fourier(const MaterialContext& c) {
    const Param& name = c.params.own().needFile("bsdffile");
    const std::string path = c.sources.files.find(name.strings[0], name.valuePos, "BSDF file");
    return makeFourier(c.sources.bsdfs.fourier(path, name.valuePos), reliefOf(c.params));
}

// Parameters common to the two materials with subsurface scattering.
SubsurfaceParams subsurfaceOf(const TextureParams& p) {
    // These set how far light spreads below the surface. Here light leaves where it enters, because a BSDF has no
    // spread.
    p.own().ignore({"scale", "mfp"});
    SubsurfaceParams made;
    made.kr = p.colorOrNull("Kr");
    made.kt = p.colorOrNull("Kt");
    made.eta = p.getFloat("eta", 1.33f);
    made.uRoughness = p.scalarOrNull("uroughness");
    made.vRoughness = p.scalarOrNull("vroughness");
    made.scale = remapOf(p) ? SubsurfaceParams::Roughness::Mapped : SubsurfaceParams::Roughness::Alpha;
    made.relief = reliefOf(p);
    return made;
}

MaterialPtr subsurface(const MaterialContext& c) {
    const TextureParams& p = c.params;
    SubsurfaceParams made = subsurfaceOf(p);
    made.sigmaA = p.colorOrNull("sigma_a");
    made.sigmaS = p.colorOrNull("sigma_s");
    made.g = p.getFloat("g", 0);
    if (const std::optional<NamedMedium> medium = mediumOf(p, false)) {
        if (!made.sigmaA) made.sigmaA = constantTexture(medium->sigmaA);
        if (!made.sigmaS) made.sigmaS = constantTexture(medium->sigmaSPrime);
        made.g = 0;  // because the coefficients are reduced ones
    }
    return makeSubsurface(std::move(made));
}

MaterialPtr kdSubsurface(const MaterialContext& c) {
    const TextureParams& p = c.params;
    SubsurfaceParams made = subsurfaceOf(p);
    made.reflectance = p.color("Kd", Rgb(0.5f));
    p.own().ignore({"g"});  // has no effect on a given reflectance
    return makeSubsurface(std::move(made));
}

constexpr Registered<MaterialMaker> kMaterials[] = {
    {"disney", disney},
    {"fourier", fourier},
    {"glass", glass},
    {"hair", hair},
    {"kdsubsurface", kdSubsurface},
    {"matte", matte},
    {"metal", metal},
    {"mirror", mirror},
    {"mix", mix},
    {"plastic", plastic},
    {"principled", principled},
    {"subsurface", subsurface},
    {"substrate", substrate},
    {"translucent", translucent},
    {"uber", uber},
};

constexpr std::string_view kNone[] = {"none"};
constexpr MaterialTable kTable{kMaterials, kNone};

}  // namespace

std::shared_ptr<const MaterialInstance> makeMaterial(const std::string& type, ParamSet params,
                                                     const MaterialSources& sources) {
    return makeMaterialOf(kTable, type, std::move(params), sources);
}

MaterialPtr materialForShape(const MaterialInstance& instance, const ParamSet& shape, const MaterialSources& sources) {
    const size_t unused = shape.unusedCount();
    if (unused == 0 || isNone(kTable, instance.type)) return instance.material;
    // Parameters that the shape has not read may belong to its material. Making the material shows whether they do.
    const TextureParams params(instance.params, sources.textures, &shape);
    MaterialPtr own = makerOf(kTable, instance.type, instance.params.pos())({params, sources});
    return shape.unusedCount() < unused ? own : instance.material;
}

}  // namespace drc::pbrt
