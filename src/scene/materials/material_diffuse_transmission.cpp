#include "scene/materials/material_diffuse_transmission.h"

#include "scene/materials/material_params.h"

namespace drc {
namespace {

class DiffuseTransmission final : public Material {
  public:
    explicit DiffuseTransmission(DiffuseTransmissionParams params) : params_(std::move(params)) {
        params_.reflectance = orConstant(params_.reflectance, Rgb(0.25f));
        params_.transmittance = orConstant(params_.transmittance, Rgb(0.25f));
        setRelief(params_.relief);
    }
    void addLobes(const TextureContext& at, const Rgb& weight, Bsdf& bsdf) const override {
        const Rgb r = evalClamped(*params_.reflectance, at) * params_.scale;
        const Rgb t = evalClamped(*params_.transmittance, at) * params_.scale;
        if (!isBlack(r)) bsdf.add(LambertReflection(r), weight);
        if (!isBlack(t)) bsdf.add(LambertTransmission(t), weight);
    }
    bool isConstant() const override { return areConstant(params_.reflectance, params_.transmittance); }
    int maxLobes() const override { return 2; }

  private:
    DiffuseTransmissionParams params_;
};

}  // namespace

MaterialPtr makeDiffuseTransmission(DiffuseTransmissionParams params) {
    return std::make_shared<DiffuseTransmission>(std::move(params));
}

}  // namespace drc
