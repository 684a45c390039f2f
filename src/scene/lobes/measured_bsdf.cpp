#include "scene/lobes/measured_bsdf.h"

#include "scene/lobes/lobe_sampling.h"

namespace drc {

LobeSample MeasuredBsdf::sample(const Vec3& wo, float, const Vec2& u, TransportMode) const {
    if (wo.z == 0) return {};
    const std::optional<Vec3> wi = table_->sample(wo.z < 0 ? -wo : wo, u);
    if (!wi) return {};
    return sampleTowards(*this, wo, wo.z < 0 ? -*wi : *wi);
}

}  // namespace drc
