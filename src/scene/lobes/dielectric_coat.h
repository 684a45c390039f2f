// A clear or absorbing dielectric layer on a surface, in closed form: the light that crosses its interface, absorption
// on the way, and the share of the light scattered by the base that the interface sends back. docs/layered-materials.md
// has the formulas and their error against a random walk.
//
// Cosines are to the normal, not negative, and measured outside the coat unless they are named `inside`. Both sides of
// the surface have the same coat.
#pragma once
#include "math/vec.h"

namespace drc {

class DielectricCoat {
  public:
    // eta: index of refraction, at least 1. alpha: roughness of the interface; 0 is smooth. depth: optical depth of
    // absorption along the normal.
    DielectricCoat(float eta, float alpha, float depth);

    // Reflectance of the interface from outside; from inside, along the refracted direction, it is nearly the same.
    float reflectance(float cosTheta) const;
    // Cosine after refraction into the coat.
    float cosineInside(float cosTheta) const { return safeSqrt(1 - (1 - cosTheta * cosTheta) / (eta_ * eta_)); }
    // Transmittance of one crossing of interface and layer.
    float transmittance(float cosTheta) const;
    // Transmittance of the layer alone, along one crossing.
    float passed(float cosInside) const { return depth_ > 0 ? std::exp(-depth_ / cosInside) : 1; }

    // Share of the light scattered diffusely by the base that returns to the base.
    float internalReflectance() const { return internalReflectance_; }
    // Cosine-weighted mean of transmittance() over the hemisphere.
    float meanTransmittance() const { return meanTransmittance_; }
    float eta() const { return eta_; }

  private:
    float eta_, depth_;
    // A rough interface reflects like a smooth one at an effective angle, whose squared cosine is lerp(cos^2 theta,
    // atHorizon_, atNormal_).
    float atHorizon_, atNormal_;
    float internalReflectance_, meanTransmittance_;
};

}  // namespace drc
