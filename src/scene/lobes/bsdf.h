// The BSDF at one point of a surface: a weighted sum of lobes in the shading frame (PBR 3e, chapters 8 and 9).
//
// All directions are unit vectors in world space and point away from the surface. f is the BSDF itself, without the
// cosine. The geometric normal decides whether reflection or transmission lobes contribute, and the shading frame
// determines their values, so that shading normals leak no light (PBR 3e, section 9.1).
#pragma once
#include <array>
#include <cstddef>
#include <limits>
#include <new>
#include <optional>
#include <type_traits>

#include "math/frame.h"
#include "scene/lobes/bent_normal.h"
#include "scene/lobes/lobes.h"

namespace drc {

struct BsdfSample {
    Vec3 wi;            // world space
    Rgb f;              // BSDF value; for a specular lobe, f |cos theta_i| / pdf scales the throughput
    float pdf = 0;      // per solid angle; for a specular lobe, the probability of choosing it
    LobeFlags flags{};  // of the sampled lobe, or of its sampled branch if it reflects and transmits
    float eta = 1;      // after refraction, index of wi's side over that of wo's; else 1; for Russian roulette
    bool isSpecular() const { return any(flags & LobeFlags::Specular); }
    bool isTransmission() const { return any(flags & LobeFlags::Transmission); }
};

class Bsdf {
  public:
    static constexpr int kMaxLobes = 16;
    static_assert(kMaxLobes <= std::numeric_limits<LobeSet>::digits);

    Bsdf() = default;
    // ng: geometric normal. Neither normal has to face the viewer.
    Bsdf(const Frame& shading, const Vec3& ng) : frame_(shading), ng_(ng) {}
    Bsdf(const Bsdf& other);
    Bsdf& operator=(const Bsdf& other);

    // Drops lobes beyond kMaxLobes and lobes of zero weight. Front ends check materials against kMaxLobes in advance
    // (Material::maxLobes).
    template <class L>
    void add(const L& lobe, const Rgb& weight = Rgb(1.f)) {
        if (own_.count == kMaxLobes || isBlack(weight)) return;
        new (own_.storage + own_.count * sizeof(Lobe)) Lobe(lobe);
        own_.flags[own_.count] = lobe.flags();
        own_.alphas[own_.count] = lobe.alpha();
        own_.weights[own_.count] = weight;
        own_.hasSides[own_.count] = !requires { L::kWithoutSides; };
        if (isSeparable(lobe)) own_.separable |= LobeSet(1 << own_.count);
        ++own_.count;
    }

    // Uses the lobes of another Bsdf in place of its own. The other must outlive this one and its copies, and must not
    // change.
    void borrowLobes(const Bsdf& other) { lobes_ = other.lobes_; }

    // True if any lobe of the mask has all of these flags.
    bool has(LobeFlags flags, const LobeMask& mask = LobeFlags::All) const;
    // True if any lobe lies within the mask.
    bool hasWithin(const LobeMask& mask) const { return has(LobeFlags::None, mask); }
    bool hasNonSpecular() const { return hasWithin(LobeFlags::NonSpecular); }
    bool hasSpecular() const { return has(LobeFlags::Specular); }
    int size() const { return lobes_->count; }

    // Shorthands for a BsdfView of wo and mask. For more than one call, a BsdfView is cheaper.
    Rgb f(const Vec3& wo, const Vec3& wi, const LobeMask& mask = LobeFlags::All,
          TransportMode mode = TransportMode::Radiance) const;
    float pdf(const Vec3& wo, const Vec3& wi, const LobeMask& mask = LobeFlags::All) const;
    std::optional<BsdfSample> sample(const Vec3& wo, float uLobe, const Vec2& u, const LobeMask& mask = LobeFlags::All,
                                     TransportMode mode = TransportMode::Radiance) const;

    // The shading frame.
    const Frame& frame() const { return frame_; }
    void setFrame(const Frame& shading) {
        frame_ = shading;
        unbent_.reset();
    }
    const Vec3& ng() const { return ng_; }

    // Bends the shading frame (bent_normal.h) where a viewer in direction wo would be below its horizon, or where a
    // glossy or specular lobe would reflect the view into the surface. The bend depends on the lobes, so all of them
    // must have been added. f, pdf and sample are then valid for this wo only; seenFrom() gives the BSDF for another
    // one.
    void bendFor(const Vec3& wo) {
        if (unbent_) setFrame(Frame(*unbent_));
        if (mayBend(wo)) bend(wo);
    }
    // Whether bendFor() has bent the frame. If so, all scattering depends on wo through the frame, even by diffuse
    // lobes.
    bool bentForView() const { return unbent_.has_value(); }
    // A copy of this BSDF with the frame bent for a viewer in direction wo, if needed. It borrows the lobes of this
    // one.
    Bsdf seenFrom(const Vec3& wo) const;

    // Estimate of the directional albedo for wo, for the G-buffer and for choosing lobes.
    Rgb albedo(const Vec3& wo, const LobeMask& mask = LobeFlags::All) const;

    // Separable lobes that depend on the view in the same way. The radiance that they scatter towards wo is
    // viewFactor(wo) times a function of the incident light alone, so that a result found for one view holds for all
    // views. If the separable lobes differ in this dependence, only those that share it with the lobe of greatest
    // albedo are returned. The set is empty if no lobe is separable.
    LobeSet separableLobes() const;
    // The factor that depends on the view, for lobes from separableLobes(). wo: world space.
    Rgb viewFactor(const Vec3& wo, LobeSet lobes) const;

    // The lobe of index i in [0, size()), and its properties.
    const Lobe& lobe(int i) const { return reinterpret_cast<const Lobe*>(lobes_->storage)[i]; }
    LobeFlags flags(int i) const { return lobes_->flags[size_t(i)]; }
    float alpha(int i) const { return lobes_->alphas[size_t(i)]; }
    bool isWithin(int i, const LobeMask& mask) const {
        return mask.has(flags(i), alpha(i)) && (mask.lobes >> i & 1) != 0;
    }
    const Rgb& weight(int i) const { return lobes_->weights[size_t(i)]; }
    // Whether the lobe reflects light if wo and wi are on the same side of the shading frame, and transmits it
    // otherwise. False for hair (kWithoutSides in lobe.h).
    bool hasSides(int i) const { return lobes_->hasSides[size_t(i)]; }

  private:
    // A cheap test for every hit. False where even the mirrored view is well above the surface, which is nearly
    // everywhere.
    bool mayBend(const Vec3& wo) const {
        const float cosine = dot(frame_.n, ng_), view = dot(wo, ng_), mirrored = 2 * dot(wo, frame_.n) * cosine - view;
        return !(cosine > 0 && (view < 0 ? -mirrored : mirrored) >= kElevationKept);
    }
    void bend(const Vec3& wo);

    template <class L>
    static bool isSeparable(const L& lobe) {
        if constexpr (requires { lobe.isSeparable(); })
            return lobe.isSeparable();
        else
            return requires { lobe.viewFactor(Vec3()); };
    }

    struct Lobes {
        Lobes() {}
        Lobes(const Lobes& other) { *this = other; }
        Lobes& operator=(const Lobes& other);

        int count = 0;
        LobeSet separable = 0;
        std::array<LobeFlags, kMaxLobes> flags;
        std::array<float, kMaxLobes> alphas;
        std::array<Rgb, kMaxLobes> weights;
        std::array<bool, kMaxLobes> hasSides;
        // Raw memory: a Bsdf is made at every hit, and constructing sixteen lobes where two are used would be wasteful.
        alignas(Lobe) std::byte storage[kMaxLobes * sizeof(Lobe)];
    };

    Frame frame_;
    std::optional<Frame> unbent_;  // the original shading frame; set only if frame_ is bent
    Vec3 ng_{0, 0, 1};
    const Lobes* lobes_ = &own_;  // or those of another Bsdf, see borrowLobes()
    Lobes own_;
};
static_assert(std::is_trivially_destructible_v<Lobe>, "Bsdf does not destroy its lobes");

}  // namespace drc
