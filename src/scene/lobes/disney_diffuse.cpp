#include "scene/lobes/disney_diffuse.h"

#include "scene/lobes/fresnel.h"

namespace drc {

// Burley's fit of Hanrahan and Krueger's subsurface scattering. inverseCosines is 1 / (cos theta_o + cos theta_i).
float DisneyDiffuse::flatness(float schlickO, float schlickI, float cos2D, float inverseCosines) const {
    const float atHorizon = roughness_ * cos2D;
    const float fresnel = lerp(schlickO, 1, atHorizon) * lerp(schlickI, 1, atHorizon);
    return 1.25f * (fresnel * (inverseCosines - 0.5f) + 0.5f);
}

float DisneyDiffuse::retroReflection(float schlickO, float schlickI, float cos2D) const {
    const float strength = 2 * roughness_ * cos2D;
    return strength * (schlickO + schlickI + schlickO * schlickI * (strength - 1));
}

Rgb DisneyDiffuse::f(const Vec3& wo, const Vec3& wi) const {
    const float cosO = absCosTheta(wo), cosI = absCosTheta(wi);
    const Vec3 wh = wo + wi;
    // The half vector is only degenerate for wi below the horizon, which the Bsdf rejects anyway.
    if (cosO + cosI == 0 || lengthSquared(wh) == 0) return Rgb(0.f);
    const float schlickO = schlickWeight(cosO), schlickI = schlickWeight(cosI);
    const float cosD = std::min(1.f, dot(wi, normalize(wh))), cos2D = cosD * cosD;
    const Rgb diffuse = colors_.base * ((1 - 0.5f * schlickO) * (1 - 0.5f * schlickI)) +
                        colors_.flat * flatness(schlickO, schlickI, cos2D, 1 / (cosO + cosI)) +
                        colors_.retro * retroReflection(schlickO, schlickI, cos2D);
    return diffuse * kInvPi + colors_.sheen * schlickWeight(cosD);
}

Rgb DisneyDiffuse::viewFactor(const Vec3& wo) const {
    return colors_.base * (1 - 0.5f * schlickWeight(absCosTheta(wo)));
}

// The terms of f(), evaluated at means over a cosine-weighted wi: schlickI = 1/21 (exact for the base), cos2D = (1 +
// 2/3 cos theta_o) / 2 and, with c = cos theta_o, inverseCosines = 2 (1 - c ln (1 + 1/c)). The sheen term is a fit.
Rgb DisneyDiffuse::albedo(const Vec3& wo) const {
    const float cosO = absCosTheta(wo);
    const float schlickO = schlickWeight(cosO), schlickI = 1 / 21.f;
    const float cos2D = 0.5f + cosO / 3;
    const float inverseCosines = cosO > 0 ? 2 * (1 - cosO * std::log(1 + 1 / cosO)) : 2;
    const float sheen = 0.088f * sqr(1 - cosO) * safeSqrt(1 - cosO);
    return colors_.base * ((1 - 0.5f * schlickO) * (1 - 0.5f * schlickI)) +
           colors_.flat * flatness(schlickO, schlickI, cos2D, inverseCosines) +
           colors_.retro * retroReflection(schlickO, schlickI, cos2D) + colors_.sheen * sheen;
}

}  // namespace drc
