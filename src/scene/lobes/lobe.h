// The interface that all lobes of a BSDF share. Each lobe is a small value type in a file of its own, or a pair of
// files. A new lobe needs these, an entry in lobes.h, and a test.
//
// A lobe works in the shading frame: all vectors are unit, z is the shading normal, and both wo and wi point away from
// the surface and may be on either side. It offers
//     LobeFlags flags() const;                       // what it is
//     float alpha() const;                           // its roughness, see LobeMask
//     Rgb f(wo, wi) const;                           // BSDF, without cosine; 0 for a specular lobe
//     float pdf(wo, wi) const;                       // of sample(), per solid angle of wi; 0 for a specular lobe
//     LobeSample sample(wo, uLobe, u, mode) const;   // pdf 0: no sample
//     Rgb f(wo, wi, mode) const;                     // only if f depends on the transport mode
//     LobeValue evaluate(wo, wi) const;              // only if f and pdf are cheaper to compute together;
//                                                    // with a third argument if f depends on the transport mode
//     Rgb albedo(wo) const;                          // estimate of the directional albedo, for choosing lobes
//     Rgb viewFactor(wo) const;                      // only if the lobe is separable: f(wo, wi) is exactly
//                                                    // viewFactor(wo) times a function of wi (Bsdf::separableLobes)
//     bool isSeparable() const;                      // only if viewFactor is valid for some parameters only
//     static constexpr bool kWithoutSides = true;    // only if the sides of wo and wi do not tell reflection
//                                                    // from transmission
#pragma once
#include <cstdint>
#include <limits>

#include "math/vec.h"

namespace drc {

// As in pbrt, paths from the camera use Radiance and paths from lights use Importance: refraction scales radiance, and
// only radiance, by (eta_i / eta_t)^2 (PBR 3e, section 16.1.3).
enum class TransportMode { Radiance, Importance };

enum class LobeFlags : uint8_t {
    None = 0,
    Reflection = 1,
    Transmission = 2,
    Diffuse = 4,
    Glossy = 8,
    Specular = 16,
    NonSpecular = Reflection | Transmission | Diffuse | Glossy,
    All = NonSpecular | Specular,
};
constexpr LobeFlags operator|(LobeFlags a, LobeFlags b) { return LobeFlags(uint8_t(a) | uint8_t(b)); }
constexpr LobeFlags operator&(LobeFlags a, LobeFlags b) { return LobeFlags(uint8_t(a) & uint8_t(b)); }
// Mirrors and smooth glass.
inline constexpr LobeFlags kSpecularLobes = LobeFlags::Specular | LobeFlags::Reflection | LobeFlags::Transmission;
constexpr bool any(LobeFlags f) { return f != LobeFlags::None; }

// A set of lobes of a Bsdf: bit i stands for the lobe of index i.
using LobeSet = uint16_t;

// Selects lobes: those whose flags are all in `flags`, whose roughness is in [from, to), and whose bit is in `lobes`.
//
// The roughness is alpha of the Trowbridge-Reitz distribution of microfacets, the larger one of both axes; 0 for
// specular lobes, kDiffuseAlpha for diffuse ones. It is 0 for hair, whatever the hair's own roughness: a fibre is
// thinner than a pixel, and its normal turns all the way around across it, so that data of neighbouring points do not
// apply.
struct LobeMask {
    constexpr LobeMask(LobeFlags f) : flags(f) {}  // NOLINT: flags alone are a mask
    constexpr LobeMask(LobeFlags f, float fromAlpha, float toAlpha) : flags(f), from(fromAlpha), to(toAlpha) {}
    constexpr LobeMask(LobeFlags f, LobeSet set) : flags(f), lobes(set) {}
    constexpr bool has(LobeFlags lobe, float alpha) const {
        return (lobe & flags) == lobe && alpha >= from && alpha < to;
    }

    LobeFlags flags;
    float from = 0, to = std::numeric_limits<float>::infinity();
    LobeSet lobes = std::numeric_limits<LobeSet>::max();
};

inline constexpr float kDiffuseAlpha = std::numeric_limits<float>::max();

// Broad lobes: diffuse ones, and other non-specular ones with an alpha of at least `threshold`. The threshold is the
// alpha down to which a map of incident radiance resolves their light (broadAlpha() of maps/projection.h).
constexpr LobeMask broadLobes(float threshold) {
    return {LobeFlags::NonSpecular, threshold, std::numeric_limits<float>::infinity()};
}
// Glossy lobes: all other non-specular ones.
constexpr LobeMask glossyLobes(float threshold) { return {LobeFlags::NonSpecular, 0, threshold}; }

struct LobeValue {
    Rgb f{0.f};
    float pdf = 0;
};

struct LobeSample {
    Vec3 wi{0, 0, 0};
    Rgb f{0.f};  // for a specular lobe, f |cos theta_i| / pdf is the weight of the sample
    float pdf = 0;
    LobeFlags flags{};  // of the branch that was sampled (a lobe may both reflect and transmit)
    float eta = 1;      // after refraction, index on the side of wi over that on the side of wo
};

// The base of specular lobes: f and pdf are zero, because only their own samples carry light.
class SpecularLobe {
  public:
    Rgb f(const Vec3&, const Vec3&) const { return Rgb(0.f); }
    float pdf(const Vec3&, const Vec3&) const { return 0; }
    static constexpr float alpha() { return 0; }
};

}  // namespace drc
