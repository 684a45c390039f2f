// A BSDF for one direction wo, restricted to a mask of lobes. Everything that does not depend on wi is computed once,
// and shared by all light samples, map samples and sampled directions at a point.
#pragma once
#include "scene/lobes/bsdf.h"

namespace drc {

class BsdfView {
  public:
    // wo: unit, world space, away from the surface. The Bsdf must outlive the view.
    BsdfView(const Bsdf& bsdf, const Vec3& wo, const LobeMask& mask = LobeFlags::All,
             TransportMode mode = TransportMode::Radiance);

    const Bsdf& bsdf() const { return bsdf_; }
    // Whether any lobe within the mask is non-specular.
    bool hasNonSpecular() const;
    // Sum of the non-specular lobes; wi in world space.
    Rgb f(const Vec3& wi) const { return evaluate(wi).f; }
    // f(wi) and the pdf of sample() per solid angle, both for the non-specular lobes only. Where f is zero, the
    // returned pdf may be zero in place of the true density.
    LobeValue evaluate(const Vec3& wi) const;
    // Chooses a lobe in proportion to its estimated albedo, then a direction. None if no lobe can be chosen or if f is
    // zero. If the sampled lobe is non-specular, f and pdf are those of all non-specular lobes together.
    std::optional<BsdfSample> sample(float uLobe, const Vec2& u) const;

  private:
    struct Choice {
        int lobe;
        LobeFlags flags;
        float probability;
    };
    // The sums of f and pdf over all non-specular lobes except `one` (null: over all). wi: in the shading frame. side:
    // see sideOf().
    LobeValue allBut(const Choice* one, const Vec3& wi, LobeFlags side) const;
    LobeFlags sideOf(const Vec3& wiWorld) const;
    // Whether the lobe scatters light from wi (in the shading frame). side: Reflection if wi is on the geometric side
    // of wo, otherwise Transmission.
    bool scatters(const Choice& choice, const Vec3& wi, LobeFlags side) const;

    const Bsdf& bsdf_;
    Vec3 woWorld_, wo_;
    float woSide_;  // cosine of wo to the geometric normal
    TransportMode mode_;
    LobeFlags sides_ = LobeFlags::None;  // union of the flags of all lobes within the mask
    int count_ = 0;                      // number of choices_: one per lobe within the mask; 0 if none can be chosen
    Choice choices_[Bsdf::kMaxLobes];
};

}  // namespace drc
