// The BSDF at one point of a surface: a weighted sum of lobes in the shading frame (PBR 3e, chapters 8 and 9).
//
// All directions are unit vectors in world space and point away from the surface. f is the BSDF itself, without the
// cosine. Which of the reflection and transmission lobes take part is decided by the geometric normal, their values
// by the shading frame, so that shading normals leak no light (PBR 3e, section 9.1).
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>

#include "math/frame.h"
#include "scene/lobes.h"

namespace drc {

struct BsdfSample {
    Vec3 wi;            // world space
    Rgb f;              // BSDF value; for a specular lobe f / pdf is the weight divided by |cos|
    float pdf = 0;      // per solid angle; for a specular lobe the probability of having chosen it
    LobeFlags flags{};  // of the lobe that was sampled
    float eta = 1;      // relative index of refraction that was crossed, 1 if none; for Russian roulette
    bool isSpecular() const { return any(flags & LobeFlags::Specular); }
    bool isTransmission() const { return any(flags & LobeFlags::Transmission); }
};

class Bsdf {
  public:
    static constexpr int kMaxLobes = 12;

    Bsdf() = default;
    // ng: geometric normal. Neither normal need face the viewer.
    Bsdf(const Frame& shading, const Vec3& ng) : frame_(shading), ng_(ng) {}
    Bsdf(const Bsdf& other);
    Bsdf& operator=(const Bsdf& other);

    // Lobes beyond kMaxLobes and lobes of zero weight are not added; materials are checked against kMaxLobes when
    // the scene is built.
    void add(const Lobe& lobe, const Rgb& weight = Rgb(1.f));

    // True if any lobe has all of these flags.
    bool has(LobeFlags flags) const;
    // True if any lobe lies within the mask.
    bool hasWithin(LobeFlags mask) const;
    bool hasNonSpecular() const { return hasWithin(LobeFlags::NonSpecular); }
    // Light that arrives from behind is seen as more than what a specular path brings.
    bool hasWideTransmission() const;
    bool hasSpecular() const { return has(LobeFlags::Specular); }
    int size() const { return count_; }

    // Sum of the non-specular lobes within mask; 0 for specular lobes.
    Rgb f(const Vec3& wo, const Vec3& wi, LobeFlags mask = LobeFlags::All,
          TransportMode mode = TransportMode::Radiance) const;
    // f and pdf together, for less than the two apart. Where f is zero the density is not asked for, and is zero.
    struct Value {
        Rgb f{0.f};
        float pdf = 0;
    };
    Value evaluate(const Vec3& wo, const Vec3& wi, LobeFlags mask = LobeFlags::All,
                   TransportMode mode = TransportMode::Radiance) const;
    // Density of sample() for the same mask, per solid angle; 0 for specular lobes.
    float pdf(const Vec3& wo, const Vec3& wi, LobeFlags mask = LobeFlags::All) const;
    // Chooses among the lobes within mask in proportion to an estimate of their albedo. None: no lobe, or no light.
    // If the sampled lobe is non-specular, f and pdf are those of all non-specular lobes within mask.
    std::optional<BsdfSample> sample(const Vec3& wo, float uLobe, const Vec2& u, LobeFlags mask = LobeFlags::All,
                                     TransportMode mode = TransportMode::Radiance) const;

    const Frame& frame() const { return frame_; }
    const Vec3& ng() const { return ng_; }

    // Albedo towards wo, an estimate for AOVs and for choosing lobes.
    Rgb albedo(const Vec3& wo, LobeFlags mask = LobeFlags::All) const;

  private:
    using Probabilities = std::array<float, kMaxLobes>;

    const Lobe& lobe(int i) const { return reinterpret_cast<const Lobe*>(storage_)[i]; }
    // Probability of choosing each lobe; returns how many match the mask (0 if none can be chosen).
    int choices(const Vec3& woLocal, LobeFlags mask, Probabilities& p) const;
    Rgb fLocal(const Vec3& wo, const Vec3& wi, bool reflects, LobeFlags mask, TransportMode mode) const;
    float pdfLocal(const Vec3& wo, const Vec3& wi, LobeFlags mask, const Probabilities& p) const;

    Frame frame_;
    Vec3 ng_{0, 0, 1};
    int count_ = 0;
    std::array<LobeFlags, kMaxLobes> flags_;
    std::array<Rgb, kMaxLobes> weights_;
    // Raw, because a Bsdf is made at every hit and to construct twelve lobes for the two in use would be a waste.
    alignas(Lobe) std::byte storage_[kMaxLobes * sizeof(Lobe)];
};
static_assert(std::is_trivially_destructible_v<Lobe>, "Bsdf does not destroy its lobes");

}  // namespace drc
