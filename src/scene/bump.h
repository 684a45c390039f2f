// Bump mapping: the shading frame of a surface that a height field displaces along its normal (PBR 3e, section 9.3).
#pragma once
#include "math/frame.h"
#include "scene/texture.h"

namespace drc {

// at.dpdu and at.dpdv are the derivatives of the position on the undisplaced surface, at.n its shading normal, and
// shading the frame about that normal. dndu and dndv, the derivatives of the shading normal, matter only for
// displacements that are not small against the surface's radius of curvature. The new normal stays on the side of
// shading.n, and its s is the displaced dpdu. Without usable derivatives the frame comes back as it was.
Frame bumpFrame(const TextureContext& at, const Frame& shading, const FloatTexture& displacement,
                const Vec3& dndu = Vec3(0.f), const Vec3& dndv = Vec3(0.f));

}  // namespace drc
