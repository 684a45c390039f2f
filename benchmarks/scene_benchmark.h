// Common part of the benchmarks that run on one scene.
#pragma once
#include <benchmark/benchmark.h>

#include "scene/scene.h"

namespace drc::benchmarks {

// main() of a benchmark: reads the pbrt file that DRC_BENCHMARK_SCENE names, by default the repository's quickstart
// scene, and runs one benchmark on it. pixels: about how many the film is to have, in its own shape; 0: as in the file.
int runOnScene(int argc, char** argv, const char* name, void (*run)(benchmark::State& state, Scene& scene),
               double pixels = 0);

}  // namespace drc::benchmarks
