// Memory that ray tracing needs in addition to the scene itself. claimForTracing() claims it (base/memory.h) before the
// acceleration structures are allocated. Code that turns a few bytes of a file into millions of primitives
// (subdivision, curves) claims it already when it creates them, by the constants below, because its error can name a
// place in the file.
#pragma once
#include <unordered_set>

#include "base/memory.h"
#include "scene/scene.h"

namespace drc {

// Measured peak memory, in bytes: Embree's BVH, its build buffers and the copy of the mesh for shading, together.
inline constexpr double kTracingBytesPerTriangle = 120, kTracingBytesPerVertex = 32;
inline constexpr double kTracingBytesPerCurvePiece = 104;

// Claims the memory for all meshes and curves of the scene, counting each object once and without those in `built`
// (addresses of TriangleMesh and Shape). Throws Error if less memory is available.
MemoryClaim claimForTracing(const Scene& scene, const std::unordered_set<const void*>& built = {});

}  // namespace drc
