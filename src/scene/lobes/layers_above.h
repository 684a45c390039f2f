// The layers above a lobe of a material: the share of the light that passes them, and the colour that an absorbing coat
// gives to this light.
#pragma once
#include "scene/lobes/cosine_curve.h"
#include "scene/lobes/local_directions.h"

namespace drc {

// Transmittance of an absorbing coat, for light that passes it on its way in and again on its way out.
class CoatColour {
  public:
    // A clear coat.
    CoatColour() = default;
    // tint: transmittance along the normal, in and out together; slanted paths are longer and absorb more. eta: index
    // of the coat, at which the path is refracted. share: share of the surface with a coat.
    CoatColour(const Rgb& tint, float eta, float share);

    Rgb at(float cosTheta) const { return clear_ ? Rgb(1.f) : absorbed(cosTheta); }
    // Transmittance of one of the two passages; bothWays() is the product of both.
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
    // Share of the light that passes the layers, in and out together, by the cosine of the view. Each layer multiplies
    // it by the share that the layer does not reflect.
    CosineCurve passed;
    bool any = false;  // whether there are layers, so that `passed` may differ from 1
    CoatColour colour;

    // Adds a layer below the present ones. share: what passes this layer, in and out together.
    void add(const CosineCurve& share) {
        any = true;
        for (int i = 0; i < CosineCurve::kNodes; ++i) passed[i] *= std::clamp(share[i], 0.f, 1.f);
    }
    // Share of the light that passes the layers when a lobe scatters it from wi to wo, near the mirror direction.
    // `passed` is nearly the same for both directions; the smaller value counts, so that no energy is gained.
    Rgb bothWays(const Vec3& wo, const Vec3& wi) const {
        const Rgb c = colour.bothWays(wo, wi);
        return any ? c * std::min(passed.at(wo.z), passed.at(wi.z)) : c;
    }
};

}  // namespace drc
