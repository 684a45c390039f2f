#include "transport/g_buffer_sample.h"

#include "transport/path_walker.h"

namespace drc {

void GBufferSample::recordMedium(const Accel& accel, const PathState& path, const MediumPassage& passage) {
    Rgb seen = path.throughput * path.passing;
    if (!passage.end.scattered) {
        albedo += seen * passage.ray.medium->scatteredIn(passage.length);
        return;
    }
    Ray ray = passage.ray;
    float distance = path.distance;
    SurfaceInteraction hit;
    Accel::Found found;
    const bool any = accel.find(ray, found);
    const auto goesOn = [&](const Ray& segment, float length) {
        if (segment.medium) {
            const float reach = accel.lengthInMedium(length);
            albedo += seen * segment.medium->scatteredIn(reach);
            seen *= segment.medium->transmittance(reach);
        }
        distance += length;
        return true;
    };
    const Arrival arrival = toSurface(
        accel, ray, found, any, hit, [&](const SurfaceInteraction& surface) { meet(surface); }, goesOn);
    if (arrival == Arrival::Surface) record(seen, hit, hit.bsdf(), distance);
}

}  // namespace drc
