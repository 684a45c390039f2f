#include "scene/lobes/coated_diffuse.h"

namespace drc {

CoatedDiffuse::CoatedDiffuse(const Rgb& reflectance, const DielectricCoat& coat) : coat_(coat) {
    for (int c = 0; c < 3; ++c)
        scattered_[c] = reflectance[c] / ((1 - reflectance[c] * coat.internalReflectance()) * sqr(coat.eta()));
}

Rgb CoatedDiffuse::f(const Vec3& wo, const Vec3& wi) const {
    return scattered_ * (kInvPi * coat_.transmittance(absCosTheta(wo)) * coat_.transmittance(absCosTheta(wi)));
}

Rgb CoatedDiffuse::albedo(const Vec3& wo) const {
    return scattered_ * (coat_.transmittance(absCosTheta(wo)) * coat_.meanTransmittance());
}

}  // namespace drc
