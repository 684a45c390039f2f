// The rays that the renderer traces, for benchmarks that compare it with Embree alone. In a program that links this,
// the renderer's calls of rtcIntersect1 and rtcOccluded1 come here first, are counted or noted, and are passed on: what
// that costs, an indirect call and a branch or two for each ray, is counted against the renderer.
#pragma once
#include <embree3/rtcore.h>

#include <cstdint>
#include <vector>

#include "accel/intersect_context.h"

namespace drc::benchmarks {

struct RecordedRay {
    float o[3], d[3];
    float tMax, time;
    bool shadow;
};

// Rays that all threads have traced since the program's start; valid only while a single thread traces.
uint64_t raysTraced();

// Appends all rays to `rays` from here on; null stops it. Only one thread may trace meanwhile.
void recordRays(std::vector<RecordedRay>* rays);

// Embree's own functions, and the scene of the last ray that was recorded.
struct BareEmbree {
    void (*intersect)(RTCScene, RTCIntersectContext*, RTCRayHit*);
    void (*occluded)(RTCScene, RTCIntersectContext*, RTCRay*);
    RTCScene scene;
};
BareEmbree bareEmbree();

// Traces the rays one by one by Embree alone. met(const RTCRayHit&) returns a number for each nearest hit. The sum of
// these and of the blocked shadow rays depends on every ray, so that none is optimised away.
template <typename Met>
float replay(const std::vector<RecordedRay>& rays, Met met) {
    const BareEmbree embree = bareEmbree();
    ShapeHit shape;
    IntersectContext context(shape);
    float sum = 0;
    for (const RecordedRay& r : rays) {
        RTCRayHit q;
        q.ray = {r.o[0], r.o[1], r.o[2], 0, r.d[0], r.d[1], r.d[2], r.time, r.tMax, ~0u, 0, 0};
        if (r.shadow) {
            embree.occluded(embree.scene, &context, &q.ray);
            sum += q.ray.tfar < 0;
        } else {
            q.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            q.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            embree.intersect(embree.scene, &context, &q);
            if (q.hit.geomID != RTC_INVALID_GEOMETRY_ID) sum += met(q);
        }
    }
    return sum;
}

// CPU time of this thread: what others do on the machine is not counted but for its effect on the caches.
double threadSeconds();

}  // namespace drc::benchmarks
