#include "scene/materials/material_substrate.h"

#include "scene/materials/material_params.h"

namespace drc {
namespace {

class Substrate final : public Material {
  public:
    explicit Substrate(SubstrateParams params) : params_(std::move(params)) {
        params_.kd = orConstant(params_.kd, Rgb(0.5f));
        params_.ks = orConstant(params_.ks, Rgb(0.5f));
        params_.uRoughness = orConstant(params_.uRoughness, 0.1f);
        params_.vRoughness = orConstant(params_.vRoughness, 0.1f);
        setRelief(params_.relief);
    }
    void addLobes(const TextureContext& at, const Rgb& weight, Bsdf& bsdf) const override {
        const Rgb kd = evalClamped(*params_.kd, at), ks = evalClamped(*params_.ks, at);
        if (isBlack(kd) && isBlack(ks)) return;
        const float u = params_.uRoughness->eval(at), v = params_.vRoughness->eval(at);
        if (!isBlack(kd)) bsdf.add(FresnelBlendBase(kd, ks), weight);
        bsdf.add(FresnelBlendCoat(ks, distributionFor(u, v, params_.remapRoughness)), weight);
    }

    bool isConstant() const override {
        return areConstant(params_.kd, params_.ks, params_.uRoughness, params_.vRoughness);
    }
    int maxLobes() const override { return 2; }

  private:
    SubstrateParams params_;
};

}  // namespace

MaterialPtr makeSubstrate(SubstrateParams params) { return std::make_shared<Substrate>(std::move(params)); }

}  // namespace drc
