// The BSDF at one point of a surface: a weighted sum of lobes in the shading frame (PBR 3e, chapters 8 and 9).
//
// All directions are unit vectors in world space and point away from the surface. f is the BSDF itself, without the
// cosine. Which of the reflection and transmission lobes take part is decided by the geometric normal, their values
// by the shading frame, so that shading normals leak no light (PBR 3e, section 9.1).
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
    Rgb f;              // BSDF value; for a specular lobe f / pdf is the weight divided by |cos|
    float pdf = 0;      // per solid angle; for a specular lobe the probability of having chosen it
    LobeFlags flags{};  // of the lobe that was sampled
    float eta = 1;      // relative index of refraction crossed, 1 if none; for Russian roulette
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

    // Lobes beyond kMaxLobes and lobes of zero weight are not added; front ends check materials against
    // kMaxLobes (Material::maxLobes).
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

    // The functions of a BsdfView of wo through the mask; a view is cheaper for more than one call.
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

    // Bends the shading frame where a viewer in direction wo would be below its horizon, or would see a reflection of
    // what is below the surface (bent_normal.h). It depends on the lobes, which must have been added. f, pdf and sample
    // then hold for this wo: for another one, ask seenFrom().
    void bendFor(const Vec3& wo) {
        if (unbent_) setFrame(Frame(*unbent_));
        if (mayBend(wo)) bend(wo);
    }
    // Whether the frame was bent. If so, all that is scattered here depends on the view, even by diffuse lobes.
    bool bentForView() const { return unbent_.has_value(); }
    // This surface as a viewer in direction wo meets it, with the frame bent where wo needs it. Borrows the lobes.
    Bsdf seenFrom(const Vec3& wo) const;

    // The albedo towards wo: an estimate for the G-buffer and for choosing lobes.
    Rgb albedo(const Vec3& wo, const LobeMask& mask = LobeFlags::All) const;

    // Separable lobes with one and the same dependence on the view: the radiance that they scatter towards wo is
    // viewFactor(wo) times a function of the light alone, so that all views can share what one of them has found out.
    // Where lobes of several dependences are mixed, those of the greatest albedo; empty if no lobe is separable.
    LobeSet separableLobes() const;
    // wo in world space. lobes: from separableLobes().
    Rgb viewFactor(const Vec3& wo, LobeSet lobes) const;

    // i in [0, size()).
    const Lobe& lobe(int i) const { return reinterpret_cast<const Lobe*>(lobes_->storage)[i]; }
    LobeFlags flags(int i) const { return lobes_->flags[size_t(i)]; }
    float alpha(int i) const { return lobes_->alphas[size_t(i)]; }
    bool isWithin(int i, const LobeMask& mask) const {
        return mask.has(flags(i), alpha(i)) && (mask.lobes >> i & 1) != 0;
    }
    const Rgb& weight(int i) const { return lobes_->weights[size_t(i)]; }
    // Whether light that the lobe scatters from wi to wo is reflected if both are on the same side of the shading
    // frame, and transmitted otherwise.
    bool hasSides(int i) const { return lobes_->hasSides[size_t(i)]; }

  private:
    // False where even the mirrored view is well above the surface, as nearly everywhere: this is asked at every hit.
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
        // Raw memory, because a Bsdf is made at every hit, and constructing sixteen lobes where two are used would be
        // wasteful.
        alignas(Lobe) std::byte storage[kMaxLobes * sizeof(Lobe)];
    };

    Frame frame_;
    std::optional<Frame> unbent_;  // the shading frame, where frame_ is a bent one
    Vec3 ng_{0, 0, 1};
    const Lobes* lobes_ = &own_;  // or those of another
    Lobes own_;
};
static_assert(std::is_trivially_destructible_v<Lobe>, "Bsdf does not destroy its lobes");

}  // namespace drc
