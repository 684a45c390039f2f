#include "scene_benchmark.h"

#include <fmt/core.h>

#include <cmath>
#include <cstdlib>

#include "base/error.h"
#include "pbrt/scene_file.h"

namespace drc::benchmarks {
namespace {

std::string scenePath() {
    if (const char* path = std::getenv("DRC_BENCHMARK_SCENE")) return path;
    return DRC_SOURCE_DIR "/scenes/quickstart/scene.pbrt";
}

}  // namespace

int runOnScene(int argc, char** argv, const char* name, void (*run)(benchmark::State& state, Scene& scene),
               double pixels) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    try {
        auto scene = pbrt::loadPbrtFile(scenePath());
        if (pixels > 0) {
            FilmGeometry film = scene->sensor.settings.film;
            const double scale = std::sqrt(pixels / (double(film.width) * film.height));
            film.width = std::max(1, int(std::lround(film.width * scale)));
            film.height = std::max(1, int(std::lround(film.height * scale)));
            scene = pbrt::loadPbrtFile(scenePath(), {.resolution = film});
        }
        benchmark::AddCustomContext("scene", scenePath());
        benchmark::RegisterBenchmark(name, [&](benchmark::State& state) { run(state, *scene); })
            ->Unit(benchmark::kMillisecond)
            ->UseManualTime();
        benchmark::RunSpecifiedBenchmarks();
    } catch (const Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
    benchmark::Shutdown();
    return 0;
}

}  // namespace drc::benchmarks
