// A lobe under layers, rotated about the normal, with the light that its microfacets scatter more than once.
#pragma once
#include "scene/lobes/layers_above.h"
#include "scene/lobes/lobe.h"
#include "scene/lobes/microfacet_albedo.h"

namespace drc {

// A rotation about the normal, from the shading frame to that of the lobe.
class LobeTurn {
  public:
    LobeTurn() = default;
    // turns: counterclockwise angle, 1 for a full turn.
    explicit LobeTurn(float turns) : cosine_(std::cos(2 * kPi * turns)), sine_(std::sin(2 * kPi * turns)) {}
    Vec3 toLobe(const Vec3& w) const { return {cosine_ * w.x + sine_ * w.y, cosine_ * w.y - sine_ * w.x, w.z}; }
    Vec3 fromLobe(const Vec3& w) const { return {cosine_ * w.x - sine_ * w.y, cosine_ * w.y + sine_ * w.x, w.z}; }

  private:
    float cosine_ = 1, sine_ = 0;
};

// Inner: a lobe of lobes.h. The factors only scale f, so the pdf is that of the inner lobe.
template <class Inner>
class LayeredLobe {
  public:
    LayeredLobe(const Inner& inner, const LayersAbove& above, const MultipleScattering& rest = {},
                const LobeTurn& turn = {})
        : inner_(inner), above_(above), rest_(rest), turn_(turn) {}

    LobeFlags flags() const { return inner_.flags(); }
    float alpha() const { return inner_.alpha(); }
    LobeValue evaluate(const Vec3& wo, const Vec3& wi, TransportMode mode) const {
        const Vec3 o = turn_.toLobe(wo), i = turn_.toLobe(wi);
        LobeValue value;
        if constexpr (requires { inner_.evaluate(o, i); })
            value = inner_.evaluate(o, i);
        else if constexpr (requires { inner_.f(o, i, mode); })
            value = {inner_.f(o, i, mode), inner_.pdf(o, i)};
        else
            value = {inner_.f(o, i), inner_.pdf(o, i)};
        if (!isBlack(value.f)) value.f *= factor(wo, wi, mode);
        return value;
    }
    Rgb f(const Vec3& wo, const Vec3& wi) const { return f(wo, wi, TransportMode::Radiance); }
    Rgb f(const Vec3& wo, const Vec3& wi, TransportMode mode) const { return evaluate(wo, wi, mode).f; }
    float pdf(const Vec3& wo, const Vec3& wi) const { return inner_.pdf(turn_.toLobe(wo), turn_.toLobe(wi)); }
    LobeSample sample(const Vec3& wo, float uLobe, const Vec2& u, TransportMode mode) const {
        LobeSample s = inner_.sample(turn_.toLobe(wo), uLobe, u, mode);
        if (!(s.pdf > 0)) return s;
        s.wi = turn_.fromLobe(s.wi);
        s.f *= factor(wo, s.wi, mode);
        return s;
    }
    // As accurate as the albedo of the inner lobe.
    Rgb albedo(const Vec3& wo) const { return inner_.albedo(turn_.toLobe(wo)) * above_.bothWays(wo, wo); }

  private:
    Rgb factor(const Vec3& wo, const Vec3& wi, TransportMode mode) const {
        return rest_.factor(mode == TransportMode::Radiance ? wo : wi) * above_.bothWays(wo, wi);
    }

    Inner inner_;
    LayersAbove above_;
    MultipleScattering rest_;
    LobeTurn turn_;
};

}  // namespace drc
