#include "transport/ray_queries.h"

namespace drc {

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

bool isScreened(const Accel& accel, const Segment& segment, float time, bool fromCamera = false) {
    Ray ray;
    ray.fromCamera = fromCamera;
    ray.o = segment.o;
    ray.d = segment.d;
    ray.tMax = segment.tMax;
    ray.time = time;
    SurfaceInteraction hit;
    for (int i = 0; i < kMaxPassThrough && ray.tMax > 0 && accel.intersect(ray, hit); ++i) {
        if (hit.primitive->material) return true;
        const float left = ray.tMax - hit.t;
        ray = hit.onward(ray);
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

bool hiddenFromLens(const Accel& accel, const SurfaceInteraction& at, const Vec3& d, float distance) {
    if (!accel.hidesFromCamera() && !accel.hidesFromDiffuse())
        return screened(accel, at.spawnPoint(), d, distance, at.time);
    return !at.primitive->visibleToCamera || isScreened(accel, Segment(at.spawnPoint(), d, distance), at.time, true);
}

Rgb transmittance(const Accel& accel, const SpawnPoint& from, const Medium* medium, const Vec3& d, float distance,
                  float time) {
    Rgb share(1.f);
    if (!accel.hasOpenMedia()) {
        if (medium) share = medium->transmittance(accel.lengthInMedium(distance));
        return share;
    }
    const Segment segment(from, d, distance);
    Ray ray;
    ray.o = segment.o;
    ray.d = segment.d;
    ray.tMax = segment.tMax;
    ray.time = time;
    ray.medium = medium;
    SurfaceInteraction hit;
    for (int i = 0; i < kMaxPassThrough && ray.tMax > 0; ++i) {
        const bool any = accel.intersect(ray, hit);
        if (ray.medium) share *= ray.medium->transmittance(accel.lengthInMedium(any ? hit.t : ray.tMax));
        if (!any || isBlack(share)) break;
        const float left = ray.tMax - hit.t;
        ray = hit.onward(ray);
        ray.tMax = left;
    }
    return share;
}

}  // namespace drc
