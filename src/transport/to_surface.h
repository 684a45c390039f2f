// Follows a ray through surfaces that do not stop it.
#pragma once
#include "transport/ray_queries.h"

namespace drc {

// Follows the ray to the next surface with a material, through surfaces without one. any, found: the result of
// accel.find for the ray. Calls goesOn(ray, length) for each segment of the way; if that returns false, the path ends
// on the segment, and the result is Scattered. Then calls met(hit) if the segment ends at the surface with a material
// or at an emitter. Escaped: there is no surface with a material, and `ray` is the last segment. Lost: there were too
// many surfaces on the way; the caller must not add any light from there.
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
