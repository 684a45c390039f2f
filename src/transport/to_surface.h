// Follows a ray through surfaces that do not stop it.
#pragma once
#include "transport/ray_queries.h"

namespace drc {

// Follows the ray to the next surface with a material, through those without one. met(hit) is called for that surface,
// and for emitters on the way. Escaped: there is no such surface, and `ray` is the last segment. Lost: there were too
// many surfaces, and no light may be taken from there. any, found: the result of accel.find for the ray.
// goesOn(ray, length) is called for each segment of the way, before what it leads to; if it returns false, the path
// ends on that segment, and the result is Scattered.
enum class Arrival { Surface, Escaped, Lost, Scattered };
template <class Met, class GoesOn>
inline Arrival toSurface(const Accel& accel, Ray& ray, Accel::Found& found, bool any, SurfaceInteraction& hit,
                         Met&& met, GoesOn&& goesOn) {
    for (int passed = 0; passed <= kMaxPassThrough; ++passed) {
        if (any) accel.describe(ray, found, hit);
        if (!goesOn(ray, any ? hit.t : kInfinity)) return Arrival::Scattered;
        if (!any) return Arrival::Escaped;
        const bool ends = hit.primitive->material != nullptr;
        if (ends || hit.primitive->areaLight) met(hit);
        if (ends) return Arrival::Surface;
        ray = hit.onward(ray);
        any = accel.find(ray, found);
    }
    return Arrival::Lost;
}
// Overload for empty space; ignores any media along the way.
template <class Met>
inline Arrival toSurface(const Accel& accel, Ray& ray, SurfaceInteraction& hit, Met&& met) {
    Accel::Found found;
    const bool any = accel.find(ray, found);
    return toSurface(accel, ray, found, any, hit, met, [](const Ray&, float) { return true; });
}

}  // namespace drc
