// What tracing rays takes of memory beside the scene itself: asked for before it is taken, and already where a few
// bytes of a file make millions of primitives, for there the error has a place.
#pragma once
#include "base/memory.h"
#include "scene/scene.h"

namespace drc {

// Embree's tree and what it is built from, with the copy of a mesh that hits read: as measured, the most at a time.
inline constexpr double kTracingBytesPerTriangle = 120, kTracingBytesPerVertex = 32;
inline constexpr double kTracingBytesPerCurvePiece = 104;

// For all meshes and curves of the scene, each object once. Throws Error if there is less.
MemoryClaim claimForTracing(const Scene& scene);

}  // namespace drc
