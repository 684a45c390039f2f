// What paths of all kinds have in common: how they get to the next surface that matters, where they end at the latest,
// and whether anything stands between two points.
#pragma once
#include "accel/accel.h"

namespace drc {

// Rows of surfaces without material, or emitters without a body, end here.
constexpr int kMaxPassThrough = 256;
// Chains of mirrors and glass end here.
constexpr int kMaxSpecularChain = 64;

// Cone of a path after a non-specular bounce. Wider ones would save a little memory traffic, but what textures average
// over must not leave the surfaces that they are on: a leaf whose picture stands on white would be too bright.
constexpr float kDiffuseSpread = 0.005f;
inline float spreadAfter(const BsdfSample& s, float spread) {
    return s.isSpecular() ? spread : std::max(spread, kDiffuseSpread);
}

// Nearest surface that has a material or emits; passes through the others, though not through any number of them: then
// it is one of those. False: the ray escapes. The ray becomes the last part of its way.
bool nextSurface(const Accel& accel, Ray& ray, SurfaceInteraction& hit);
bool nextSurface(const Accel& accel, Ray& ray, const Accel::Found& found, SurfaceInteraction& hit);

// Whether anything stands between a point on a surface and another, `distance` away along d (unit). Infinity: outside.
bool shadowed(const Accel& accel, const SpawnPoint& from, const Vec3& d, float distance, float time);

}  // namespace drc
