#include "scene/materials/material_mix.h"

#include "scene/materials/material_params.h"

namespace drc {
namespace {

class Mix final : public Material {
  public:
    explicit Mix(MixParams params) : params_(std::move(params)) {
        params_.amount = orConstant(params_.amount, Rgb(0.5f));
    }
    void addLobes(const TextureContext& at, const Rgb& weight, Bsdf& bsdf) const override {
        const Rgb first = evalClamped(*params_.amount, at);
        const Rgb second = clampNonNegative(Rgb(1.f) - first);
        if (!isBlack(first)) params_.first->addLobes(at, weight * first, bsdf);
        if (!isBlack(second)) params_.second->addLobes(at, weight * second, bsdf);
    }
    bool isConstant() const override {
        return areConstant(params_.amount) && params_.first->isConstant() && params_.second->isConstant();
    }
    int maxLobes() const override { return params_.first->maxLobes() + params_.second->maxLobes(); }
    const Relief& relief() const override { return params_.first->relief(); }

  private:
    MixParams params_;
};

}  // namespace

MaterialPtr makeMix(MixParams params) { return std::make_shared<Mix>(std::move(params)); }

}  // namespace drc
