#include "scene/materials/material_translucent.h"

#include "scene/materials/material_params.h"

namespace drc {
namespace {

constexpr float kEta = 1.5f;

class Translucent final : public Material {
  public:
    explicit Translucent(TranslucentParams params) : params_(std::move(params)) {
        params_.kd = orConstant(params_.kd, Rgb(0.25f));
        params_.ks = orConstant(params_.ks, Rgb(0.25f));
        params_.reflect = orConstant(params_.reflect, Rgb(0.5f));
        params_.transmit = orConstant(params_.transmit, Rgb(0.5f));
        params_.roughness = orConstant(params_.roughness, 0.1f);
        setRelief(params_.relief);
    }
    void addLobes(const TextureContext& at, const Rgb& weight, Bsdf& bsdf) const override {
        const Rgb r = evalClamped(*params_.reflect, at), t = evalClamped(*params_.transmit, at);
        if (isBlack(r) && isBlack(t)) return;
        const Rgb kd = evalClamped(*params_.kd, at);
        if (!isBlack(r * kd)) bsdf.add(LambertReflection(r * kd), weight);
        if (!isBlack(t * kd)) bsdf.add(LambertTransmission(t * kd), weight);
        const Rgb ks = evalClamped(*params_.ks, at);
        if (isBlack(ks)) return;
        const float roughness = params_.roughness->eval(at);
        const TrowbridgeReitz distribution = distributionFor(roughness, roughness, params_.remapRoughness);
        if (!isBlack(r * ks))
            bsdf.add(MicrofacetReflection(r * ks, distribution, Fresnel::dielectric(1, kEta)), weight);
        if (!isBlack(t * ks)) bsdf.add(MicrofacetTransmission(t * ks, distribution, 1, kEta), weight);
    }

    bool isConstant() const override {
        return areConstant(params_.kd, params_.ks, params_.reflect, params_.transmit, params_.roughness);
    }
    int maxLobes() const override { return 4; }

  private:
    TranslucentParams params_;
};

}  // namespace

MaterialPtr makeTranslucent(TranslucentParams params) { return std::make_shared<Translucent>(std::move(params)); }

}  // namespace drc
