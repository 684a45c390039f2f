#include "scene/materials/material_conductor.h"

#include "scene/materials/conductor_textures.h"

namespace drc {
namespace {

class Conductor final : public Material {
  public:
    explicit Conductor(ConductorParams params)
        : params_(std::move(params)), index_(params_.eta, params_.k, params_.reflectance) {
        params_.roughness = orConstant(params_.roughness, 0);
        setRelief(params_.relief);
    }
    void addLobes(const TextureContext& at, const Rgb& weight, Bsdf& bsdf) const override {
        const Fresnel fresnel = index_.at(at);
        const auto distribution = distributionUnlessSmooth(
            {params_.roughness, params_.uRoughness, params_.vRoughness, params_.remapRoughness}, at);
        if (distribution)
            bsdf.add(MicrofacetReflection(Rgb(1.f), *distribution, fresnel), weight);
        else
            bsdf.add(SpecularReflection(Rgb(1.f), fresnel), weight);
    }

    bool isConstant() const override {
        return index_.areAllConstant() && areConstant(params_.roughness, params_.uRoughness, params_.vRoughness);
    }
    int maxLobes() const override { return 1; }

  private:
    ConductorParams params_;
    ConductorTextures index_;
};

}  // namespace

MaterialPtr makeConductor(ConductorParams params) { return std::make_shared<Conductor>(std::move(params)); }

}  // namespace drc
