#include "integrators/ray_queries.h"

namespace drc {

bool nextSurface(const Accel& accel, Ray& ray, SurfaceInteraction& hit) {
    Accel::Found found;
    return accel.find(ray, found) && nextSurface(accel, ray, found, hit);
}

bool nextSurface(const Accel& accel, Ray& ray, const Accel::Found& found, SurfaceInteraction& hit) {
    accel.describe(ray, found, hit);
    for (int i = 0; i < kMaxPassThrough; ++i) {
        if (hit.primitive->material || hit.primitive->areaLight) return true;
        ray = hit.spawnRay(ray.d);
        if (!accel.intersect(ray, hit)) return false;
    }
    // Not false, since the caller would then take the sky for what lies behind.
    return true;
}

namespace {

// The segment from a surface point along d to `distance`, without its ends.
struct Segment {
    Vec3 o, d;
    float tMax;

    Segment(const SpawnPoint& from, const Vec3& direction, float distance)
        : o(from.towards(direction)), d(direction), tMax(kInfinity) {
        if (std::isinf(distance)) return;
        // It ends short of the target, so that the target's own surface does not occlude it: by a share of the
        // distance, and by the rounding error of the target's position.
        const Vec3 target = from.p + direction * distance, left = target - o;
        const float way = length(left);
        tMax = way * 0.9999f - roundingError(target);
        d = left * (1 / way);
    }
    // Between two surface points, each on the side of its surface that faces the other: points on both sides of one
    // surface do not see each other.
    Segment(const SpawnPoint& from, const Vec3& direction, const SpawnPoint& to)
        : o(from.towards(direction)), d(direction), tMax(0) {
        const Vec3 left = to.towards(-direction) - o;
        const float way = length(left);
        if (!(dot(left, direction) > 0)) return;
        tMax = way;
        d = left * (1 / way);
    }
};

bool isScreened(const Accel& accel, const Segment& segment, float time) {
    Ray ray;
    ray.o = segment.o;
    ray.d = segment.d;
    ray.tMax = segment.tMax;
    ray.time = time;
    SurfaceInteraction hit;
    for (int i = 0; i < kMaxPassThrough && ray.tMax > 0 && accel.intersect(ray, hit); ++i) {
        if (hit.primitive->material) return true;
        const float left = ray.tMax - hit.t;
        ray = hit.spawnRay(ray.d);
        ray.tMax = left;
    }
    return false;
}

}  // namespace

bool shadowed(const Accel& accel, const SpawnPoint& from, const Vec3& d, float distance, float time) {
    const Segment segment(from, d, distance);
    return segment.tMax > 0 && accel.occluded(segment.o, segment.d, segment.tMax, time);
}

bool screened(const Accel& accel, const SpawnPoint& from, const Vec3& d, float distance, float time) {
    if (!accel.hasShadowMasks()) return shadowed(accel, from, d, distance, time);
    return isScreened(accel, Segment(from, d, distance), time);
}

bool screened(const Accel& accel, const SpawnPoint& from, const Vec3& d, const SpawnPoint& to, float time) {
    const Segment segment(from, d, to);
    if (accel.hasShadowMasks()) return isScreened(accel, segment, time);
    return segment.tMax > 0 && accel.occluded(segment.o, segment.d, segment.tMax, time);
}

}  // namespace drc
