// Segments of paths that lead through a medium: where the path is scattered on the way, if it is.
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
    // On the ray, which is in a medium, at a distance from its origin.
    MediumVertex(const Ray& ray, float distance)
        : p(ray.o + ray.d * distance),
          wo(-ray.d),
          medium(ray.medium),
          time(ray.time),
          footprint(ray.coneWidth + ray.coneSpread * distance),
          coneSpread(ray.coneSpread) {}
    // No surface is near.
    SpawnPoint spawnPoint() const { return {p, Vec3(0.f), footprint, 0}; }
    // A ray that leaves p in direction d (unit). Its cone grows with the given spread, but at least with that of the
    // arriving ray.
    Ray spawnRay(const Vec3& d, float spread) const;
};

struct MediumSegment {
    // Where the path is scattered, as a distance from the segment's beginning; none: it arrives at the end.
    std::optional<float> scattered;
    // Factor on the throughput: T / probability of arriving, or sigma_s T / pdf of the distance if scattered.
    Rgb weight{1.f};
    float passing = 1;  // the probability of arriving at the end
};

// Samples what happens along a segment. length: at most infinite. throughput: of the path, which tells what matters
// most. u: in the unit square.
MediumSegment sampleSegment(const Medium& medium, float length, const Rgb& throughput, const Vec2& u);

}  // namespace drc
