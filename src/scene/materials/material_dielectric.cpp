#include "scene/materials/material_dielectric.h"

#include "scene/materials/material_params.h"

namespace drc {
namespace {

class DielectricMaterial final : public Material {
  public:
    explicit DielectricMaterial(DielectricParams params) : params_(std::move(params)) {
        params_.eta = orConstant(params_.eta, 1.5f);
        params_.roughness = orConstant(params_.roughness, 0);
        setRelief(params_.relief);
    }
    void addLobes(const TextureContext& at, const Rgb& weight, Bsdf& bsdf) const override {
        const float eta = params_.eta->eval(at);
        const auto distribution = distributionUnlessSmooth(
            {params_.roughness, params_.uRoughness, params_.vRoughness, params_.remapRoughness}, at);
        // A boundary between equal indices does not refract, however rough it is.
        if (!distribution || eta == 1) {
            bsdf.add(FresnelSpecular(Rgb(1.f), Rgb(1.f), 1, eta), weight);
            return;
        }
        bsdf.add(MicrofacetDielectric(Rgb(1.f), Rgb(1.f), *distribution, eta), weight);
    }

    bool isConstant() const override {
        return areConstant(params_.eta, params_.roughness, params_.uRoughness, params_.vRoughness);
    }
    int maxLobes() const override { return 1; }

  private:
    DielectricParams params_;
};

class ThinDielectricMaterial final : public Material {
  public:
    explicit ThinDielectricMaterial(ThinDielectricParams params) : eta_(orConstant(std::move(params.eta), 1.5f)) {
        setRelief(std::move(params.relief));
    }
    void addLobes(const TextureContext& at, const Rgb& weight, Bsdf& bsdf) const override {
        bsdf.add(ThinDielectric(eta_->eval(at)), weight);
    }
    bool isConstant() const override { return areConstant(eta_); }
    int maxLobes() const override { return 1; }

  private:
    FloatTexturePtr eta_;
};

}  // namespace

MaterialPtr makeDielectric(DielectricParams params) { return std::make_shared<DielectricMaterial>(std::move(params)); }

MaterialPtr makeThinDielectric(ThinDielectricParams params) {
    return std::make_shared<ThinDielectricMaterial>(std::move(params));
}

}  // namespace drc
