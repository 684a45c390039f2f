#include "scene/materials/material_metal.h"

#include "scene/materials/conductor_textures.h"

namespace drc {
namespace {

class Metal final : public Material {
  public:
    explicit Metal(MetalParams params) : params_(std::move(params)), index_(params_.eta, params_.k) {
        params_.roughness = orConstant(params_.roughness, 0.01f);
        setRelief(params_.relief);
    }
    void addLobes(const TextureContext& at, const Rgb& weight, Bsdf& bsdf) const override {
        const FloatTexture& u = params_.uRoughness ? *params_.uRoughness : *params_.roughness;
        const FloatTexture& v = params_.vRoughness ? *params_.vRoughness : *params_.roughness;
        bsdf.add(MicrofacetReflection(Rgb(1.f), distributionFor(u.eval(at), v.eval(at), params_.remapRoughness),
                                      index_.at(at)),
                 weight);
    }

    bool isConstant() const override {
        return index_.areAllConstant() && areConstant(params_.roughness, params_.uRoughness, params_.vRoughness);
    }
    int maxLobes() const override { return 1; }

  private:
    MetalParams params_;
    ConductorTextures index_;
};

}  // namespace

MaterialPtr makeMetal(MetalParams params) { return std::make_shared<Metal>(std::move(params)); }

}  // namespace drc
