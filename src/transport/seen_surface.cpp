#include "transport/seen_surface.h"

#include "transport/ray_queries.h"

namespace drc {

std::optional<SeenSurface> seenSurface(const Accel& accel, const Camera& camera, const Vec2& film) {
    const CameraRay first = camera.generateRay(film, Vec2(0.5f), 0.5f);
    if (!(first.weight > 0)) return {};
    Ray ray = first.ray;
    ray.fromCamera = true;
    for (int passed = 0; passed <= kMaxPassThrough; ++passed) {
        Accel::Found found;
        if (!accel.find(ray, found)) return {};
        SurfaceInteraction hit;
        accel.describe(ray, found, hit);
        if (hit.primitive->material || hit.primitive->areaLight)
            return SeenSurface{hit.primitive, found.instance, length(hit.p - first.ray.o), hit.p};
        ray = hit.onward(ray);
    }
    return {};
}

}  // namespace drc
