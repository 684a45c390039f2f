// A layer of clear or tinted dielectric on a surface, in closed form: what crosses its upper face, what is absorbed on
// the way, and what of the light that the base scatters is sent back to it. docs/layered-materials.md has the formulas
// and how far they are from a random walk between the faces.
//
// Cosines are outside of the coat, to the normal, and not negative; both sides of the surface are coated alike.
#pragma once
#include "math/vec.h"

namespace drc {

class DielectricCoat {
  public:
    // eta: index of refraction, at least 1. alpha: of the upper face's microfacets; 0: smooth. depth: optical depth of
    // absorption along the normal.
    DielectricCoat(float eta, float alpha, float depth);

    // Reflectance of the upper face from outside; nearly that from inside along the refracted direction.
    float reflectance(float cosTheta) const;
    // Cosine after refraction into the coat.
    float cosineInside(float cosTheta) const { return safeSqrt(1 - (1 - cosTheta * cosTheta) / (eta_ * eta_)); }
    // One crossing of the coat, upper face and absorption.
    float transmittance(float cosTheta) const;
    // What absorption leaves along one crossing.
    float passed(float cosInside) const { return depth_ > 0 ? std::exp(-depth_ / cosInside) : 1; }

    // Of light that the base scatters diffusely, the part that reaches the base again.
    float internalReflectance() const { return internalReflectance_; }
    // Mean of transmittance() over directions by their cosine.
    float meanTransmittance() const { return meanTransmittance_; }
    float eta() const { return eta_; }

  private:
    float eta_, depth_;
    // The squared cosine at which the smooth face reflects like the rough one runs linearly, in the squared cosine,
    // between these.
    float atHorizon_, atNormal_;
    float internalReflectance_, meanTransmittance_;
};

}  // namespace drc
