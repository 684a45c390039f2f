// The layers over a lobe of a material: the share of the light that they let pass, and the colour that an absorbing
// coat gives it.
#pragma once
#include "scene/lobes/cosine_curve.h"
#include "scene/lobes/local_directions.h"

namespace drc {

// Transmittance of an absorbing coat, for light on its way in and out.
class CoatColour {
  public:
    // A clear coat.
    CoatColour() = default;
    // tint: what is left of light that crosses the coat along the normal, in and out; it absorbs more on a slanted way.
    // eta: index of the coat, which bends the way. share: of the surface that has the coat.
    CoatColour(const Rgb& tint, float eta, float share);

    Rgb at(float cosTheta) const { return clear_ ? Rgb(1.f) : absorbed(cosTheta); }
    // Transmittance of one of the two ways; bothWays() is the product of both.
    Rgb oneWay(const Vec3& w) const { return clear_ ? Rgb(1.f) : sqrt(absorbed(w.z)); }
    Rgb bothWays(const Vec3& wo, const Vec3& wi) const {
        return clear_ ? Rgb(1.f) : sqrt(absorbed(wo.z) * absorbed(wi.z));
    }

  private:
    Rgb absorbed(float cosTheta) const;

    bool clear_ = true;
    Rgb opticalDepth_{0.f};
    float inverseEta_ = 1, share_ = 0;
};

struct LayersAbove {
    // The share that passes, for each direction of view. It counts the ways in and out together: what a layer does not
    // reflect is left for those below it.
    CosineCurve passed;
    bool any = false;  // passed is not 1
    CoatColour colour;

    // Adds a layer under those that are there.
    void add(const CosineCurve& share) {
        any = true;
        for (int i = 0; i < CosineCurve::kNodes; ++i) passed[i] *= std::clamp(share[i], 0.f, 1.f);
    }
    // Share of the light that the layers let pass where a lobe near the mirror direction scatters it from wi to wo.
    // Both directions meet nearly the same layers; the smaller share counts, so that no energy is gained.
    Rgb bothWays(const Vec3& wo, const Vec3& wi) const {
        const Rgb c = colour.bothWays(wo, wi);
        return any ? c * std::min(passed.at(wo.z), passed.at(wi.z)) : c;
    }
};

}  // namespace drc
