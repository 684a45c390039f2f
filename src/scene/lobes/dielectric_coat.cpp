#include "scene/lobes/dielectric_coat.h"

#include "scene/lobes/fresnel.h"

namespace drc {
namespace {

// Integral of g over [0, 1] by Gauss-Legendre quadrature with eight nodes.
template <typename G>
float integrateUnit(const G& g) {
    constexpr float kNode[4] = {0.18343464f, 0.52553241f, 0.79666648f, 0.96028986f};
    constexpr float kWeight[4] = {0.36268378f, 0.31370665f, 0.22238103f, 0.10122854f};
    float sum = 0;
    for (int i = 0; i < 4; ++i) sum += kWeight[i] * (g(0.5f + 0.5f * kNode[i]) + g(0.5f - 0.5f * kNode[i]));
    return 0.5f * sum;
}

}  // namespace

DielectricCoat::DielectricCoat(float eta, float alpha, float depth) : eta_(std::max(1.f, eta)), depth_(depth) {
    // At grazing angles the visible facets lean towards the viewer; from above, they lean in all directions. Both
    // constants are fits of the mean reflectance over visible normals.
    atHorizon_ = sqr(2 * alpha / (1 + 3 * alpha));
    atNormal_ = sqr(1 / (1 + alpha));

    meanTransmittance_ = integrateUnit([&](float c) { return 2 * c * transmittance(c); });
    // From inside, directions beyond the critical angle are totally reflected; those within it map to the hemisphere
    // outside.
    const float inverseEta2 = 1 / (eta_ * eta_);
    const float critical = safeSqrt(1 - inverseEta2);
    const float withinCone =
        integrateUnit([&](float c) { return 2 * c * inverseEta2 * reflectance(c) * sqr(passed(cosineInside(c))); });
    const float beyond =
        critical > 0 ? integrateUnit([&](float x) { return 2 * x * sqr(critical * passed(critical * x)); }) : 0;
    internalReflectance_ = withinCone + beyond;
}

float DielectricCoat::reflectance(float cosTheta) const {
    const float c2 = cosTheta * cosTheta;
    return fresnelDielectric(std::sqrt(lerp(c2, atHorizon_, atNormal_)), 1, eta_);
}

float DielectricCoat::transmittance(float cosTheta) const {
    return (1 - reflectance(cosTheta)) * passed(cosineInside(cosTheta));
}

}  // namespace drc
