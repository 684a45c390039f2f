// Rough glass: reflection and refraction by the same microfacets in one lobe, which chooses between them at each facet
// in proportion to the light that each carries (Walter et al., "Microfacet Models for Refraction through Rough
// Surfaces", 2007; PBR 4e, section 9.7). A choice between two lobes would be made before the facet is known, and would
// often be wrong: for some directions inside glass, most facets reflect totally while the others hardly reflect at all.
#pragma once
#include "scene/lobes/microfacet_reflection.h"
#include "scene/lobes/microfacet_transmission.h"

namespace drc {

class MicrofacetDielectric {
  public:
    // etaB: index of refraction on the side away from the shading normal, relative to the index on the normal's side;
    // not 1, see MicrofacetTransmission.
    MicrofacetDielectric(const Rgb& reflectance, const Rgb& transmittance, const TrowbridgeReitz& distribution,
                         float etaB)
        : MicrofacetDielectric(reflectance, transmittance, distribution, etaB, Fresnel::dielectric(1, etaB)) {}
    // fresnel: Fresnel term of the reflection, which may be tinted.
    MicrofacetDielectric(const Rgb& reflectance, const Rgb& transmittance, const TrowbridgeReitz& distribution,
                         float etaB, const Fresnel& fresnel);

    static constexpr LobeFlags flags() { return LobeFlags::Reflection | LobeFlags::Transmission | LobeFlags::Glossy; }
    float alpha() const { return distribution_.largestAlpha(); }
    Rgb f(const Vec3& wo, const Vec3& wi) const { return f(wo, wi, TransportMode::Radiance); }
    Rgb f(const Vec3& wo, const Vec3& wi, TransportMode mode) const;
    float pdf(const Vec3& wo, const Vec3& wi) const;
    LobeSample sample(const Vec3& wo, float uLobe, const Vec2& u, TransportMode mode) const;
    // Albedo of the smooth surface.
    Rgb albedo(const Vec3& wo) const { return reflection_.albedo(wo) + transmission_.albedo(wo); }

  private:
    // The probability of choosing reflection at a facet. cosine: between wo and the facet's normal, which points to the
    // side of the shading normal.
    float reflects(float cosine) const;

    TrowbridgeReitz distribution_;
    Rgb reflectance_, transmittance_;
    Fresnel fresnel_;
    IndexRatio boundary_;
    MicrofacetReflection reflection_;
    MicrofacetTransmission transmission_;
};

}  // namespace drc
