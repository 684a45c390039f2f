#include "scene/lobes/oren_nayar.h"

namespace drc {

OrenNayar::OrenNayar(const Rgb& reflectance, float sigmaDegrees, DiffusePart part) : reflectance_(reflectance) {
    const float sigma2 = sqr(sigmaDegrees * kPi / 180);
    if (part == DiffusePart::Separable)
        a_ = 1 - sigma2 / (2 * (sigma2 + 0.33f));
    else
        b_ = 0.45f * sigma2 / (sigma2 + 0.09f);
}

Rgb OrenNayar::f(const Vec3& wo, const Vec3& wi) const {
    const float cosI = absCosTheta(wi), cosO = absCosTheta(wo);
    const float sinI = safeSqrt(1 - wi.z * wi.z), sinO = safeSqrt(1 - wo.z * wo.z);
    // Along the normal, a direction has no azimuth.
    float cosDeltaPhi = 0;
    if (sinI > 1e-4f && sinO > 1e-4f) cosDeltaPhi = std::clamp((wi.x * wo.x + wi.y * wo.y) / (sinI * sinO), 0.f, 1.f);
    // sin(alpha) tan(beta), alpha the larger and beta the smaller polar angle: the product of the sines divided by the
    // larger cosine.
    const float larger = std::max(cosI, cosO);
    const float sinTan = larger > 0 ? sinI * sinO / larger : 0;
    return reflectance_ * (kInvPi * (a_ + b_ * cosDeltaPhi * sinTan));
}

// In the grooves' term B, the positive part of the cosine integrates to 2 over the azimuth. Over the polar angle of wi,
// alpha (the larger angle) is theta_o up to theta_o (`steeper`), and theta_i beyond (`flatter`).
Rgb OrenNayar::albedo(const Vec3& wo) const {
    const float cosine = absCosTheta(wo), sine = safeSqrt(1 - cosine * cosine);
    const float angle = std::acos(std::min(cosine, 1.f));
    const float steeper = sine * (angle - sine * cosine) / 2;
    // tan (1 - sin^3) / 3, without a small difference of large numbers near the horizon: 1 - sin^2 is cos^2.
    const float flatter = sine * cosine * (1 + sine + sine * sine) / (3 * (1 + sine));
    return reflectance_ * (a_ + b_ * 2 * kInvPi * (steeper + flatter));
}

}  // namespace drc
