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

bool shadowed(const Accel& accel, const SpawnPoint& from, const Vec3& d, float distance, float time) {
    const Vec3 o = from.towards(d);
    if (std::isinf(distance)) return accel.occluded(o, d, kInfinity, time);
    // The segment ends short of the target, so that the target's own surface does not occlude it: by a share of the
    // distance, and by the rounding error of the target's position.
    const Vec3 target = from.p + d * distance;
    const Vec3 left = target - o;
    const float way = length(left);
    const float rounding = 1e-6f * std::max({std::abs(target.x), std::abs(target.y), std::abs(target.z)});
    const float tMax = way * 0.9999f - rounding;
    return tMax > 0 && accel.occluded(o, left * (1 / way), tMax, time);
}

}  // namespace drc
