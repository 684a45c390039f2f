// The memory that ray tracing needs in addition to the scene itself. It is claimed (memory.h) before it is allocated,
// and already when a few bytes of a file create millions of primitives, because there the error can name a place in the
// file.
#pragma once
#include "base/memory.h"
#include "scene/scene.h"

namespace drc {

// Embree's BVH and its build buffers, and the copy of a mesh that shading reads: measured peaks.
inline constexpr double kTracingBytesPerTriangle = 120, kTracingBytesPerVertex = 32;
inline constexpr double kTracingBytesPerCurvePiece = 104;

// Claims the memory for all meshes and curves of the scene, counting each object once. Throws Error if there is less.
MemoryClaim claimForTracing(const Scene& scene);

}  // namespace drc
