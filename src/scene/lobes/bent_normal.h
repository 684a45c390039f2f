// Shading normals of smooth meshes and of relief lean away from the geometric normal. A viewer above the surface may
// then be below their horizon, where no lobe reflects anything towards it, or a mirror would show it the inside of the
// surface: black wedges on bevels, and black specks in relief at grazing angles. There the normal that the viewer meets
// is bent towards the geometric normal, as far as is needed and no farther, so that it is continuous in both normals
// and in the direction of view. (Cycles does so for the mirrored view; its diffuse lobes do not ask where the view is.)
#pragma once
#include <optional>

#include "math/vec.h"

namespace drc {

// The direction that must stay above a horizon, on the viewer's side: the view above that of the shading normal, or its
// mirror image above that of the geometric normal.
enum class KeepAbove { View, MirroredView };

// The sine of the greatest elevation that bending keeps: what is higher needs none.
inline constexpr float kElevationKept = 0.01f;

// None where `shading` may stay as it is. All vectors are unit; the normals are on the same side of the surface, and
// wo, the direction towards the viewer, on either. With KeepAbove::View, the view is raised above the horizon of the
// shading normal; with KeepAbove::MirroredView, its mirror image at the shading normal above the surface, which implies
// the former.
std::optional<Vec3> bentNormal(const Vec3& shading, const Vec3& geometric, const Vec3& wo, KeepAbove what);

}  // namespace drc
