// Ray queries shared by all path-based integrators: visibility and transmittance between two points. Also the limits on
// surfaces that a ray passes through and on specular vertices.
#pragma once
#include "accel/accel.h"

namespace drc {

// Maximum number of surfaces that one query passes through: those without material, whether they emit or not;
// transmittance() passes through all surfaces.
constexpr int kMaxPassThrough = 256;
// Maximum number of specular vertices of a path in total: a non-specular vertex does not restart the count.
constexpr int kMaxSpecularChain = 64;

// Spread of the ray cone after a non-specular bounce. A wider cone would save a little memory traffic, but texture
// filtering must not reach beyond the object: a leaf cut out of an image with a white background would become too
// bright.
constexpr float kDiffuseSpread = 0.005f;
inline float spreadAfter(const BsdfSample& s, float spread) {
    return s.isSpecular() ? spread : std::max(spread, kDiffuseSpread);
}

// Whether anything blocks the segment from a surface point along d (unit) to `distance`, which is infinity for lights
// at infinity.
bool shadowed(const Accel& accel, const SpawnPoint& from, const Vec3& d, float distance, float time);
// Like shadowed(), but for the rays of paths: surfaces that have holes for shadow rays alone (pbrt's shadowalpha) block
// them everywhere.
bool screened(const Accel& accel, const SpawnPoint& from, const Vec3& d, float distance, float time);
// screened() between two surface points; d (unit) points from `from` to `to`.
bool screened(const Accel& accel, const SpawnPoint& from, const Vec3& d, const SpawnPoint& to, float time);
// Whether anything blocks a camera's view of a surface point: d and distance lead from the point to the lens.
bool hiddenFromLens(const Accel& accel, const SurfaceInteraction& at, const Vec3& d, float distance);
// Transmittance of the media along the segment of shadowed(), ignoring all surfaces. medium: the medium in which the
// segment begins; null: empty space.
Rgb transmittance(const Accel& accel, const SpawnPoint& from, const Medium* medium, const Vec3& d, float distance,
                  float time);

}  // namespace drc
