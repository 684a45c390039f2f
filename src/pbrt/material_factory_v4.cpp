#include "pbrt/material_factory_v4.h"

#include "pbrt/registry.h"
#include "scene/material_coated.h"
#include "scene/material_conductor.h"
#include "scene/material_dielectric.h"
#include "scene/material_diffuse_transmission.h"
#include "scene/material_hair.h"
#include "scene/material_matte.h"
#include "scene/material_mix.h"

namespace drc::pbrt {
namespace {

struct MaterialContext {
    const TextureParams& params;
    const NamedMaterials& materials;
};

FloatTexturePtr bumpOf(const TextureParams& p) { return p.scalarOrNull("displacement"); }
bool remapOf(const TextureParams& p) { return p.getBool("remaproughness", true); }

// eta and k, or a reflectance in their place: pbrt takes it for a mistake to give both.
void checkReflectance(const TextureParams& p, bool indices, bool reflectance, const std::string& prefix) {
    if (indices && reflectance)
        fail(p.own().pos(), p.own().owner() + " has both 'reflectance' and '" + prefix + "eta' or '" + prefix +
                                "k'; give the one or the other");
}

MaterialPtr diffuse(const MaterialContext& c) {
    return makeMatte({.kd = c.params.colorOrNull("reflectance"), .sigma = {}, .bump = bumpOf(c.params)});
}

MaterialPtr conductor(const MaterialContext& c) {
    const TextureParams& p = c.params;
    ConductorParams made{.eta = p.colorOrNull("eta"),
                         .k = p.colorOrNull("k"),
                         .reflectance = p.colorOrNull("reflectance"),
                         .roughness = p.scalarOrNull("roughness"),
                         .uRoughness = p.scalarOrNull("uroughness"),
                         .vRoughness = p.scalarOrNull("vroughness"),
                         .remapRoughness = remapOf(p),
                         .bump = bumpOf(p)};
    checkReflectance(p, made.eta || made.k, made.reflectance != nullptr, "");
    return makeConductor(std::move(made));
}

MaterialPtr dielectric(const MaterialContext& c) {
    const TextureParams& p = c.params;
    return makeDielectric({.eta = p.scalarOrNull("eta"),
                           .roughness = p.scalarOrNull("roughness"),
                           .uRoughness = p.scalarOrNull("uroughness"),
                           .vRoughness = p.scalarOrNull("vroughness"),
                           .remapRoughness = remapOf(p),
                           .bump = bumpOf(p)});
}

MaterialPtr thinDielectric(const MaterialContext& c) {
    return makeThinDielectric({.eta = c.params.scalarOrNull("eta"), .bump = bumpOf(c.params)});
}

MaterialPtr diffuseTransmission(const MaterialContext& c) {
    const TextureParams& p = c.params;
    return makeDiffuseTransmission({.reflectance = p.colorOrNull("reflectance"),
                                    .transmittance = p.colorOrNull("transmittance"),
                                    .scale = p.getFloat("scale", 1),
                                    .bump = bumpOf(p)});
}

// What the two coated materials share, under names that begin with prefix.
CoatParams coatOf(const TextureParams& p, const std::string& prefix) {
    // Of pbrt's random walk, for which there is a closed form here.
    p.own().ignore({"maxdepth", "nsamples"});
    return {.roughness = p.scalarOrNull(prefix + "roughness"),
            .uRoughness = p.scalarOrNull(prefix + "uroughness"),
            .vRoughness = p.scalarOrNull(prefix + "vroughness"),
            .eta = p.scalarOrNull(prefix + "eta"),
            .thickness = p.scalarOrNull("thickness"),
            .albedo = p.colorOrNull("albedo"),
            .g = p.scalarOrNull("g")};
}

MaterialPtr coatedDiffuse(const MaterialContext& c) {
    const TextureParams& p = c.params;
    return makeCoatedDiffuse({.coat = coatOf(p, ""),
                              .reflectance = p.colorOrNull("reflectance"),
                              .remapRoughness = remapOf(p),
                              .bump = bumpOf(p)});
}

MaterialPtr coatedConductor(const MaterialContext& c) {
    const TextureParams& p = c.params;
    CoatedConductorParams made{.coat = coatOf(p, "interface."),
                               .eta = p.colorOrNull("conductor.eta"),
                               .k = p.colorOrNull("conductor.k"),
                               .reflectance = p.colorOrNull("reflectance"),
                               .roughness = p.scalarOrNull("conductor.roughness"),
                               .uRoughness = p.scalarOrNull("conductor.uroughness"),
                               .vRoughness = p.scalarOrNull("conductor.vroughness"),
                               .remapRoughness = remapOf(p),
                               .bump = bumpOf(p)};
    checkReflectance(p, made.eta || made.k, made.reflectance != nullptr, "conductor.");
    return makeCoatedConductor(std::move(made));
}

MaterialPtr hair(const MaterialContext& c) {
    const TextureParams& p = c.params;
    HairParams made{.sigmaA = p.colorOrNull("sigma_a"),
                    .color = p.colorOrNull("reflectance"),
                    .eumelanin = p.scalarOrNull("eumelanin"),
                    .pheomelanin = p.scalarOrNull("pheomelanin"),
                    .eta = p.scalarOrNull("eta"),
                    .betaM = p.scalarOrNull("beta_m"),
                    .betaN = p.scalarOrNull("beta_n"),
                    .alpha = p.scalarOrNull("alpha"),
                    .bump = bumpOf(p)};
    const int ways = (made.sigmaA ? 1 : 0) + (made.color ? 1 : 0) + (made.eumelanin || made.pheomelanin ? 1 : 0);
    if (ways > 1)
        warn(p.own().pos(), p.own().owner() +
                                " has its colour given in more than one way; of 'sigma_a', 'reflectance' and the "
                                "pigments the first counts");
    return makeHair(std::move(made));
}

// What a number leaves to one, as a grey.
class Remainder final : public RgbTexture {
  public:
    explicit Remainder(FloatTexturePtr number) : number_(std::move(number)) {}
    Rgb eval(const TextureContext& at) const override { return Rgb(1 - std::clamp(number_->eval(at), 0.f, 1.f)); }
    bool isConstant() const override { return number_->isConstant(); }

  private:
    FloatTexturePtr number_;
};

// Unlike pbrt-v3's, the amount is a number, and of the second.
MaterialPtr mix(const MaterialContext& c) {
    const ParamSet& own = c.params.own();
    const Param* names = own.find("materials", {ParamType::String});
    if (names == nullptr) fail(own.pos(), own.owner() + " needs the parameter \"string materials\" with two names");
    if (names->count() != 2)
        own.failAt(*names, "must have two materials' names, not " + std::to_string(names->count()));
    MaterialPtr parts[2];
    for (size_t i = 0; i < 2; ++i) {
        const std::string& name = names->strings[i];
        const auto found = c.materials.find(name);
        if (!found)
            own.failAt(*names, "names the material '" + name + "', which has not been defined" +
                                   suggestion(name, c.materials.names()));
        if (!found->material) own.failAt(*names, "names the material '" + name + "', which is an interface");
        parts[i] = found->material;
    }
    MaterialPtr whole = makeMix({.first = parts[0],
                                 .second = parts[1],
                                 .amount = std::make_shared<Remainder>(c.params.scalar("amount", 0.5f))});
    checkLobes(*whole, own.pos());
    return whole;
}

using MaterialMaker = MaterialPtr (*)(const MaterialContext&);
constexpr Registered<MaterialMaker> kMaterials[] = {
    {"coatedconductor", coatedConductor},
    {"coateddiffuse", coatedDiffuse},
    {"conductor", conductor},
    {"dielectric", dielectric},
    {"diffuse", diffuse},
    {"diffusetransmission", diffuseTransmission},
    {"hair", hair},
    {"measured", nullptr},
    {"mix", mix},
    {"subsurface", nullptr},
    {"thindielectric", thinDielectric},
};

}  // namespace

MaterialPtr makeMaterialV4(const std::string& type, const ParamSet& params, const NamedTextures& textures,
                           const NamedMaterials& materials) {
    params.ignore({"type"});  // MakeNamedMaterial's
    if (type.empty() || type == "interface" || type == "none") {
        params.ignoreAll();
        return nullptr;
    }
    const MaterialMaker make =
        findMaker<MaterialMaker>(kMaterials, "material", type, params.pos(), "grey diffuse is used");
    if (make == nullptr) {
        params.ignoreAll();
        return makeMatte({});
    }
    params.notBuilt({"normalmap"});
    const TextureParams textureParams(params, textures);
    MaterialPtr made = make({textureParams, materials});
    params.warnUnused();
    return made;
}

}  // namespace drc::pbrt
