// Segments of paths that lead through a medium: whether and where the path is scattered.
#pragma once
#include <optional>

#include "accel/spawn_point.h"
#include "scene/media/medium.h"
#include "scene/ray.h"

namespace drc {

// A point in a medium at which a path is scattered.
struct MediumVertex {
    Vec3 p{0.f};
    Vec3 wo{0.f};  // unit, towards the previous vertex
    const Medium* medium = nullptr;
    float time = 0;       // Ray::time
    float footprint = 0;  // width of the ray cone at p
    float coneSpread = 0;

    MediumVertex() = default;
    // The point at `distance` from the origin of a ray that is in a medium.
    MediumVertex(const Ray& ray, float distance)
        : p(ray.o + ray.d * distance),
          wo(-ray.d),
          medium(ray.medium),
          time(ray.time),
          footprint(ray.coneWidth + ray.coneSpread * distance),
          coneSpread(ray.coneSpread) {}
    // Without an offset, because no surface is near.
    SpawnPoint spawnPoint() const { return {p, Vec3(0.f), footprint, 0}; }
    // A ray that leaves p in direction d (unit). Its cone grows with the given spread, but at least with that of the
    // arriving ray.
    Ray spawnRay(const Vec3& d, float spread) const;
};

struct MediumSegment {
    // Distance from the segment's beginning at which the path is scattered; none: the path arrives at the end.
    std::optional<float> scattered;
    // Factor on the throughput: T / probability of arriving, or sigma_s T / pdf of the distance if scattered.
    Rgb weight{1.f};
    float passing = 1;  // the probability of arriving at the end
};

// Samples a path's interaction with the medium along a segment. length: may be infinite. throughput: of the path so
// far, which decides how often each colour channel is chosen. u: in the unit square.
MediumSegment sampleSegment(const Medium& medium, float length, const Rgb& throughput, const Vec2& u);

}  // namespace drc
