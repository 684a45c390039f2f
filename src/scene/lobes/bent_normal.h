// Shading normals of smooth meshes and of relief lean away from the geometric normal. A viewer above the surface may
// then be below the horizon of the shading normal, where no lobe reflects anything, or a mirror would reflect the view
// into the surface: black wedges on bevels, and black specks in relief at grazing angles. In these cases the shading
// normal is bent towards the geometric normal, no farther than needed, so that it is continuous in both normals and in
// the direction of view. (Cycles does this for the mirrored view only; its diffuse lobes do not depend on the side of
// the view.)
#pragma once
#include <optional>

#include "math/vec.h"

namespace drc {

// Which direction must be above which horizon, on the viewer's side. View: the view above the horizon of the shading
// normal. MirroredView: the view, mirrored about the shading normal, above the surface (the horizon of the geometric
// normal).
enum class KeepAbove { View, MirroredView };

// Bending raises a direction to this elevation at most (sine of the angle above the horizon), so higher directions need
// no bending.
inline constexpr float kElevationKept = 0.01f;

// Returns the bent shading normal, or none if `shading` may stay as it is. All vectors are unit. The normals are on the
// same side of the surface; wo, the direction towards the viewer, may be on either side. KeepAbove::MirroredView is the
// stricter condition: it implies the one of KeepAbove::View.
std::optional<Vec3> bentNormal(const Vec3& shading, const Vec3& geometric, const Vec3& wo, KeepAbove what);

}  // namespace drc
