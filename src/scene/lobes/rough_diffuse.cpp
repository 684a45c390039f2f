#include "scene/lobes/rough_diffuse.h"

namespace drc {
namespace {

// The cosine-weighted integral of the grooves' term over the hemisphere of one direction. cosine: that of the other
// direction.
float integralOfGrooves(float cosine) {
    constexpr float kTwoThirds = 2.f / 3;
    const float sine = safeSqrt(1 - cosine * cosine), angle = std::acos(std::min(cosine, 1.f));
    // (1 - sin^3) / cos, without a small difference of large numbers near the horizon: 1 - sin^2 is cos^2.
    const float slope = cosine * (1 + sine + sine * sine) / (1 + sine);
    return sine * (angle - kTwoThirds - sine * cosine + kTwoThirds * slope);
}

}  // namespace

RoughDiffuse::RoughDiffuse(const Rgb& reflectance, float roughness, DiffusePart part)
    : part_(part), roughness_(roughness) {
    even_ = 1 / (kPi + roughness * (kPi / 2 - 2.f / 3));
    grooves_ = roughness * even_;
    const float mean = kPi * even_ + grooves_ * (2 * kPi - 5.6f) / 3, missing = 1 - mean;
    for (int c = 0; c < 3; ++c) {
        reflectance_[c] = std::clamp(reflectance[c], 0.f, 1.f);  // a larger one would gain energy at each bounce
        repeated_[c] = sqr(reflectance_[c]) * mean / (1 - reflectance_[c] * missing);
    }
    perMissing_ = missing > 1e-6f ? kInvPi / missing : 0;
}

float RoughDiffuse::albedoOnce(float cosTheta) const { return kPi * even_ + grooves_ * integralOfGrooves(cosTheta); }

Rgb RoughDiffuse::f(const Vec3& wo, const Vec3& wi) const {
    const float cosO = absCosTheta(wo), cosI = absCosTheta(wi);
    const float separable = separableFactor(cosO) * separableFactor(cosI);
    if (part_ == DiffusePart::Separable) return reflectance_ * (even_ * separable);
    // Dot product of the directions' tangential parts: positive if both lean to the same side.
    const float across = wo.x * wi.x + wo.y * wi.y;
    const float groove = across > 0 ? across / std::max(std::max(cosO, cosI), 1e-6f) : across;
    const float missing = (1 - albedoOnce(cosO)) * (1 - albedoOnce(cosI));
    const float once = std::max(0.f, even_ * (1 - separable) + grooves_ * groove);
    return reflectance_ * once + repeated_ * (missing * perMissing_);
}

// The integral of cos sqrt(1 - r sin^2) over the hemisphere is 2 pi (1 - (1 - r)^(3/2)) / (3 r), rewritten here without
// cancellation.
Rgb RoughDiffuse::separableAlbedo(float cosTheta) const {
    const float q = safeSqrt(1 - roughness_), integral = 2 * kPi / 3 * (1 + q + q * q) / (1 + q);
    return reflectance_ * (even_ * separableFactor(cosTheta) * integral);
}

Rgb RoughDiffuse::albedo(const Vec3& wo) const {
    const float cosTheta = absCosTheta(wo), once = albedoOnce(cosTheta);
    const Rgb separable = separableAlbedo(cosTheta);
    if (part_ == DiffusePart::Separable) return separable;
    return (perMissing_ > 0 ? reflectance_ * once + repeated_ * (1 - once) : reflectance_) - separable;
}

}  // namespace drc
