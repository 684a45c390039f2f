#include "ray_recorder.h"

#include <dlfcn.h>

#include <cstdlib>
#include <ctime>

namespace drc::benchmarks {
namespace {

std::vector<RecordedRay>* recording = nullptr;
RTCScene recordedScene = nullptr;
uint64_t traced = 0;

template <typename F>
F embreeFunction(const char* name) {
    const auto f = reinterpret_cast<F>(dlsym(RTLD_NEXT, name));
    if (f == nullptr) std::abort();
    return f;
}
const auto embreeIntersect1 = embreeFunction<decltype(BareEmbree::intersect)>("rtcIntersect1");
const auto embreeOccluded1 = embreeFunction<decltype(BareEmbree::occluded)>("rtcOccluded1");

void record(RTCScene scene, const RTCRay& r, bool shadow) {
    recordedScene = scene;
    recording->push_back({{r.org_x, r.org_y, r.org_z}, {r.dir_x, r.dir_y, r.dir_z}, r.tfar, r.time, shadow});
}

}  // namespace

uint64_t raysTraced() { return traced; }

void recordRays(std::vector<RecordedRay>* rays) { recording = rays; }

BareEmbree bareEmbree() { return {embreeIntersect1, embreeOccluded1, recordedScene}; }

double threadSeconds() {
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

}  // namespace drc::benchmarks

// The program's own definitions precede those of shared libraries.
extern "C" void rtcIntersect1(RTCScene scene, RTCIntersectContext* context, RTCRayHit* rayhit) {
    using namespace drc::benchmarks;
    ++traced;
    if (recording) record(scene, rayhit->ray, false);
    embreeIntersect1(scene, context, rayhit);
}
extern "C" void rtcOccluded1(RTCScene scene, RTCIntersectContext* context, RTCRay* ray) {
    using namespace drc::benchmarks;
    ++traced;
    if (recording) record(scene, *ray, true);
    embreeOccluded1(scene, context, ray);
}
