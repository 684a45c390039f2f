#include "scene/materials/material_glass.h"

#include "scene/materials/material_params.h"

namespace drc {
namespace {

class Glass final : public Material {
  public:
    explicit Glass(GlassParams params) : params_(std::move(params)) {
        params_.kr = orConstant(params_.kr, Rgb(1.f));
        params_.kt = orConstant(params_.kt, Rgb(1.f));
        params_.eta = orConstant(params_.eta, 1.5f);
        params_.uRoughness = orConstant(params_.uRoughness, 0);
        params_.vRoughness = orConstant(params_.vRoughness, 0);
        setRelief(params_.relief);
    }
    void addLobes(const TextureContext& at, const Rgb& weight, Bsdf& bsdf) const override {
        const Rgb kr = evalClamped(*params_.kr, at), kt = evalClamped(*params_.kt, at);
        if (isBlack(kr) && isBlack(kt)) return;
        const float eta = params_.eta->eval(at);
        const float u = params_.uRoughness->eval(at), v = params_.vRoughness->eval(at);
        // A boundary between equal indices does not refract, however rough it is.
        if ((u == 0 && v == 0) || eta == 1) {
            bsdf.add(FresnelSpecular(kr, kt, 1, eta), weight);
            return;
        }
        const TrowbridgeReitz distribution = distributionFor(u, v, params_.remapRoughness);
        bsdf.add(MicrofacetDielectric(kr, kt, distribution, eta), weight);
    }

    bool isConstant() const override {
        return areConstant(params_.kr, params_.kt, params_.eta, params_.uRoughness, params_.vRoughness);
    }
    int maxLobes() const override { return 1; }

  private:
    GlassParams params_;
};

}  // namespace

MaterialPtr makeGlass(GlassParams params) { return std::make_shared<Glass>(std::move(params)); }

}  // namespace drc
