#include "scene/lobes/hair_scattering.h"

#include "math/warp.h"
#include "scene/lobes/fresnel.h"
#include "scene/lobes/local_directions.h"

namespace drc {
namespace {

float clampedRoughness(float beta) { return std::clamp(beta, 0.01f, 1.f); }

float power(float x, int n) {
    float result = 1;
    for (; n > 0; n /= 2, x *= x)
        if (n % 2) result *= x;
    return result;
}

// exp(-x) I0(x), the modified Bessel function of order zero, for x >= 0 (Abramowitz and Stegun, 9.8.1 and 9.8.2).
float scaledBesselI0(float x) {
    const float t = x * (1 / 3.75f);
    if (t < 1) {
        const float y = t * t;
        const float series =
            1 + y * (3.5156229f +
                     y * (3.0899424f + y * (1.2067492f + y * (0.2659732f + y * (0.0360768f + y * 0.0045813f)))));
        return std::exp(-x) * series;
    }
    const float y = 1 / t;
    float sum = 0.00392377f;
    for (const float c :
         {-0.01647633f, 0.02635537f, -0.02057706f, 0.00916281f, -0.00157565f, 0.00225319f, 0.01328592f, 0.39894228f})
        sum = sum * y + c;
    return sum / std::sqrt(x);
}

// Longitudinal distribution of variance v, by d'Eon: its product with cos theta_i integrates to one over theta_i. sinO
// and cosO are those of theta_o after the tilt by the scales; the lobe is centred on theta_i = -theta_o.
float alongFibre(float cosI, float cosO, float sinI, float sinO, float v) {
    // (cos (theta_i + theta_o) - 1) / v without the cancellation that narrow lobes would suffer.
    const float exponent = -0.5f * (sqr(cosI - cosO) + sqr(sinI + sinO)) / v;
    return std::exp(exponent) * scaledBesselI0(cosI * cosO / v) / (v * (1 - std::exp(-2 / v)));
}

float logistic(float x, float s) {
    const float e = std::exp(-std::abs(x) / s);
    return e / (s * sqr(1 + e));
}
float logisticCdf(float x, float s) { return 1 / (1 + std::exp(-x / s)); }

// Change of azimuth, in radians, of a ray in the normal plane; p is its number of passages through the fibre.
float turn(int p, float gammaO, float gammaT) { return float(2 * p) * gammaT - 2 * gammaO + float(p) * kPi; }

// Azimuthal distribution: logistic of scale s, truncated to [-pi, pi]. phi is the azimuth relative to turn().
float aroundFibre(float phi, float s) {
    phi = std::remainder(phi, 2 * kPi);
    return logistic(phi, s) / (2 * logisticCdf(kPi, s) - 1);
}
float sampleAroundFibre(float u, float s) {
    const float low = logisticCdf(-kPi, s);
    const float c = lerp(u, low, 1 - low);
    return std::clamp(-s * std::log(1 / c - 1), -kPi, kPi);
}

}  // namespace

struct HairScattering::Outgoing {
    float sin, cos, phi;   // sine and cosine of the longitudinal angle; azimuth
    float gammaO, gammaT;  // angles to the cylinder's normal in the normal plane, outside and inside
    std::array<Rgb, kLobes> attenuation;
    std::array<float, kLobes> probability;

    Outgoing(const HairScattering& hair, const Vec3& wo)
        : sin(wo.x), cos(safeSqrt(1 - wo.x * wo.x)), phi(std::atan2(wo.z, wo.y)) {
        // In the normal plane, light refracts by an index that grows with the longitudinal angle (Marschner's eta').
        const float sinGammaT =
            std::clamp(hair.h_ * cos / std::sqrt(std::max(1e-6f, sqr(hair.eta_) - sin * sin)), -1.f, 1.f);
        gammaO = std::asin(hair.h_);
        gammaT = std::asin(sinGammaT);
        const float cosThetaT = safeSqrt(1 - sqr(sin / hair.eta_));
        const float length = 2 * safeSqrt(1 - sqr(sinGammaT)) / std::max(1e-4f, cosThetaT);  // of a passage, in radii
        const Rgb passed = exp(hair.absorption_ * -length);

        const float fresnel = fresnelDielectric(cos * safeSqrt(1 - sqr(hair.h_)), 1, hair.eta_);
        attenuation[0] = Rgb(fresnel);
        attenuation[1] = passed * sqr(1 - fresnel);
        attenuation[2] = attenuation[1] * passed * fresnel;
        for (int c = 0; c < 3; ++c) {
            const float kept = passed[c] * fresnel;  // per further internal reflection: a geometric series
            attenuation[3][c] = kept < 1 ? attenuation[2][c] * kept / (1 - kept) : 0;
        }
        float sum = 0;
        for (int p = 0; p < kLobes; ++p) sum += probability[size_t(p)] = luminance(attenuation[size_t(p)]);
        // If the fibre absorbs everything (index 1, and black), all probabilities are 0.
        for (float& p : probability) p = sum > 0 ? p / sum : 0;
    }
};

HairScattering::HairScattering(float h, const Rgb& absorption, const Shape& shape)
    : h_(std::clamp(h, -1.f, 1.f)), eta_(shape.eta), absorption_(absorption) {
    // Chiang's fits of variance and scale, which make the roughness parameters perceptually linear.
    const float m = clampedRoughness(shape.betaM), n = clampedRoughness(shape.betaN);
    variance_ = sqr(0.726f * m + 0.812f * sqr(m) + 3.7f * power(m, 20));
    scale_ = std::sqrt(kPi / 8) * (0.265f * n + 1.194f * sqr(n) + 5.372f * power(n, 22));
    // The scales tilt R by 2 alpha towards the root, TT by alpha and TRT by 4 alpha towards the tip.
    const float alpha = shape.alphaDegrees * kPi / 180;
    const std::array<float, kLobes> tilt = {-2 * alpha, alpha, 4 * alpha, 0};
    for (size_t p = 0; p < kLobes; ++p) {
        tiltSin_[p] = std::sin(tilt[p]);
        tiltCos_[p] = std::cos(tilt[p]);
    }
}

float HairScattering::variance(int lobe) const {
    constexpr float kOfR[kLobes] = {1, 0.25f, 4, 4};
    return kOfR[lobe] * variance_;
}

LobeValue HairScattering::evaluate(const Vec3& wo, const Vec3& wi) const {
    if (wi.z == 0) return {};
    const Outgoing out(*this, wo);
    const float sinI = wi.x, cosI = safeSqrt(1 - wi.x * wi.x);
    const float phi = std::atan2(wi.z, wi.y) - out.phi;
    LobeValue sum;
    for (int p = 0; p < kLobes; ++p) {
        const size_t i = size_t(p);
        const float sinO = out.sin * tiltCos_[i] + out.cos * tiltSin_[i];
        const float cosO = std::abs(out.cos * tiltCos_[i] - out.sin * tiltSin_[i]);
        // The last lobe, light after many internal reflections, is uniform over all azimuths.
        const float around =
            p + 1 < kLobes ? aroundFibre(phi - turn(p, out.gammaO, out.gammaT), scale_) : 0.5f * kInvPi;
        const float density = alongFibre(cosI, cosO, sinI, sinO, variance(p)) * around;
        sum.f += out.attenuation[i] * density;
        sum.pdf += out.probability[i] * density;
    }
    // The model has no cosine to a normal. The division cancels the |cos theta_i| by which integrators multiply f.
    sum.f *= 1 / absCosTheta(wi);
    return sum;
}

LobeSample HairScattering::sample(const Vec3& wo, float uLobe, const Vec2& u, TransportMode) const {
    LobeSample s;
    const Outgoing out(*this, wo);
    // Choose a lobe; the rest of uLobe is uniform again.
    int p = 0;
    while (p + 1 < kLobes && uLobe >= out.probability[size_t(p)]) uLobe -= out.probability[size_t(p++)];
    if (!(out.probability[size_t(p)] > 0)) return s;
    const float uRest = std::clamp(uLobe / out.probability[size_t(p)], 0.f, kOneMinusEpsilon);

    // The longitudinal angle follows from an angle to the mirrored direction, sampled by its cosine, and a rotation
    // about that direction (d'Eon et al., "Importance Sampling for Physically-Based Hair Fiber Models", 2013).
    const size_t i = size_t(p);
    const float sinO = out.sin * tiltCos_[i] + out.cos * tiltSin_[i];
    const float cosO = std::abs(out.cos * tiltCos_[i] - out.sin * tiltSin_[i]);
    const float v = variance(p);
    const float cosine = std::clamp(1 + v * std::log(std::max(1e-30f, u.x + (1 - u.x) * std::exp(-2 / v))), -1.f, 1.f);
    const float sinI = -cosine * sinO + safeSqrt(1 - cosine * cosine) * sinCosOfTurn(uRest).cos * cosO;
    const float cosI = safeSqrt(1 - sinI * sinI);
    const float around =
        p + 1 < kLobes ? turn(p, out.gammaO, out.gammaT) + sampleAroundFibre(u.y, scale_) : 2 * kPi * u.y;
    const float phi = out.phi + around;
    s.wi = normalize(Vec3(sinI, cosI * std::cos(phi), cosI * std::sin(phi)));
    const LobeValue value = evaluate(wo, s.wi);
    s.f = value.f;
    s.pdf = value.pdf;
    s.flags = (sameHemisphere(wo, s.wi) ? LobeFlags::Reflection : LobeFlags::Transmission) | LobeFlags::Glossy;
    return s;
}

Rgb HairScattering::albedo(const Vec3& wo) const {
    const Outgoing out(*this, wo);
    Rgb sum(0.f);
    for (const Rgb& a : out.attenuation) sum += a;
    return sum;
}

}  // namespace drc
