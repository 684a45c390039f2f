#include "scene/lobes/coated_conductor.h"

namespace drc {
namespace {

// Roughness alpha by which the base is widened to model the blur by a rough interface. Each of the two refractions
// deflects light by (1 - 1/eta) times the slope of a facet, a reflection by twice the slope.
float blurThrough(float eta, float coatAlpha) { return std::sqrt(0.5f) * (1 - 1 / eta) * coatAlpha; }

}  // namespace

CoatedConductor::CoatedConductor(const DielectricCoat& coat, float coatAlpha, const TrowbridgeReitz& distribution,
                                 const Fresnel& base)
    : coat_(coat), distribution_(distribution.widened(blurThrough(coat.eta(), coatAlpha))), base_(base) {
    alpha_ = distribution_.meanAlpha();
    // The constants, here and below, are fits to random walks. kept_ is the energy that single scattering off
    // microfacets conserves. trapped_ is 0 for eta = 1, because there is no critical angle.
    kept_ = 1 / (1 + 1.8f * sqr(alpha_));
    trapped_ = std::min(1.f, 1.8f * (1 - 1 / sqr(coat.eta())));
}

Vec3 CoatedConductor::refractIn(const Vec3& w) const {
    return Vec3(w.x / coat_.eta(), w.y / coat_.eta(), std::copysign(coat_.cosineInside(absCosTheta(w)), w.z));
}

float CoatedConductor::scatteredAway(float cosTheta) const {
    // Distance of the mirror direction from the critical angle, relative to the width of the reflection lobe.
    const float x = (1 - safeSqrt(1 - cosTheta * cosTheta)) / (coat_.eta() * 2.2f * alpha_);
    const float beyond = 0.4f * (1 - x / std::sqrt(1 + x * x));
    return lerp(std::min(1.f, 0.7f * sqr(alpha_)), beyond, 1);
}

float CoatedConductor::comesBack(float cosTheta) const {
    return kept_ * sqr(coat_.passed(coat_.cosineInside(cosTheta))) *
           lerp(scatteredAway(cosTheta), coat_.reflectance(cosTheta), trapped_);
}

LobeValue CoatedConductor::evaluate(const Vec3& wo, const Vec3& wi) const {
    if (!sameHemisphere(wo, wi)) return {};
    const Vec3 o = refractIn(wo), i = refractIn(wi);
    const Vec3 wh = normalize(o + i);
    const float d = distribution_.d(wh);
    const float inverseEta2 = 1 / sqr(coat_.eta());
    const Rgb fresnel = base_.eval(absDot(i, wh));
    const float cosO = absCosTheta(wo), cosI = absCosTheta(wi);
    const float once =
        d * distribution_.visibility(o, i) * inverseEta2 * coat_.transmittance(cosO) * coat_.transmittance(cosI);
    LobeValue value;
    // The first reflection off the base, and all further reflections between base and coat.
    const float again = 0.5f * (comesBack(cosO) + comesBack(cosI));
    for (int c = 0; c < 3; ++c) value.f[c] = once * fresnel[c] / (1 - fresnel[c] * again);
    // Refraction out of the coat widens solid angles.
    value.pdf = microfacetPdf(distribution_, o, i, d) * inverseEta2 * cosI / absCosTheta(i);
    return value;
}

LobeSample CoatedConductor::sample(const Vec3& wo, float, const Vec2& u, TransportMode) const {
    if (wo.z == 0) return {};
    const Vec3 o = refractIn(wo);
    const Vec3 wh = distribution_.sample(o, u);
    if (dot(o, wh) <= 0) return {};
    const Vec3 i = reflect(o, wh);
    if (!sameHemisphere(o, i)) return {};
    const float x = i.x * coat_.eta(), y = i.y * coat_.eta();
    const float cos2 = 1 - x * x - y * y;
    if (!(cos2 > 0)) return {};  // totally reflected inside the coat
    return sampleTowards(*this, wo, normalize(Vec3(x, y, std::copysign(std::sqrt(cos2), i.z))));
}

Rgb CoatedConductor::albedo(const Vec3& wo) const {
    const float c = absCosTheta(wo);
    const Rgb fresnel = base_.eval(coat_.cosineInside(c));
    const float out = lerp(scatteredAway(c), coat_.transmittance(c), 1 - trapped_);
    const float once = coat_.transmittance(c) * kept_ * out;
    const float again = comesBack(c);
    Rgb sum;
    for (int k = 0; k < 3; ++k) sum[k] = once * fresnel[k] / (1 - fresnel[k] * again);
    return sum;
}

Rgb CoatedMirror::albedo(const Vec3& wo) const {
    const float c = absCosTheta(wo);
    const float inside = coat_.cosineInside(c);
    const Rgb base = base_.eval(inside) * sqr(coat_.passed(inside));
    const float r = coat_.reflectance(c);
    // The series r + t base t + t base r base t + ..., with t = 1 - r.
    Rgb sum;
    for (int k = 0; k < 3; ++k) sum[k] = r + sqr(1 - r) * base[k] / std::max(1e-6f, 1 - r * base[k]);
    return sum;
}

}  // namespace drc
