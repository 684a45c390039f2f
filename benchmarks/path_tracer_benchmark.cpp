// How near the path tracer comes to the speed of its rays, on one thread: sample passes over the film, one path a
// pixel, alternate with replays of the rays of such a pass through bare Embree, so that any other load of the machine
// slows both alike. The film has the scene's own shape at a size that keeps a pass short.
#include "base/parallel.h"
#include "ray_recorder.h"
#include "render/session.h"
#include "scene_benchmark.h"

namespace drc::benchmarks {
namespace {

constexpr double kPixels = 64 * 1024;
// The first sample takes several passes, and the cost of a pass changes while the guide learns.
constexpr int kWarmUpPasses = 4;

void tracePaths(benchmark::State& state, Scene& scene) {
    setThreadCount(1);
    RenderParams params;
    params.integrator = "path";
    params.spp = 1 << 30;
    Session session(scene, params);
    for (int i = 0; i < kWarmUpPasses; ++i) session.step();
    std::vector<RecordedRay> rays;
    recordRays(&rays);
    session.step();
    recordRays(nullptr);
    double traced = 0, tracing = 0, replaying = 0, shadows = 0;
    for (const RecordedRay& ray : rays) shadows += ray.shadow;
    for (auto _ : state) {
        const uint64_t before = raysTraced();
        const double t0 = threadSeconds();
        session.step();
        const double t1 = threadSeconds();
        benchmark::DoNotOptimize(replay(rays, [](const RTCRayHit&) { return 1.f; }));
        const double t2 = threadSeconds();
        traced += double(raysTraced() - before);
        tracing += t1 - t0;
        replaying += t2 - t1;
        state.SetIterationTime(t2 - t0);
    }
    const double passes = double(state.iterations()), pixels = double(scene.sensor.settings.region().count());
    auto& c = state.counters;
    c["rays/path"] = double(rays.size()) / pixels;
    c["shadow_share"] = shadows / double(rays.size());
    c["paths/s"] = passes * pixels / tracing;
    c["Mrays/s"] = 1e-6 * traced / tracing;
    c["bare_Mrays/s"] = 1e-6 * double(rays.size()) * passes / replaying;
    c["share_of_bare"] = (traced / tracing) / (double(rays.size()) * passes / replaying);
}

}  // namespace
}  // namespace drc::benchmarks

int main(int argc, char** argv) {
    return drc::benchmarks::runOnScene(argc, argv, "pathTracer", drc::benchmarks::tracePaths, drc::benchmarks::kPixels);
}
