// How near the capture of radiance maps comes to the speed of its rays, on one thread. The rays of some captures are
// recorded once; then captures and two kinds of replays of the recorded rays through bare Embree take turns, so that
// whatever else the machine does slows all alike:
//  - ray_limit: a path tracer whose shading is nearly free. At every surface it finds the normal and samples one
//    direction by the cosine and one towards a light, with a cheap generator, and then traces the recorded rays.
//  - bare: the rays and nothing else.
#include <benchmark/benchmark.h>

#include <numeric>
#include <vector>

#include "accel/accel.h"
#include "maps/map_capture.h"
#include "math/rng.h"
#include "math/warp.h"
#include "ray_recorder.h"
#include "scene_benchmark.h"
#include "transport/light_sampler.h"
#include "transport/path_tracer.h"

namespace drc::benchmarks {
namespace {

constexpr int kMaps = 64;
constexpr uint64_t kSeed = 1;

struct Site {
    SpawnPoint from;
    Frame frame;
    uint64_t stream;
    std::vector<RecordedRay> rays;
};

// Points that the camera sees, well distributed over the film.
std::vector<Site> findSites(const Scene& scene, const PathTracer& tracer) {
    const PixelRegion region = scene.sensor.settings.region();
    std::vector<Site> sites;
    for (uint32_t i = 0; i < 64 * kMaps && sites.size() < kMaps; ++i) {
        Sampler sampler(kSeed, i);
        const Vec2 u = sampler.get2D();
        const Vec2 film(float(region.x0) + u.x * float(region.width()),
                        float(region.y0) + u.y * float(region.height()));
        const Vec2 uLens = sampler.get2D();
        PrimaryHit hit;
        if (!tracer.primaryHit(scene.sensor.camera->generateRay(film, uLens, sampler.get1D()).ray, sampler, hit))
            continue;
        if (!hit.bsdf.hasNonSpecular()) continue;
        const SurfaceInteraction& at = hit.surface;
        const Frame frame = mapFrame(faceForward(at.ng, at.wo), scene.sensor.camera->up());
        sites.push_back({at.spawnPoint(), frame, hashCombine(kSeed, i), {}});
    }
    return sites;
}

void capture(const PathTracer& tracer, const Site& site, CapturedMap& map) {
    captureMap(tracer, CaptureSettings{}, site.from, site.frame, site.stream, map);
}

// Nearly free shading at a hit: no material, texture, distribution or weight.
float shadeFreely(const RTCRayHit& q, Pcg32& rng) {
    const Vec3 d(q.ray.dir_x, q.ray.dir_y, q.ray.dir_z);
    const Vec3 p = Vec3(q.ray.org_x, q.ray.org_y, q.ray.org_z) + d * q.ray.tfar;
    const Vec3 n = faceForward(normalize(Vec3(q.hit.Ng_x, q.hit.Ng_y, q.hit.Ng_z)), -d);
    const Vec3 next = Frame::fromNormal(n).toWorld(sampleCosineHemisphere(rng.nextVec2()));
    const Vec3 light = normalize(Vec3(rng.nextVec2().x, 1, 0) - p);
    return dot(next, n) + std::max(0.f, dot(light, n));
}

// Seconds that one of the contestants needed for the maps.
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
void captureAndReplay(benchmark::State& state, Scene& scene) {
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
        recordRays(&site.rays);
        capture(tracer, site, map);
        recordRays(nullptr);
        for (const RecordedRay& r : site.rays) ++(r.shadow ? shadows : segments);
    }

    const size_t n = sites.size();
    Pcg32 rng(1);
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
            benchmark::DoNotOptimize(
                replay(sites[second].rays, [&](const RTCRayHit& q) { return shadeFreely(q, rng); }));
            const double t2 = threadSeconds();
            benchmark::DoNotOptimize(replay(sites[third].rays, [](const RTCRayHit&) { return 1.f; }));
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

}  // namespace
}  // namespace drc::benchmarks

int main(int argc, char** argv) {
    return drc::benchmarks::runOnScene(argc, argv, "mapCapture", drc::benchmarks::captureAndReplay);
}
