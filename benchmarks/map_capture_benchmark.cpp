// How near the capture of radiance maps comes to the speed of its rays, on one thread. The rays of some captures are
// recorded once; then captures and two kinds of replays of the recorded rays through bare Embree take turns, so that
// whatever else the machine does slows all alike:
//  - ray_limit: a path tracer whose shading is nearly free. At every surface it finds the normal and samples one
//    direction by the cosine and one towards a light, with a cheap generator, and then traces the recorded rays.
//  - bare: the rays and nothing else.
//
// DRC_BENCHMARK_SCENE: the pbrt file; by default the repository's quickstart scene.
#include <benchmark/benchmark.h>
#include <dlfcn.h>
#include <embree3/rtcore.h>
#include <fmt/core.h>

#include <cstdlib>
#include <ctime>
#include <numeric>
#include <vector>

#include "accel/accel.h"
#include "base/error.h"
#include "cache/map_capture.h"
#include "integrators/light_sampler.h"
#include "integrators/path_tracer.h"
#include "math/rng.h"
#include "math/warp.h"
#include "pbrt/scene_file.h"

namespace {

struct RecordedRay {
    float o[3], d[3];
    float tMax;
    bool shadow;
};

using Intersect1 = void (*)(RTCScene, RTCIntersectContext*, RTCRayHit*);
using Occluded1 = void (*)(RTCScene, RTCIntersectContext*, RTCRay*);
std::vector<RecordedRay>* recording = nullptr;
RTCScene recordedScene = nullptr;

// Embree's own functions, behind those that this program puts in front of them.
template <typename F>
F embreeFunction(const char* name) {
    const auto f = reinterpret_cast<F>(dlsym(RTLD_NEXT, name));
    if (f == nullptr) std::abort();
    return f;
}
const Intersect1 embreeIntersect1 = embreeFunction<Intersect1>("rtcIntersect1");
const Occluded1 embreeOccluded1 = embreeFunction<Occluded1>("rtcOccluded1");

void record(RTCScene scene, const RTCRay& r, bool shadow) {
    recordedScene = scene;
    recording->push_back({{r.org_x, r.org_y, r.org_z}, {r.dir_x, r.dir_y, r.dir_z}, r.tfar, shadow});
}

}  // namespace

// The renderer's calls of Embree come here first: the program's own definitions precede those of shared libraries.
// What that costs, an indirect call a ray, is counted against the capture.
extern "C" void rtcIntersect1(RTCScene scene, RTCIntersectContext* context, RTCRayHit* rayhit) {
    if (recording) record(scene, rayhit->ray, false);
    embreeIntersect1(scene, context, rayhit);
}
extern "C" void rtcOccluded1(RTCScene scene, RTCIntersectContext* context, RTCRay* ray) {
    if (recording) record(scene, *ray, true);
    embreeOccluded1(scene, context, ray);
}

namespace drc {
namespace {

constexpr int kMaps = 64;
constexpr uint64_t kSeed = 1;

// CPU time of this thread: what others do on the machine is not counted but for its effect on the caches.
double threadSeconds() {
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

struct Site {
    Vec3 p, ng;
    Frame frame;
    float footprint;
    uint64_t stream;
    std::vector<RecordedRay> rays;
};

// Points that the camera sees, well distributed over the film.
std::vector<Site> findSites(const Scene& scene, const PathTracer& tracer) {
    const PixelRegion region = scene.settings.region();
    std::vector<Site> sites;
    for (uint32_t i = 0; i < 64 * kMaps && sites.size() < kMaps; ++i) {
        Sampler sampler(kSeed, i);
        const Vec2 u = sampler.get2D();
        const Vec2 film(float(region.x0) + u.x * float(region.width()),
                        float(region.y0) + u.y * float(region.height()));
        const Vec2 uLens = sampler.get2D();
        PrimaryHit hit;
        if (!tracer.primaryHit(scene.camera->generateRay(film, uLens, sampler.get1D()).ray, sampler, hit)) continue;
        if (!hit.bsdf.hasNonSpecular()) continue;
        const SurfaceInteraction& at = hit.surface;
        sites.push_back({at.p,
                         at.ng,
                         mapFrame(faceForward(at.ng, at.wo), scene.camera->up()),
                         at.footprint,
                         hashCombine(kSeed, i),
                         {}});
    }
    return sites;
}

void capture(const PathTracer& tracer, const Site& site, CapturedMap& map) {
    captureMap(tracer, CaptureSettings{}, site.p, site.ng, site.frame, site.footprint, site.stream, map);
}

// What nearly free shading comes to at a hit: no material, texture, distribution or weight.
float shadeFreely(const RTCRayHit& q, Pcg32& rng) {
    const Vec3 d(q.ray.dir_x, q.ray.dir_y, q.ray.dir_z);
    const Vec3 p = Vec3(q.ray.org_x, q.ray.org_y, q.ray.org_z) + d * q.ray.tfar;
    const Vec3 n = faceForward(normalize(Vec3(q.hit.Ng_x, q.hit.Ng_y, q.hit.Ng_z)), -d);
    const Vec3 next = Frame::fromNormal(n).toWorld(sampleCosineHemisphere(rng.nextVec2()));
    const Vec3 light = normalize(Vec3(rng.nextVec2().x, 1, 0) - p);
    return dot(next, n) + std::max(0.f, dot(light, n));
}

// Returns a number that depends on every ray, so that none is optimised away.
float replay(const std::vector<RecordedRay>& rays, bool shade) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    Pcg32 rng(1);
    float sum = 0;
    for (const RecordedRay& r : rays) {
        RTCRayHit q;
        q.ray = {r.o[0], r.o[1], r.o[2], 0, r.d[0], r.d[1], r.d[2], 0, r.tMax, ~0u, 0, 0};
        if (r.shadow) {
            embreeOccluded1(recordedScene, &context, &q.ray);
            sum += q.ray.tfar < 0;
        } else {
            q.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            q.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            embreeIntersect1(recordedScene, &context, &q);
            const bool met = q.hit.geomID != RTC_INVALID_GEOMETRY_ID;
            sum += met && shade ? shadeFreely(q, rng) : float(met);
        }
    }
    return sum;
}

// What one of the contestants needed for all maps.
struct Times {
    explicit Times(size_t maps) : best(maps, 1e30) {}
    void add(size_t map, double seconds) {
        best[map] = std::min(best[map], seconds);
        total += seconds;
    }
    double fastest() const { return std::accumulate(best.begin(), best.end(), 0.0); }
    std::vector<double> best;  // each map's fastest turn
    double total = 0;
};

// An iteration captures and replays all maps once. The best_ counters add up each map's fastest turn.
void captureAndReplay(benchmark::State& state, const Scene& scene) {
    const Accel accel(scene);
    const LightSampler lights(scene);
    const PathTracer tracer(scene, accel, lights);
    std::vector<Site> sites = findSites(scene, tracer);
    if (sites.empty()) {
        state.SkipWithError("the camera sees nothing");
        return;
    }
    CapturedMap map;
    double segments = 0, shadows = 0;
    for (Site& site : sites) {
        recording = &site.rays;
        capture(tracer, site, map);
        recording = nullptr;
        for (const RecordedRay& r : site.rays) ++(r.shadow ? shadows : segments);
    }

    const size_t n = sites.size();
    Times captures(n), limit(n), bare(n);
    for (auto _ : state) {
        const double before = captures.total + limit.total + bare.total;
        for (size_t i = 0; i < n; ++i) {
            // Never the same map twice in a row: none may find its part of the scene in the caches.
            const size_t second = (i + n / 3) % n, third = (i + 2 * n / 3) % n;
            const double t0 = threadSeconds();
            capture(tracer, sites[i], map);
            benchmark::DoNotOptimize(map.radiance.data());
            const double t1 = threadSeconds();
            benchmark::DoNotOptimize(replay(sites[second].rays, true));
            const double t2 = threadSeconds();
            benchmark::DoNotOptimize(replay(sites[third].rays, false));
            const double t3 = threadSeconds();
            captures.add(i, t1 - t0);
            limit.add(second, t2 - t1);
            bare.add(third, t3 - t2);
        }
        state.SetIterationTime(captures.total + limit.total + bare.total - before);
    }
    const double maps = double(state.iterations()) * double(n);
    auto& c = state.counters;
    c["segments/map"] = segments / double(n);
    c["shadow_rays/map"] = shadows / double(n);
    c["maps/s"] = maps / captures.total;
    c["limit_maps/s"] = maps / limit.total;
    c["bare_Mrays/s"] = 1e-6 * (segments + shadows) * double(state.iterations()) / bare.total;
    c["share_of_ray_limit"] = limit.total / captures.total;
    c["share_of_bare"] = bare.total / captures.total;
    c["best_maps/s"] = double(n) / captures.fastest();
    c["best_share_of_ray_limit"] = limit.fastest() / captures.fastest();
    c["best_share_of_bare"] = bare.fastest() / captures.fastest();
}

std::string scenePath() {
    if (const char* path = std::getenv("DRC_BENCHMARK_SCENE")) return path;
    const std::string here = __FILE__;
    return here.substr(0, here.rfind("benchmarks/")) + "scenes/quickstart/scene.pbrt";
}

}  // namespace
}  // namespace drc

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    try {
        const auto scene = drc::pbrt::loadPbrtFile(drc::scenePath());
        benchmark::AddCustomContext("scene", drc::scenePath());
        benchmark::RegisterBenchmark("mapCapture",
                                     [&](benchmark::State& state) { drc::captureAndReplay(state, *scene); })
            ->Unit(benchmark::kMillisecond)
            ->UseManualTime();
        benchmark::RunSpecifiedBenchmarks();
    } catch (const drc::Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
    benchmark::Shutdown();
}
