// Light scattered by a fibre of hair or fur (Marschner et al., "Light Scattering from Human Hair Fibers", 2003; d'Eon
// et al., "An Energy-Conserving Hair Reflectance Model", 2011; Chiang et al., "A Practical and Controllable Hair and
// Fur Model for Production Path Tracing", 2016; Pharr, "The Implementation of a Hair Scattering Model", 2016).
//
// The fibre is a rough, coloured dielectric cylinder with scales that tilt towards its tip. Light is reflected off its
// surface (R), passes through (TT), or leaves after one or more internal reflections (TRT, and all further ones). Each
// of these lobes is the product of an attenuation by absorption, a distribution along the fibre and one around it; the
// distributions integrate to one, so that energy is conserved.
//
// The x axis of the shading frame points along the fibre; longitudinal angles are measured from the plane normal to it,
// azimuths within that plane. All scattering inside the fibre is part of the lobe, so light may leave on either side.
#pragma once
#include <array>

#include "scene/lobes/lobe.h"

namespace drc {

class HairScattering {
  public:
    struct Shape {
        float eta = 1.55f;         // index of refraction
        float betaM = 0.3f;        // roughness along the fibre, [0, 1]
        float betaN = 0.3f;        // roughness around it, [0, 1]
        float alphaDegrees = 2.f;  // tilt of the scales
    };
    // h: where the ray hits the fibre, across its width, in [-1, 1]. absorption: sigma_a inside, in units of 1 / the
    // fibre's radius.
    HairScattering(float h, const Rgb& absorption, const Shape& shape);

    static constexpr bool kWithoutSides = true;
    static constexpr LobeFlags flags() { return LobeFlags::Reflection | LobeFlags::Transmission | LobeFlags::Glossy; }
    static constexpr float alpha() { return 0; }  // never broad, see LobeMask
    LobeValue evaluate(const Vec3& wo, const Vec3& wi) const;
    Rgb f(const Vec3& wo, const Vec3& wi) const { return evaluate(wo, wi).f; }
    float pdf(const Vec3& wo, const Vec3& wi) const { return evaluate(wo, wi).pdf; }
    LobeSample sample(const Vec3& wo, float uLobe, const Vec2& u, TransportMode mode) const;
    Rgb albedo(const Vec3& wo) const;  // exact

  private:
    // R, TT, TRT, and all further ones together.
    static constexpr int kLobes = 4;
    // Quantities that depend on wo alone.
    struct Outgoing;
    float variance(int lobe) const;

    float h_, eta_;
    Rgb absorption_;
    float variance_;  // longitudinal variance of the R lobe
    float scale_;     // of the logistic azimuthal distributions
    std::array<float, kLobes> tiltSin_, tiltCos_;
};

}  // namespace drc
