#include "scene/materials/material_coated.h"

#include "scene/materials/conductor_textures.h"

namespace drc {
namespace {

// The coat's parameters at one point.
struct Coat {
    DielectricCoat layer;
    std::optional<TrowbridgeReitz> distribution;  // none if the interface is smooth
    Rgb haze;                                     // reflectance of the scattering medium over a black base
    float alpha() const { return distribution ? distribution->meanAlpha() : 0; }
    float eta() const { return layer.eta(); }
    // Adds the reflection off the interface.
    void addReflection(const Rgb& weight, Bsdf& bsdf) const {
        if (eta() == 1) return;
        if (distribution)
            bsdf.add(MicrofacetReflection(Rgb(1.f), *distribution, Fresnel::coat(eta())), weight);
        else
            bsdf.add(SpecularReflection(Rgb(1.f), Fresnel::coat(eta())), weight);
    }
};

class CoatTextures {
  public:
    explicit CoatTextures(CoatParams params) : params_(std::move(params)) {
        params_.roughness = orConstant(params_.roughness, 0);
        params_.eta = orConstant(params_.eta, 1.5f);
        params_.thickness = orConstant(params_.thickness, 0.01f);
        params_.albedo = orConstant(params_.albedo, Rgb(0.f));
        params_.g = orConstant(params_.g, 0);
    }
    Coat at(const TextureContext& point, bool remap) const {
        const float depth = std::max(0.f, params_.thickness->eval(point));
        const Rgb albedo = evalClamped(*params_.albedo, point);
        // Forward scattering counts as no scattering. An upward and a downward flux exchange 3/4 of the rest per unit
        // of depth, as in the diffusion approximation. Absorption is grey.
        const float backwards = 0.75f * depth * (1 - std::clamp(params_.g->eval(point), -1.f, 1.f));
        Rgb haze;
        for (int c = 0; c < 3; ++c) {
            const float exchanged = backwards * std::min(1.f, albedo[c]);
            haze[c] = exchanged / (1 + exchanged);
        }
        const float absorbed = depth * (1 - std::min(1.f, average(albedo)));
        const auto distribution =
            distributionUnlessSmooth({params_.roughness, params_.uRoughness, params_.vRoughness, remap}, point);
        const float alpha = distribution ? distribution->meanAlpha() : 0;
        return {DielectricCoat(params_.eta->eval(point), alpha, absorbed), distribution, haze};
    }
    bool areAllConstant() const {
        return areConstant(params_.roughness, params_.uRoughness, params_.vRoughness, params_.eta, params_.thickness,
                           params_.albedo, params_.g);
    }

  private:
    CoatParams params_;
};

// Reflectance of a base seen through lossless haze.
Rgb throughHaze(const Rgb& base, const Rgb& haze) {
    Rgb sum;
    for (int c = 0; c < 3; ++c) sum[c] = haze[c] + sqr(1 - haze[c]) * base[c] / std::max(1e-6f, 1 - base[c] * haze[c]);
    return sum;
}

class CoatedDiffuseMaterial final : public Material {
  public:
    explicit CoatedDiffuseMaterial(CoatedDiffuseParams params)
        : coat_(std::move(params.coat)),
          reflectance_(orConstant(std::move(params.reflectance), Rgb(0.5f))),
          remap_(params.remapRoughness) {
        setRelief(std::move(params.relief));
    }
    void addLobes(const TextureContext& at, const Rgb& weight, Bsdf& bsdf) const override {
        const Coat coat = coat_.at(at, remap_);
        coat.addReflection(weight, bsdf);
        Rgb base = evalClamped(*reflectance_, at);
        for (int c = 0; c < 3; ++c) base[c] = std::min(1.f, base[c]);
        base = throughHaze(base, coat.haze);
        if (!isBlack(base)) bsdf.add(CoatedDiffuse(base, coat.layer), weight);
    }
    bool isConstant() const override { return coat_.areAllConstant() && areConstant(reflectance_); }
    int maxLobes() const override { return 2; }

  private:
    CoatTextures coat_;
    RgbTexturePtr reflectance_;
    bool remap_;
};

class CoatedConductorMaterial final : public Material {
  public:
    explicit CoatedConductorMaterial(CoatedConductorParams params)
        : coat_(std::move(params.coat)),
          params_(std::move(params)),
          index_(params_.eta, params_.k, params_.reflectance) {
        params_.roughness = orConstant(params_.roughness, 0);
        setRelief(params_.relief);
    }
    void addLobes(const TextureContext& at, const Rgb& weight, Bsdf& bsdf) const override {
        const Coat coat = coat_.at(at, params_.remapRoughness);
        const Fresnel base = index_.at(at, coat.eta());
        const auto distribution = distributionUnlessSmooth(
            {params_.roughness, params_.uRoughness, params_.vRoughness, params_.remapRoughness}, at);
        const bool isHazy = !isBlack(coat.haze);
        if (!distribution && !coat.distribution && !isHazy) {
            bsdf.add(CoatedMirror(coat.layer, base), weight);
        } else {
            const Rgb clear = Rgb(1.f) - coat.haze;
            coat.addReflection(weight, bsdf);
            bsdf.add(CoatedConductor(
                         coat.layer, coat.alpha(),
                         distribution.value_or(TrowbridgeReitz(TrowbridgeReitz::kMinAlpha, TrowbridgeReitz::kMinAlpha)),
                         base),
                     weight * clear * clear);
        }
        // Over metal, the haze's own reflection is a diffuse lobe.
        if (isHazy) bsdf.add(CoatedDiffuse(coat.haze, coat.layer), weight);
    }
    bool isConstant() const override {
        return coat_.areAllConstant() && index_.areAllConstant() &&
               areConstant(params_.roughness, params_.uRoughness, params_.vRoughness);
    }
    int maxLobes() const override { return 3; }

  private:
    CoatTextures coat_;
    CoatedConductorParams params_;
    ConductorTextures index_;
};

}  // namespace

MaterialPtr makeCoatedDiffuse(CoatedDiffuseParams params) {
    return std::make_shared<CoatedDiffuseMaterial>(std::move(params));
}

MaterialPtr makeCoatedConductor(CoatedConductorParams params) {
    return std::make_shared<CoatedConductorMaterial>(std::move(params));
}

}  // namespace drc
