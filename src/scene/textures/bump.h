// Relief: the shading frame of a surface that is displaced along its normal by a height field (bump mapping, PBR 3e,
// section 9.3) or that has a normal map (PBR 4e, section 10.5.3).
#pragma once
#include "math/frame.h"
#include "scene/textures/texture.h"

namespace drc {

// The frame after displacement. `shading` is the frame before displacement, at.n its normal; at.dpdu and at.dpdv are
// the derivatives of position on the undisplaced surface. displacement: in world units. dndu and dndv, the derivatives
// of the shading normal, matter only for displacements that are large relative to the radius of curvature. The new
// normal stays on the side of shading.n, and the new s follows the displaced dpdu. If the derivatives are degenerate,
// `shading` is returned.
Frame bumpFrame(const TextureContext& at, const Frame& shading, const FloatTexture& displacement,
                const Vec3& dndu = Vec3(0.f), const Vec3& dndv = Vec3(0.f));

// The normal is 2 colour - 1, for colours in [0, 1]: x and y are its components along the directions of increasing u
// and v, z the one along the shading normal, as in glTF and OpenGL. v is that of the mesh's texture coordinates
// (at.dpdv) even where they are mirrored; pbrt uses a right-handed frame there, which turns the relief inside out. If z
// is not positive or the colour is not finite, `shading` is returned, so that the new normal stays on the side of
// shading.n.
Frame normalMapFrame(const TextureContext& at, const Frame& shading, const RgbTexture& normals);

}  // namespace drc
