#include "scene/materials/material_matte.h"

#include "scene/materials/material_params.h"

namespace drc {
namespace {

class Matte final : public Material {
  public:
    explicit Matte(MatteParams params) : params_(std::move(params)) {
        params_.kd = orConstant(params_.kd, Rgb(0.5f));
        params_.sigma = orConstant(params_.sigma, 0);
        params_.roughness = orConstant(params_.roughness, 0);
        setRelief(params_.relief);
    }
    void addLobes(const TextureContext& at, const Rgb& weight, Bsdf& bsdf) const override {
        const Rgb kd = evalClamped(*params_.kd, at);
        if (isBlack(kd)) return;
        const float sigma = std::clamp(params_.sigma->eval(at), 0.f, 90.f);
        const float roughness = std::clamp(params_.roughness->eval(at), 0.f, 1.f);
        if (roughness > 0)
            for (const DiffusePart part : {DiffusePart::Separable, DiffusePart::Rest})
                bsdf.add(RoughDiffuse(kd, roughness, part), weight);
        else if (sigma == 0)
            bsdf.add(LambertReflection(kd), weight);
        else
            for (const DiffusePart part : {DiffusePart::Separable, DiffusePart::Rest})
                bsdf.add(OrenNayar(kd, sigma, part), weight);
    }

    bool isConstant() const override { return areConstant(params_.kd, params_.sigma, params_.roughness); }
    int maxLobes() const override {
        const auto isZero = [](const FloatTexturePtr& t) { return t->isConstant() && !(t->eval({}) > 0); };
        return isZero(params_.sigma) && isZero(params_.roughness) ? 1 : 2;
    }

  private:
    MatteParams params_;
};

}  // namespace

MaterialPtr makeMatte(MatteParams params) { return std::make_shared<Matte>(std::move(params)); }

}  // namespace drc
