// Bump mapping: the shading frame after a height field displaces the surface along its normal (PBR 3e, section 9.3).
#pragma once
#include "math/frame.h"
#include "scene/texture.h"

namespace drc {

// `shading` is the frame before displacement, at.n its normal, and at.dpdu and at.dpdv are the derivatives of position
// on the undisplaced surface. dndu and dndv, the derivatives of the shading normal, matter only for displacements that
// are large relative to the radius of curvature. The new normal stays on the side of shading.n, and the new s follows
// the displaced dpdu. If the derivatives are degenerate, `shading` is returned.
Frame bumpFrame(const TextureContext& at, const Frame& shading, const FloatTexture& displacement,
                const Vec3& dndu = Vec3(0.f), const Vec3& dndv = Vec3(0.f));

}  // namespace drc
