#include "scene/materials/material_subsurface.h"

#include "scene/lobes/half_space_albedo.h"
#include "scene/materials/material_params.h"

namespace drc {
namespace {

class Subsurface final : public Material {
  public:
    explicit Subsurface(SubsurfaceParams params) : params_(std::move(params)) {
        constexpr float kMostG = 0.99f;
        params_.sigmaA = orConstant(params_.sigmaA, Rgb(0.0011f, 0.0024f, 0.014f));
        params_.sigmaS = orConstant(params_.sigmaS, Rgb(2.55f, 3.21f, 3.77f));
        params_.kr = orConstant(params_.kr, Rgb(1.f));
        params_.kt = orConstant(params_.kt, Rgb(1.f));
        params_.roughness = orConstant(params_.roughness, 0);
        params_.eta = std::max(1.f, params_.eta);
        if (!params_.reflectance) share_ = halfSpaceAlbedo(std::clamp(params_.g, -kMostG, kMostG), params_.eta);
        setRelief(params_.relief);
    }
    void addLobes(const TextureContext& at, const Rgb& weight, Bsdf& bsdf) const override {
        const Rgb kr = evalClamped(*params_.kr, at), kt = evalClamped(*params_.kt, at);
        const std::optional<TrowbridgeReitz> distribution = distributionAt(at);
        if (!isBlack(kr) && params_.eta > 1) {
            if (distribution)
                bsdf.add(MicrofacetReflection(kr, *distribution, Fresnel::coat(params_.eta)), weight);
            else
                bsdf.add(SpecularReflection(kr, Fresnel::coat(params_.eta)), weight);
        }
        const Rgb share = shareAt(at);
        if (isBlack(kt) || isBlack(share)) return;
        // The reflectance of a diffuse base for which the same share of the entered light leaves again. The boundary
        // returns the part `back` of the light that the base scatters.
        const DielectricCoat coat(params_.eta, distribution ? distribution->meanAlpha() : 0, 0);
        const float back = coat.internalReflectance();
        Rgb base;
        for (int c = 0; c < 3; ++c) base[c] = share[c] / (1 - back + share[c] * back);
        bsdf.add(CoatedDiffuse(base, coat), weight * kt);
    }
    bool isConstant() const override {
        return areConstant(params_.sigmaA, params_.sigmaS, params_.reflectance, params_.kr, params_.kt,
                           params_.roughness, params_.uRoughness, params_.vRoughness);
    }
    int maxLobes() const override { return 2; }

  private:
    std::optional<TrowbridgeReitz> distributionAt(const TextureContext& at) const {
        if (params_.scale != SubsurfaceParams::Roughness::Mapped)
            return distributionUnlessSmooth({params_.roughness, params_.uRoughness, params_.vRoughness,
                                             params_.scale == SubsurfaceParams::Roughness::Squared},
                                            at);
        const auto of = [&](const FloatTexturePtr& own) { return (own ? own : params_.roughness)->eval(at); };
        const float u = of(params_.uRoughness), v = of(params_.vRoughness);
        return u == 0 && v == 0 ? std::nullopt : std::optional(distributionFor(u, v, true));
    }
    // Share of the entered light that leaves again.
    Rgb shareAt(const TextureContext& at) const {
        Rgb share;
        if (params_.reflectance) {
            const Rgb given = evalClamped(*params_.reflectance, at);
            for (int c = 0; c < 3; ++c) share[c] = std::min(1.f, given[c]);
            return share;
        }
        const Rgb absorbed = evalClamped(*params_.sigmaA, at), scattered = evalClamped(*params_.sigmaS, at);
        for (int c = 0; c < 3; ++c) {
            const float both = absorbed[c] + scattered[c];
            share[c] = both > 0 ? (*share_)(scattered[c] / both) : 0;
        }
        return share;
    }

    SubsurfaceParams params_;
    std::shared_ptr<const HalfSpaceAlbedo> share_;  // null if params_.reflectance is set
};

}  // namespace

MaterialPtr makeSubsurface(SubsurfaceParams params) { return std::make_shared<Subsurface>(std::move(params)); }

}  // namespace drc
