#include "scene/materials/material_disney.h"

#include "scene/materials/material_params.h"

namespace drc {
namespace {

// Reflectance at normal incidence.
float reflectanceOf(float eta) { return sqr((eta - 1) / (eta + 1)); }

class Disney final : public Material {
  public:
    explicit Disney(DisneyParams params) : params_(std::move(params)) {
        params_.color = orConstant(params_.color, Rgb(0.5f));
        params_.metallic = orConstant(params_.metallic, 0);
        params_.eta = orConstant(params_.eta, 1.5f);
        params_.roughness = orConstant(params_.roughness, 0.5f);
        params_.specularTint = orConstant(params_.specularTint, 0);
        params_.anisotropic = orConstant(params_.anisotropic, 0);
        params_.sheen = orConstant(params_.sheen, 0);
        params_.sheenTint = orConstant(params_.sheenTint, 0.5f);
        params_.clearcoat = orConstant(params_.clearcoat, 0);
        params_.clearcoatGloss = orConstant(params_.clearcoatGloss, 1);
        params_.specTrans = orConstant(params_.specTrans, 0);
        params_.flatness = orConstant(params_.flatness, 0);
        params_.diffTrans = orConstant(params_.diffTrans, 1);
        setRelief(params_.relief);
    }
    void addLobes(const TextureContext& at, const Rgb& weight, Bsdf& bsdf) const override {
        const Rgb color = evalClamped(*params_.color, at);
        const float lum = luminance(color);
        const Rgb tint = lum > 0 ? color * (1 / lum) : Rgb(1.f);
        const float metallic = params_.metallic->eval(at), eta = params_.eta->eval(at);
        const float roughness = params_.roughness->eval(at), specTrans = params_.specTrans->eval(at);

        const float diffuse = std::max(0.f, (1 - metallic) * (1 - specTrans));
        // Half of diffTrans is transmitted, by thin surfaces only.
        const float through = params_.thin ? std::clamp(0.5f * params_.diffTrans->eval(at), 0.f, 1.f) : 0;
        if (diffuse > 0) {
            const Rgb reflected = color * (diffuse * (1 - through));
            const float flat = params_.thin ? params_.flatness->eval(at) : 0;
            const Rgb sheen = lerp(params_.sheenTint->eval(at), Rgb(1.f), tint) * params_.sheen->eval(at);
            const DisneyDiffuseColors base{.base = reflected * (1 - flat)};
            const DisneyDiffuseColors rest{.flat = reflected * flat,
                                           .retro = roughness != 0 ? color * diffuse : Rgb(0.f),
                                           .sheen = sheen * diffuse};
            for (const DisneyDiffuseColors& colors : {base, rest})
                if (!colors.areBlack()) bsdf.add(DisneyDiffuse(colors, roughness), weight);
        }

        const float aspect = safeSqrt(1 - 0.9f * params_.anisotropic->eval(at));
        const auto distribution = [&](float rough) {
            return TrowbridgeReitz(rough * rough / aspect, rough * rough * aspect, TrowbridgeReitz::Masking::Separable);
        };
        const Rgb dielectric = lerp(params_.specularTint->eval(at), Rgb(1.f), tint) * reflectanceOf(eta);
        // Total internal reflection applies only to the transmissive share. pbrt applies it to the whole highlight and
        // adds the diffuse part, which creates energy.
        const Fresnel fresnel =
            Fresnel::metallic(lerp(metallic, dielectric, color), metallic, eta, std::clamp(specTrans, 0.f, 1.f));
        bsdf.add(MicrofacetReflection(Rgb(1.f), distribution(roughness), fresnel), weight);

        const float clearcoat = params_.clearcoat->eval(at);
        if (clearcoat > 0)
            bsdf.add(DisneyClearcoat(clearcoat, lerp(params_.clearcoatGloss->eval(at), 0.1f, 0.001f)), weight);

        // The square root of the colour at each surface, because light crosses two surfaces on its way through an
        // object.
        const Rgb transmitted = sqrt(color) * std::max(0.f, (1 - metallic) * specTrans);
        if (!isBlack(transmitted)) {
            if (eta == 1)  // does not refract, however rough
                bsdf.add(SpecularTransmission(transmitted, 1, 1), weight);
            else if (params_.thin)  // Burley's fit: light leaves a sheet in a narrower lobe than a single boundary
                bsdf.add(MicrofacetTransmission(transmitted, thinDistribution(eta, roughness, aspect), 1, eta), weight);
            else
                bsdf.add(MicrofacetTransmission(transmitted, distribution(roughness), 1, eta), weight);
        }
        if (const Rgb back = color * (diffuse * through); !isBlack(back)) bsdf.add(LambertTransmission(back), weight);
    }

    bool isConstant() const override {
        return areConstant(params_.color, params_.metallic, params_.eta, params_.roughness, params_.specularTint,
                           params_.anisotropic, params_.sheen, params_.sheenTint, params_.clearcoat,
                           params_.clearcoatGloss, params_.specTrans, params_.flatness, params_.diffTrans);
    }
    int maxLobes() const override { return 6; }

  private:
    static TrowbridgeReitz thinDistribution(float eta, float roughness, float aspect) {
        const float rough = std::max(0.f, 0.65f * eta - 0.35f) * roughness;
        return TrowbridgeReitz(rough * rough / aspect, rough * rough * aspect);
    }

    DisneyParams params_;
};

}  // namespace

MaterialPtr makeDisney(DisneyParams params) { return std::make_shared<Disney>(std::move(params)); }

}  // namespace drc
