// The footprint over which a texture lookup averages: the ellipse in which a ray cone intersects the surface.
#pragma once
#include "scene/textures/texture.h"

namespace drc {

// Sets the footprint in `at` for a cone of the given width (world units) that arrives from direction wo at a surface
// with the geometric normal ng; both are unit. The ellipse lies in the plane of ng. Across wo it is as wide as the
// cone; along the projection of wo it is longer by 1 / |cos|, up to a limit. at.dpdu and at.dpdv must be set.
void setFootprint(TextureContext& at, float width, const Vec3& ng, const Vec3& wo);

}  // namespace drc
