// What the lobes that a BSDF can be made of have in common. Each is a small value type in a file or pair of its own; a
// new lobe is that, one line in lobes.h, and a test.
//
// A lobe works in the shading frame: unit vectors, z is the shading normal, both wo and wi point away from the
// surface and may be on either side. It offers
//     LobeFlags flags() const;                       // what it is
//     Rgb f(wo, wi) const;                           // BSDF, without cosine; 0 for a specular lobe
//     float pdf(wo, wi) const;                       // of sample(), per solid angle; 0 for a specular lobe
//     LobeSample sample(wo, uLobe, u, mode) const;   // pdf 0: no sample
//     Rgb f(wo, wi, mode) const;                     // only where f depends on what is transported
//     LobeValue evaluate(wo, wi) const;              // only where f and pdf together cost less than the two apart
//     Rgb albedo(wo) const;                          // estimate of the directional albedo, for choosing lobes
#pragma once
#include <cstdint>

#include "math/vec.h"

namespace drc {

// Camera paths carry radiance, light paths importance: refraction scales radiance, and only radiance, by
// (eta_i / eta_t)^2 (PBR 3e, section 16.1.3).
enum class TransportMode { Radiance, Importance };

enum class LobeFlags : uint8_t {
    None = 0,
    Reflection = 1,
    Transmission = 2,
    Diffuse = 4,
    Glossy = 8,
    Specular = 16,
    // In place of Glossy: a glossy lobe narrower than the texels of a radiance map resolve.
    Narrow = 32,
    Wide = Reflection | Transmission | Diffuse | Glossy,
    NonSpecular = Wide | Narrow,
    All = NonSpecular | Specular,
};
constexpr LobeFlags operator|(LobeFlags a, LobeFlags b) { return LobeFlags(uint8_t(a) | uint8_t(b)); }
constexpr LobeFlags operator&(LobeFlags a, LobeFlags b) { return LobeFlags(uint8_t(a) & uint8_t(b)); }
constexpr bool any(LobeFlags f) { return f != LobeFlags::None; }
// A lobe takes part if all its flags are in the mask.
constexpr bool matches(LobeFlags lobe, LobeFlags mask) { return (lobe & mask) == lobe; }

struct LobeValue {
    Rgb f{0.f};
    float pdf = 0;
};

struct LobeSample {
    Vec3 wi{0, 0, 0};
    Rgb f{0.f};  // for a specular lobe: weight / |cos theta_i| times pdf
    float pdf = 0;
    LobeFlags flags{};  // of the branch that was sampled (a lobe may both reflect and transmit)
    float eta = 1;      // relative index of refraction crossed
};

// What specular lobes have in common: only their own samples have any of their light.
class SpecularLobe {
  public:
    Rgb f(const Vec3&, const Vec3&) const { return Rgb(0.f); }
    float pdf(const Vec3&, const Vec3&) const { return 0; }
};

}  // namespace drc
