#include "scene/materials/material_plastic.h"

#include "scene/materials/material_params.h"

namespace drc {
namespace {

class Plastic final : public Material {
  public:
    explicit Plastic(PlasticParams params) : params_(std::move(params)) {
        params_.kd = orConstant(params_.kd, Rgb(0.25f));
        params_.ks = orConstant(params_.ks, Rgb(0.25f));
        params_.roughness = orConstant(params_.roughness, 0.1f);
        setRelief(params_.relief);
    }
    void addLobes(const TextureContext& at, const Rgb& weight, Bsdf& bsdf) const override {
        const Rgb kd = evalClamped(*params_.kd, at);
        if (!isBlack(kd)) bsdf.add(LambertReflection(kd), weight);
        const Rgb ks = evalClamped(*params_.ks, at);
        if (isBlack(ks)) return;
        const float roughness = params_.roughness->eval(at);
        // pbrt passes the indices in this order, so that the highlight is that of the boundary seen from inside, with
        // total internal reflection beyond the critical angle. Scenes are tuned to this look.
        bsdf.add(MicrofacetReflection(ks, distributionFor(roughness, roughness, params_.remapRoughness),
                                      Fresnel::dielectric(1.5f, 1.f)),
                 weight);
    }

    bool isConstant() const override { return areConstant(params_.kd, params_.ks, params_.roughness); }
    int maxLobes() const override { return 2; }

  private:
    PlasticParams params_;
};

}  // namespace

MaterialPtr makePlastic(PlasticParams params) { return std::make_shared<Plastic>(std::move(params)); }

}  // namespace drc
