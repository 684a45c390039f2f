#include "scene/materials/material_uber.h"

#include "scene/materials/material_params.h"

namespace drc {
namespace {

class Uber final : public Material {
  public:
    explicit Uber(UberParams params) : params_(std::move(params)) {
        params_.kd = orConstant(params_.kd, Rgb(0.25f));
        params_.ks = orConstant(params_.ks, Rgb(0.25f));
        params_.kr = orConstant(params_.kr, Rgb(0.f));
        params_.kt = orConstant(params_.kt, Rgb(0.f));
        params_.opacity = orConstant(params_.opacity, Rgb(1.f));
        params_.roughness = orConstant(params_.roughness, 0.1f);
        params_.eta = orConstant(params_.eta, 1.5f);
        setRelief(params_.relief);
    }
    void addLobes(const TextureContext& at, const Rgb& weight, Bsdf& bsdf) const override {
        const float eta = params_.eta->eval(at);
        const Rgb opacity = evalClamped(*params_.opacity, at);
        const Rgb straight = clampNonNegative(Rgb(1.f) - opacity);
        if (!isBlack(straight)) bsdf.add(SpecularTransmission(straight, 1, 1), weight);
        const Rgb kd = opacity * evalClamped(*params_.kd, at);
        if (!isBlack(kd)) bsdf.add(LambertReflection(kd), weight);
        // An index of 1 reflects nothing. The lobes are left out, because lobes that are always zero would still be
        // sampled now and then.
        const bool reflects = eta != 1;
        const Rgb ks = reflects ? opacity * evalClamped(*params_.ks, at) : Rgb(0.f);
        if (!isBlack(ks)) {
            const float u = (params_.uRoughness ? *params_.uRoughness : *params_.roughness).eval(at);
            const float v = params_.vRoughness ? params_.vRoughness->eval(at) : u;
            bsdf.add(
                MicrofacetReflection(ks, distributionFor(u, v, params_.remapRoughness), Fresnel::dielectric(1, eta)),
                weight);
        }
        const Rgb kr = reflects ? opacity * evalClamped(*params_.kr, at) : Rgb(0.f);
        if (!isBlack(kr)) bsdf.add(SpecularReflection(kr, Fresnel::dielectric(1, eta)), weight);
        const Rgb kt = opacity * evalClamped(*params_.kt, at);
        if (!isBlack(kt)) bsdf.add(SpecularTransmission(kt, 1, eta), weight);
    }

    bool isConstant() const override {
        return areConstant(params_.kd, params_.ks, params_.kr, params_.kt, params_.opacity, params_.roughness,
                           params_.uRoughness, params_.vRoughness, params_.eta);
    }
    int maxLobes() const override { return 5; }

  private:
    UberParams params_;
};

}  // namespace

MaterialPtr makeUber(UberParams params) { return std::make_shared<Uber>(std::move(params)); }

}  // namespace drc
