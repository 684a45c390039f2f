// Maps per second of the network's forward pass on one thread, random weights; and how long shipped ones take to load.
#include <benchmark/benchmark.h>

#include <array>
#include <memory>
#include <vector>

#include "app/models.h"
#include "neural/transforms.h"
#include "neural/unet.h"

namespace drc {
namespace {

// Arguments: width, bf16, batch.
void unetForward(benchmark::State& state) {
    UNetShape shape;
    shape.width = int(state.range(0));
    const auto precision = state.range(1) ? Precision::Bf16 : Precision::Fp32;
    const int batch = int(state.range(2));
    if (precision == Precision::Bf16 && !cpuHasBf16()) {
        state.SkipWithError("no bf16 on this processor");
        return;
    }
    UNet net(UNetWeights::random(shape, 1), batch, precision);
    const size_t texels = size_t(shape.size) * shape.size;
    std::vector<float> input(batch * shape.inputs * texels, 0.1f), output(batch * shape.outputs * texels);
    for (auto _ : state) {
        net.run(input.data(), output.data(), batch);
        benchmark::DoNotOptimize(output.data());
    }
    const double maps = double(state.iterations()) * batch;
    state.counters["maps/s"] = benchmark::Counter(maps, benchmark::Counter::kIsRate);
    state.counters["ms/map"] =
        benchmark::Counter(maps * 1e-3, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["GFLOP/s"] = benchmark::Counter(maps * 2e-9 * shape.macs(), benchmark::Counter::kIsRate);
}
BENCHMARK(unetForward)
    ->ArgNames({"width", "bf16", "batch"})
    ->ArgsProduct({{16, 32, 64}, {0, 1}, {1, 8, 32}})
    ->Unit(benchmark::kMillisecond);

void transformMap(benchmark::State& state) {
    constexpr size_t kTexels = 32 * 32;
    std::vector<float> radiance(3 * kTexels, 0.5f), normal(3 * kTexels), distance(kTexels, 2.f);
    std::vector<float> planes(kPlainPlanes * kTexels), decoded(3 * kTexels);
    for (auto _ : state) {
        const float mean = encodeInput({radiance.data(), normal.data(), distance.data(), kTexels}, planes.data());
        decodeOutput(planes.data(), decoded.size(), mean, decoded.data());
        benchmark::DoNotOptimize(decoded.data());
    }
}
BENCHMARK(transformMap)->Unit(benchmark::kMicrosecond);

// From a shipped network's file to all that its first map needs. Argument: which network.
void loadNetwork(benchmark::State& state) {
    const char* name = std::array{"drc-fast", "drc", "paper-k64"}[size_t(state.range(0))];
    state.SetLabel(name);
    const std::string path = findWeights(name);
    for (auto _ : state) {
        const auto weights = UNetWeights::load(path);
        const UNet net(weights, 8, bestPrecision(*weights));
        benchmark::DoNotOptimize(&net);
    }
}
BENCHMARK(loadNetwork)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace drc
BENCHMARK_MAIN();
