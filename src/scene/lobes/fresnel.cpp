#include "scene/lobes/fresnel.h"

namespace drc {

namespace {

// A single channel. If the complex cosine inside the metal is (a + i b) / (eta + i k), the reflectances only depend on
// a^2 + b^2 and a.
float conductorChannel(float cosTheta, float eta, float k) {
    const float cos2 = cosTheta * cosTheta, sin2 = 1 - cos2;
    const float eta2 = eta * eta, k2 = k * k;
    const float real = eta2 - k2 - sin2;
    const float a2b2 = safeSqrt(real * real + 4 * eta2 * k2);
    const float twoACos = 2 * cosTheta * safeSqrt(0.5f * (a2b2 + real));
    const float s = a2b2 + cos2;
    // The sum is zero only at grazing incidence for eta = 1 and k = 0. The value is then 1, as for all other indices at
    // grazing incidence.
    const float perpendicular = s + twoACos > 0 ? (s - twoACos) / (s + twoACos) : 1;
    const float p = cos2 * a2b2 + sin2 * sin2;
    const float q = twoACos * sin2;
    const float parallel = p + q > 0 ? perpendicular * (p - q) / (p + q) : perpendicular;
    return 0.5f * (parallel + perpendicular);
}

}  // namespace

Rgb fresnelConductor(float cosThetaI, const Rgb& eta, const Rgb& k) {
    const float c = std::min(std::abs(cosThetaI), 1.f);
    return Rgb(conductorChannel(c, eta.x, k.x), conductorChannel(c, eta.y, k.y), conductorChannel(c, eta.z, k.z));
}

}  // namespace drc
