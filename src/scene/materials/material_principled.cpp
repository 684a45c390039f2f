#include "scene/materials/material_principled.h"

#include "scene/lobes/sheen_albedo.h"
#include "scene/materials/material_params.h"

namespace drc {
namespace {

Rgb clampUnit(const Rgb& c) {
    return Rgb(std::clamp(c.x, 0.f, 1.f), std::clamp(c.y, 0.f, 1.f), std::clamp(c.z, 0.f, 1.f));
}
// A curve's complement: 1 - share * curve.
CosineCurve rest(const CosineCurve& curve, float share) {
    CosineCurve passed;
    for (int i = 0; i < CosineCurve::kNodes; ++i) passed[i] = 1 - share * curve[i];
    return passed;
}

float atNormalOf(float eta) { return sqr((eta - 1) / (eta + 1)); }
float indexOf(float atNormal) {
    const float root = std::sqrt(std::min(0.99f, atNormal));
    return (1 + root) / (1 - root);
}

// The distribution of microfacets for a roughness; none if alpha is so small that the surface counts as smooth.
std::optional<TrowbridgeReitz> distributionOf(float roughness, float anisotropic = 0) {
    const float alpha = sqr(roughness), aspect = std::sqrt(1 - 0.9f * anisotropic);
    if (alpha < TrowbridgeReitz::kMinAlpha) return std::nullopt;
    return TrowbridgeReitz(alpha / aspect, alpha * aspect);
}

// The parameters at one point, clamped to their ranges.
struct Point {
    Rgb baseColor, specularTint, reflectionTint, coatTint, sheenTint;
    float metallic, roughness, diffuseRoughness, ior, specularLevel, anisotropic, rotation, transmission, coat,
        coatRoughness, coatIor, sheen, sheenRoughness, subsurface;
};

class Emitted final : public RgbTexture {
  public:
    Emitted(RgbTexturePtr colour, FloatTexturePtr strength)
        : colour_(std::move(colour)), strength_(std::move(strength)) {}
    Rgb eval(const TextureContext& at) const override {
        return clampNonNegative(colour_->eval(at)) * std::max(0.f, strength_->eval(at));
    }
    bool isConstant() const override { return areConstant(colour_, strength_); }

  private:
    RgbTexturePtr colour_;
    FloatTexturePtr strength_;
};

class Principled final : public Material {
  public:
    explicit Principled(PrincipledParams params) : params_(std::move(params)) {
        PrincipledParams& p = params_;
        p.baseColor = orConstant(p.baseColor, Rgb(0.8f));
        p.metallic = orConstant(p.metallic, 0);
        p.roughness = orConstant(p.roughness, 0.5f);
        p.diffuseRoughness = orConstant(p.diffuseRoughness, 0);
        p.ior = orConstant(p.ior, 1.5f);
        p.specularLevel = orConstant(p.specularLevel, 0.5f);
        p.specularTint = orConstant(p.specularTint, Rgb(1.f));
        p.anisotropic = orConstant(p.anisotropic, 0);
        p.anisotropicRotation = orConstant(p.anisotropicRotation, 0);
        p.transmission = orConstant(p.transmission, 0);
        p.reflectionTint = orConstant(p.reflectionTint, Rgb(1.f));
        p.coat = orConstant(p.coat, 0);
        p.coatRoughness = orConstant(p.coatRoughness, 0.03f);
        p.coatIor = orConstant(p.coatIor, 1.5f);
        p.coatTint = orConstant(p.coatTint, Rgb(1.f));
        p.sheen = orConstant(p.sheen, 0);
        p.sheenRoughness = orConstant(p.sheenRoughness, 0.5f);
        p.sheenTint = orConstant(p.sheenTint, Rgb(1.f));
        p.subsurface = orConstant(p.subsurface, 0);
        setRelief(p.relief);
        if (p.alpha && !(p.alpha->isConstant() && p.alpha->eval({}) >= 1)) setOpacity(p.alpha);
        const auto emission =
            std::make_shared<Emitted>(orConstant(p.emission, Rgb(1.f)), orConstant(p.emissionStrength, 0));
        if (!(emission->isConstant() && isBlack(emission->eval({})))) setEmission(emission);
    }

    void addLobes(const TextureContext& at, const Rgb& weight, Bsdf& bsdf) const override {
        const Point point = pointAt(at);
        LayersAbove above;
        addSheen(point, weight, bsdf, above);
        addCoat(point, weight, bsdf, above);
        addMetal(point, weight * point.metallic, bsdf, above);
        const Rgb dielectric = weight * (1 - point.metallic);
        addGlass(point, dielectric * point.transmission, bsdf, above);
        addBase(point, dielectric * (1 - point.transmission), bsdf, above);
    }

    bool isConstant() const override {
        const PrincipledParams& p = params_;
        return areConstant(p.baseColor, p.metallic, p.roughness, p.diffuseRoughness, p.ior, p.specularLevel,
                           p.specularTint, p.anisotropic, p.anisotropicRotation, p.transmission, p.reflectionTint,
                           p.coat, p.coatRoughness, p.coatIor, p.coatTint, p.sheen, p.sheenRoughness, p.sheenTint,
                           p.subsurface);
    }
    int maxLobes() const override {
        const auto may = [](const FloatTexturePtr& t, float without) {
            return !t->isConstant() || std::clamp(t->eval({}), 0.f, 1.f) != without;
        };
        const bool metal = may(params_.metallic, 0), dielectric = may(params_.metallic, 1);
        const bool glass = dielectric && may(params_.transmission, 0);
        const bool base = dielectric && may(params_.transmission, 1);
        const bool through = base && params_.thinWall && may(params_.subsurface, 0);
        const RgbTexture& tint = *params_.specularTint;
        const bool glassHasTwo = params_.thinWall || !tint.isConstant() || clampUnit(tint.eval({})) != Rgb(1.f);
        return may(params_.sheen, 0) + may(params_.coat, 0) + metal + glass + (glass && glassHasTwo) + 2 * base +
               (base && may(params_.diffuseRoughness, 0)) + through;
    }

  private:
    Point pointAt(const TextureContext& at) const {
        const PrincipledParams& p = params_;
        const auto unit = [&](const FloatTexturePtr& t) { return std::clamp(t->eval(at), 0.f, 1.f); };
        const auto colour = [&](const RgbTexturePtr& t) { return clampUnit(t->eval(at)); };
        const auto index = [&](const FloatTexturePtr& t) { return std::clamp(t->eval(at), 0.01f, 100.f); };
        Point point;
        point.baseColor = colour(p.baseColor);
        point.metallic = unit(p.metallic);
        point.roughness = unit(p.roughness);
        point.diffuseRoughness = unit(p.diffuseRoughness);
        point.ior = index(p.ior);
        point.specularLevel = std::max(0.f, p.specularLevel->eval(at));
        point.specularTint = colour(p.specularTint);
        point.anisotropic = unit(p.anisotropic);
        point.rotation = p.anisotropicRotation->eval(at);
        point.transmission = unit(p.transmission);
        point.reflectionTint = colour(p.reflectionTint);
        point.coat = unit(p.coat);
        point.coatRoughness = unit(p.coatRoughness);
        point.coatIor = std::max(1.f, index(p.coatIor));
        point.coatTint = colour(p.coatTint);
        point.sheen = unit(p.sheen);
        point.sheenRoughness = unit(p.sheenRoughness);
        point.sheenTint = colour(p.sheenTint);
        point.subsurface = unit(p.subsurface);
        return point;
    }

    static void addSheen(const Point& point, const Rgb& weight, Bsdf& bsdf, LayersAbove& above) {
        const Rgb sheen = point.sheenTint * point.sheen;
        if (isBlack(sheen)) return;
        const CosineCurve albedo = sheenAlbedo(point.sheenRoughness);
        bsdf.add(LayeredDiffuse(sheen, albedo), weight);
        above.add(rest(albedo, maxComponent(sheen)));
    }

    static void addCoat(const Point& point, const Rgb& weight, Bsdf& bsdf, LayersAbove& above) {
        if (point.coat == 0) return;
        const float eta = point.coatIor, atNormal = atNormalOf(eta);
        const auto distribution = distributionOf(point.coatRoughness);
        const float alpha = distribution ? distribution->meanAlpha() : 0;
        if (eta > 1) {
            addReflection(distribution, Fresnel::coat(eta), meanDielectricFresnel(eta, Rgb(atNormal)), {}, above,
                          weight * point.coat, bsdf);
            above.add(rest(dielectricAlbedo(alpha, eta, atNormal), point.coat));
        }
        above.colour = CoatColour(point.coatTint, eta, point.coat);
    }

    static void addMetal(const Point& point, const Rgb& weight, Bsdf& bsdf, const LayersAbove& above) {
        if (isBlack(weight)) return;
        const Fresnel fresnel = Fresnel::metalWithEdge(point.baseColor, point.specularTint);
        addReflection(distributionOf(point.roughness, point.anisotropic), fresnel, fresnel.meanOfMetalWithEdge(),
                      LobeTurn(point.rotation), above, weight, bsdf);
    }

    void addGlass(const Point& point, const Rgb& weight, Bsdf& bsdf, const LayersAbove& above) const {
        if (isBlack(weight)) return;
        const float eta = point.ior;
        const Rgb atNormal = point.specularTint * atNormalOf(eta);
        const auto distribution = distributionOf(point.roughness);
        if (params_.thinWall) {
            addSheet(point, atNormal, distribution, weight, bsdf, above);
            return;
        }
        // The square root of the colour at each surface, because light crosses two surfaces on its way through an
        // object.
        const Rgb transmittance = sqrt(point.baseColor);
        const bool isTinted = point.specularTint != Rgb(1.f);
        const Fresnel fresnel =
            isTinted ? Fresnel::tinted(atNormal, eta, Fresnel::Of::Boundary) : Fresnel::dielectric(1, eta);
        if (distribution && eta != 1) {
            bsdf.add(LayeredLobe(MicrofacetDielectric(point.reflectionTint, transmittance, *distribution, eta, fresnel),
                                 above, MultipleScattering::ofBoundary(distribution->meanAlpha(), eta, transmittance)),
                     weight);
        } else if (isTinted) {
            bsdf.add(LayeredLobe(SpecularReflection(point.reflectionTint, fresnel), above), weight);
            bsdf.add(LayeredLobe(SpecularTransmission(transmittance, 1, eta), above), weight);
        } else {
            bsdf.add(LayeredLobe(FresnelSpecular(point.reflectionTint, transmittance, 1, eta), above), weight);
        }
    }

    static void addSheet(const Point& point, const Rgb& atNormal, const std::optional<TrowbridgeReitz>& distribution,
                         const Rgb& weight, Bsdf& bsdf, const LayersAbove& above) {
        if (!distribution) {
            bsdf.add(LayeredLobe(ThinDielectric(point.ior, point.baseColor), above), weight);
            return;
        }
        const Fresnel fresnel = Fresnel::tinted(atNormal, point.ior, Fresnel::Of::Sheet);
        const Rgb mean = meanDielectricFresnel(point.ior, atNormal);
        addReflection(distribution, fresnel, mean, {}, above, weight, bsdf);
        // Burley's fit: light leaves a sheet in a narrower lobe than a single boundary.
        const float eta = std::max(point.ior, 1 / point.ior);
        const float through = std::clamp(0.65f * eta - 0.35f, 0.05f, 1.f) * point.roughness;
        const TrowbridgeReitz blur(sqr(through), sqr(through));
        bsdf.add(LayeredLobe(SheetTransmission(point.baseColor, blur, point.ior), above,
                             MultipleScattering::ofReflection(blur.meanAlpha(), Rgb(1.f))),
                 weight);
    }

    void addBase(const Point& point, const Rgb& weight, Bsdf& bsdf, LayersAbove above) const {
        if (isBlack(weight)) return;
        const float atNormal = std::min(0.99f, atNormalOf(point.ior) * 2 * point.specularLevel);
        const Rgb tinted = point.specularTint * atNormal;
        if (atNormal > 0) {
            const float eta = indexOf(atNormal);
            const auto distribution = distributionOf(point.roughness, point.anisotropic);
            addReflection(distribution, Fresnel::tinted(tinted, eta, Fresnel::Of::Coat),
                          meanDielectricFresnel(eta, tinted), LobeTurn(point.rotation), above, weight, bsdf);
            above.add(
                rest(dielectricAlbedo(distribution ? distribution->meanAlpha() : 0, eta, maxComponent(tinted)), 1));
        }
        const float through = params_.thinWall ? 0.5f * point.subsurface : 0;
        const Rgb reflected = point.baseColor * (1 - through);
        if (point.diffuseRoughness > 0)
            for (const DiffusePart part : {DiffusePart::Separable, DiffusePart::Rest})
                bsdf.add(LayeredDiffuse::rough(reflected, point.diffuseRoughness, above, part), weight);
        else
            bsdf.add(LayeredDiffuse(reflected, above), weight);
        if (through > 0)
            bsdf.add(LayeredDiffuse(point.baseColor * through, above, LayeredDiffuse::Side::Transmits), weight);
    }

    static void addReflection(const std::optional<TrowbridgeReitz>& distribution, const Fresnel& fresnel,
                              const Rgb& meanFresnel, const LobeTurn& turn, const LayersAbove& above, const Rgb& weight,
                              Bsdf& bsdf) {
        if (distribution)
            bsdf.add(LayeredLobe(MicrofacetReflection(Rgb(1.f), *distribution, fresnel), above,
                                 MultipleScattering::ofReflection(distribution->meanAlpha(), meanFresnel), turn),
                     weight);
        else
            bsdf.add(LayeredLobe(SpecularReflection(Rgb(1.f), fresnel), above), weight);
    }

    PrincipledParams params_;
};

}  // namespace

MaterialPtr makePrincipled(PrincipledParams params) { return std::make_shared<Principled>(std::move(params)); }

}  // namespace drc
