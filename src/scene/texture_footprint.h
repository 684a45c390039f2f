// What part of a surface one texture lookup averages over: the ellipse in which a cone of rays meets it.
#pragma once
#include "scene/texture.h"

namespace drc {

// Fills in at's footprint from a cone that is `width` wide where it arrives, from the direction wo, at a surface with
// the geometric normal ng; both are unit vectors. The ellipse lies in the plane of ng: as wide as the cone across its
// direction and longer along it, the more so the more it grazes. at.dpdu and at.dpdv must be known.
void setFootprint(TextureContext& at, float width, const Vec3& ng, const Vec3& wo);

}  // namespace drc
