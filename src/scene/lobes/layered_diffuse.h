// A diffuse lobe under layers: f is a product of a function of wo and one of wi, so that it is reciprocal, and its
// albedo is known exactly (except for rough()).
#pragma once
#include <optional>

#include "math/warp.h"
#include "scene/lobes/layers_above.h"
#include "scene/lobes/lobe.h"
#include "scene/lobes/rough_diffuse.h"

namespace drc {

class LayeredDiffuse {
  public:
    enum class Side { Reflects, Transmits };
    // albedo: share that the base scatters of the light that passes the layers. The directional albedo of the lobe is
    // `albedo` times the layers' transmittance for wo.
    LayeredDiffuse(const Rgb& albedo, const LayersAbove& above, Side side = Side::Reflects)
        : LayeredDiffuse(albedo, above.passed, above.colour, side) {}
    LayeredDiffuse(const Rgb& albedo, const CosineCurve& curve, const CoatColour& colour = {},
                   Side side = Side::Reflects);
    // The base reflects as this part of RoughDiffuse. albedo() is then approximate: exact only if that part's albedo
    // does not depend on direction.
    static LayeredDiffuse rough(const Rgb& albedo, float roughness, const LayersAbove& above, DiffusePart part);

    LobeFlags flags() const {
        return LobeFlags::Diffuse | (transmits_ ? LobeFlags::Transmission : LobeFlags::Reflection);
    }
    static constexpr float alpha() { return kDiffuseAlpha; }
    Rgb f(const Vec3& wo, const Vec3& wi) const;
    float pdf(const Vec3& wo, const Vec3& wi) const {
        return sameHemisphere(wo, wi) == transmits_ ? 0 : absCosTheta(wi) * kInvPi;
    }
    LobeSample sample(const Vec3& wo, float, const Vec2& u, TransportMode) const;
    // Exact if the coat is clear and the surface is smooth.
    Rgb albedo(const Vec3& wo) const {
        return (rough_ ? rough_->albedo(wo) : albedo_) * curve_.at(wo.z) * colour_.at(wo.z);
    }

    bool isSeparable() const { return !rough_ || rough_->isSeparable(); }
    Rgb viewFactor(const Vec3& wo) const {
        return (rough_ ? rough_->viewFactor(wo) : albedo_) * curve_.at(wo.z) * colour_.oneWay(wo);
    }

  private:
    Rgb albedo_;
    CosineCurve curve_;
    float perMean_;  // 1 / (pi times the mean of the curve)
    CoatColour colour_;
    bool transmits_;
    std::optional<RoughDiffuse> rough_;  // none: smooth
};

}  // namespace drc
