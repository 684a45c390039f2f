// A BSDF seen from one direction, through some of its lobes: what does not depend on the other direction is computed
// once, for all the light samples, map samples and new directions at a point.
#pragma once
#include "scene/lobes/bsdf.h"

namespace drc {

class BsdfView {
  public:
    // wo: unit, world space, away from the surface. The Bsdf must outlive the view.
    BsdfView(const Bsdf& bsdf, const Vec3& wo, const LobeMask& mask = LobeFlags::All,
             TransportMode mode = TransportMode::Radiance);

    const Bsdf& bsdf() const { return bsdf_; }
    // Whether one of its lobes is not specular.
    bool hasNonSpecular() const;
    // Sum of the non-specular lobes; wi in world space.
    Rgb f(const Vec3& wi) const { return evaluate(wi).f; }
    // f(wi) and the pdf of sample() per solid angle, both without the specular lobes. Where f is zero the pdf may be
    // returned as zero too.
    LobeValue evaluate(const Vec3& wi) const;
    // Chooses a lobe in proportion to an estimate of its albedo. None: there is no lobe, or no light. If the sampled
    // lobe is non-specular, f and pdf are those of all non-specular lobes together.
    std::optional<BsdfSample> sample(float uLobe, const Vec2& u) const;

  private:
    struct Choice {
        int lobe;
        LobeFlags flags;
        float probability;
    };
    // The sums over all non-specular lobes except `one`; wi in the shading frame.
    LobeValue allBut(const Choice* one, const Vec3& wi, LobeFlags side) const;
    LobeFlags sideOf(const Vec3& wiWorld) const;
    // Whether a lobe scatters light from wi, in the shading frame and on this geometric side.
    bool scatters(const Choice& choice, const Vec3& wi, LobeFlags side) const;

    const Bsdf& bsdf_;
    Vec3 woWorld_, wo_;
    float woSide_;  // cosine of wo to the geometric normal
    TransportMode mode_;
    LobeFlags sides_ = LobeFlags::None;  // of all lobes within the mask
    int count_ = 0;                      // lobes within the mask; also 0 if none can be chosen
    Choice choices_[Bsdf::kMaxLobes];
};

}  // namespace drc
