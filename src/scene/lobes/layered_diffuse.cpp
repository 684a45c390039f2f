#include "scene/lobes/layered_diffuse.h"

namespace drc {

LayeredDiffuse::LayeredDiffuse(const Rgb& albedo, const CosineCurve& curve, const CoatColour& colour, Side side)
    : albedo_(albedo), curve_(curve), colour_(colour), transmits_(side == Side::Transmits) {
    const float mean = curve.mean();
    perMean_ = mean > 0 ? kInvPi / mean : 0;
}

LayeredDiffuse LayeredDiffuse::rough(const Rgb& albedo, float roughness, const LayersAbove& above, DiffusePart part) {
    LayeredDiffuse lobe(albedo, above);
    lobe.rough_.emplace(albedo, roughness, part);
    return lobe;
}

Rgb LayeredDiffuse::f(const Vec3& wo, const Vec3& wi) const {
    const Rgb below = rough_ ? rough_->f(wo, wi) * kPi : albedo_;
    return below * colour_.bothWays(wo, wi) * (curve_.at(wo.z) * curve_.at(wi.z) * perMean_);
}

LobeSample LayeredDiffuse::sample(const Vec3& wo, float, const Vec2& u, TransportMode) const {
    LobeSample s;
    s.wi = sampleCosineHemisphere(u);
    if ((wo.z < 0) != transmits_) s.wi.z = -s.wi.z;
    s.f = f(wo, s.wi);
    s.pdf = pdf(wo, s.wi);
    s.flags = flags();
    return s;
}

}  // namespace drc
