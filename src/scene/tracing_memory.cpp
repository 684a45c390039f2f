#include "scene/tracing_memory.h"

#include <fmt/core.h>

#include "scene/shapes/curves.h"

namespace drc {

MemoryClaim claimForTracing(const Scene& scene, const std::unordered_set<const void*>& built) {
    double triangles = 0, vertices = 0, pieces = 0;
    const auto count = [&](const std::vector<Primitive>& primitives) {
        for (const Primitive& p : primitives) {
            if (built.contains(p.mesh.get()) || built.contains(p.shape.get())) continue;
            if (p.mesh) {
                triangles += p.mesh->triangleCount();
                vertices += double(p.mesh->positions.size());
            } else if (const Curves* curves = p.shape->asCurves()) {
                pieces += curves->pieceCount();
            }
        }
    };
    count(scene.primitives);
    for (const ObjectDefinition& object : scene.objects) count(object.primitives);
    return MemoryClaim(
        triangles * kTracingBytesPerTriangle + vertices * kTracingBytesPerVertex + pieces * kTracingBytesPerCurvePiece,
        fmt::format("tracing rays in a scene of {:.3g} triangles and {:.3g} pieces of curves", triangles, pieces));
}

}  // namespace drc
