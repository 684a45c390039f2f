// Relief: the shading frame after a height field displaces the surface along its normal (bump mapping, PBR 3e, section
// 9.3), or as a normal map says (PBR 4e, section 10.5.3).
#pragma once
#include "math/frame.h"
#include "scene/textures/texture.h"

namespace drc {

// `shading` is the frame before displacement, at.n its normal, and at.dpdu and at.dpdv are the derivatives of position
// on the undisplaced surface. dndu and dndv, the derivatives of the shading normal, matter only for displacements that
// are large relative to the radius of curvature. The new normal stays on the side of shading.n, and the new s follows
// the displaced dpdu. If the derivatives are degenerate, `shading` is returned.
Frame bumpFrame(const TextureContext& at, const Frame& shading, const FloatTexture& displacement,
                const Vec3& dndu = Vec3(0.f), const Vec3& dndv = Vec3(0.f));

// The colours of the map, as displays of 0 to 1, are 0.5 + 0.5 times the components of the normal along the directions
// of increasing u and v and along the shading normal, as of glTF and OpenGL. v is that of the mesh's texture
// coordinates (at.dpdv), also where they are mirrored: pbrt, which takes a right-handed frame there, turns the relief
// inside out. The new normal stays on the side of shading.n; where the map says otherwise, or nothing, `shading` is
// returned.
Frame normalMapFrame(const TextureContext& at, const Frame& shading, const RgbTexture& normals);

}  // namespace drc
