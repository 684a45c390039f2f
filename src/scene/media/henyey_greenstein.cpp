#include "scene/media/henyey_greenstein.h"

#include <algorithm>
#include <cmath>

#include "math/frame.h"

namespace drc {

float phaseHenyeyGreenstein(float g, const Vec3& wo, const Vec3& wi) {
    // The peak is at wi = -wo if g > 0 and at wi = wo if g < 0. This form of the denominator 1 + g^2 + 2 g dot(wo, wi)
    // does not suffer from cancellation near the peak.
    const float fromPeak = std::max(0.f, 1 + (g > 0 ? dot(wo, wi) : -dot(wo, wi)));
    const float denominator = sqr(1 - std::abs(g)) + 2 * std::abs(g) * fromPeak;
    return (1 - g * g) / (4 * kPi * denominator * std::sqrt(denominator));
}

Vec3 sampleHenyeyGreenstein(float g, const Vec3& wo, const Vec2& u) {
    // Inverts the cumulative distribution of the scattering angle's cosine, in a form that does not divide by g.
    const float x = 1 - 2 * u.x;
    const float polynomial = 2 * x + g * (x * x + 3 + g * (2 * x + g * (x * x - 1)));
    const float cosine = std::clamp(polynomial / (2 * sqr(1 + g * x)), -1.f, 1.f);
    const float sine = std::sqrt(std::max(0.f, 1 - cosine * cosine)), phi = 2 * kPi * u.y;
    const Frame frame = Frame::fromNormal(-wo);
    return normalize(frame.toWorld(Vec3(sine * std::cos(phi), sine * std::sin(phi), cosine)));
}

}  // namespace drc
