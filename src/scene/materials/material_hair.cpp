#include "scene/materials/material_hair.h"

#include "scene/materials/material_params.h"

namespace drc {
namespace {

class Hair final : public Material {
  public:
    explicit Hair(HairParams params) : params_(std::move(params)) {
        const bool pigments = params_.eumelanin || params_.pheomelanin;
        params_.eumelanin = orConstant(params_.eumelanin, pigments ? 0 : 1.3f);
        params_.pheomelanin = orConstant(params_.pheomelanin, 0);
        params_.eta = orConstant(params_.eta, 1.55f);
        params_.betaM = orConstant(params_.betaM, 0.3f);
        params_.betaN = orConstant(params_.betaN, 0.3f);
        params_.alpha = orConstant(params_.alpha, 2);
        setRelief(params_.relief);
    }
    void addLobes(const TextureContext& at, const Rgb& weight, Bsdf& bsdf) const override {
        const HairScattering::Shape shape{.eta = params_.eta->eval(at),
                                          .betaM = params_.betaM->eval(at),
                                          .betaN = params_.betaN->eval(at),
                                          .alphaDegrees = params_.alpha->eval(at)};
        bsdf.add(HairScattering(2 * at.uv.y - 1, absorption(at, shape.betaN), shape), weight);
    }

    // The lobe varies across the fibre, even if all parameters are constant.
    bool isConstant() const override { return false; }
    int maxLobes() const override { return 1; }

  private:
    Rgb absorption(const TextureContext& at, float betaN) const {
        if (params_.sigmaA) return evalClamped(*params_.sigmaA, at);
        if (params_.color) return hairAbsorptionOfColor(evalClamped(*params_.color, at), betaN);
        return hairAbsorptionOfPigments(std::max(0.f, params_.eumelanin->eval(at)),
                                        std::max(0.f, params_.pheomelanin->eval(at)));
    }

    HairParams params_;
};

}  // namespace

Rgb hairAbsorptionOfPigments(float eumelanin, float pheomelanin) {
    return Rgb(0.419f, 0.697f, 1.37f) * eumelanin + Rgb(0.187f, 0.4f, 1.05f) * pheomelanin;
}

Rgb hairAbsorptionOfColor(const Rgb& color, float betaN) {
    const float b = std::clamp(betaN, 0.f, 1.f);
    const float fit = 5.969f + b * (-0.215f + b * (2.532f + b * (-10.73f + b * (5.574f + b * 0.245f))));
    Rgb sigma;
    // Clamped, since black would need infinite absorption.
    for (int c = 0; c < 3; ++c) sigma[c] = sqr(std::log(std::clamp(color[c], 1e-4f, 1.f)) / fit);
    return sigma;
}

MaterialPtr makeHair(HairParams params) { return std::make_shared<Hair>(std::move(params)); }

}  // namespace drc
