// How near the network's forward pass comes to the arithmetic peak of one core. A loop of nothing but multiply-adds in
// registers takes turns with the network, so that both see the same clock frequency and the same neighbours.
#include <benchmark/benchmark.h>
#include <immintrin.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <dnnl.hpp>
#include <vector>

#include "neural/unet.h"

namespace drc {
namespace {

constexpr int kBatch = 8;
// Two units of four cycles' latency need 8 sums in flight, of five cycles' 10.
constexpr int kSums = 12;
constexpr int kRounds = 1 << 15;

double threadSeconds() {
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

// Each loop returns the floating-point operations that it did.
using PeakLoop = double (*)();

__attribute__((target("avx2,fma"))) double multiplyAddAvx2() {
    __m256 sum[kSums];
    __m256 a = _mm256_set1_ps(0.5f), b = _mm256_set1_ps(1.f);
    asm volatile("" : "+x"(a), "+x"(b));  // not known to the compiler
    for (__m256& s : sum) s = b;
    for (int i = 0; i < kRounds; ++i) {
#pragma GCC unroll 16
        for (int k = 0; k < kSums; ++k) sum[k] = _mm256_fmadd_ps(sum[k], a, b);
    }
    for (__m256& s : sum) asm volatile("" ::"x"(s));
    return 2.0 * 8 * kSums * kRounds;
}

__attribute__((target("avx512f"))) double multiplyAddAvx512() {
    __m512 sum[kSums];
    __m512 a = _mm512_set1_ps(0.5f), b = _mm512_set1_ps(1.f);
    asm volatile("" : "+v"(a), "+v"(b));
    for (__m512& s : sum) s = b;
    for (int i = 0; i < kRounds; ++i) {
#pragma GCC unroll 16
        for (int k = 0; k < kSums; ++k) sum[k] = _mm512_fmadd_ps(sum[k], a, b);
    }
    for (__m512& s : sum) asm volatile("" ::"v"(s));
    return 2.0 * 16 * kSums * kRounds;
}

__attribute__((target("avx512f,avx512bf16"))) double multiplyAddBf16() {
    __m512 sum[kSums];
    __m512i zero = _mm512_setzero_si512();
    asm volatile("" : "+v"(zero));
    const auto a = (__m512bh)zero;
    for (__m512& s : sum) s = _mm512_castsi512_ps(zero);
    for (int i = 0; i < kRounds; ++i) {
#pragma GCC unroll 16
        for (int k = 0; k < kSums; ++k) sum[k] = _mm512_dpbf16_ps(sum[k], a, a);
    }
    for (__m512& s : sum) asm volatile("" ::"v"(s));
    return 2.0 * 32 * kSums * kRounds;
}

// As the instruction reads it: eight tiles of 16 rows of 64 bytes.
struct alignas(64) TileShapes {
    uint8_t palette = 1, start = 0, reserved[14] = {};
    uint16_t rowBytes[16] = {64, 64, 64, 64, 64, 64, 64, 64};
    uint8_t rows[16] = {16, 16, 16, 16, 16, 16, 16, 16};
};
static_assert(sizeof(TileShapes) == 64);
const TileShapes kTileShapes;  // not on the stack: GCC 12 believes that only its first bytes are read

// Four products in flight: an instruction takes 52 cycles, and one can start each 16.
__attribute__((target("amx-tile,amx-bf16"))) double multiplyAddTiles() {
    _tile_loadconfig(&kTileShapes);
    _tile_zero(0);
    _tile_zero(1);
    _tile_zero(2);
    _tile_zero(3);
    _tile_zero(4);
    _tile_zero(5);
    for (int i = 0; i < kRounds / 4; ++i) {
        _tile_dpbf16ps(0, 4, 5);
        _tile_dpbf16ps(1, 4, 5);
        _tile_dpbf16ps(2, 4, 5);
        _tile_dpbf16ps(3, 4, 5);
    }
    _tile_release();
    return 2.0 * 16 * 16 * 32 * 4 * (kRounds / 4);
}

// Linux lends a process the tiles' registers only when asked for them.
bool tilesGranted() {
    constexpr long kRequest = 0x1023, kTileData = 18;
    return syscall(SYS_arch_prctl, kRequest, kTileData) == 0;
}

bool dnnlMayUse(dnnl::cpu_isa isa) {
    return (unsigned(dnnl::get_effective_cpu_isa()) & unsigned(isa)) == unsigned(isa);
}

// Peak loop with the widest instructions that the network itself may use at this precision; null: there are none.
PeakLoop peakLoop(Precision precision) {
    if (precision == Precision::Bf16 && dnnlMayUse(dnnl::cpu_isa::avx512_core_amx) && tilesGranted())
        return multiplyAddTiles;
    if (precision == Precision::Bf16) return __builtin_cpu_supports("avx512bf16") ? multiplyAddBf16 : nullptr;
    if (__builtin_cpu_supports("avx512f")) return multiplyAddAvx512;
    return __builtin_cpu_supports("fma") ? multiplyAddAvx2 : nullptr;
}

// Share of the peak of a Zen 5 core with AVX-512 (267 GFLOP/s fp32, 528 bf16) that bare oneDNN convolutions of the same
// shapes reach, at batch 8.
double referenceShare(int width, Precision precision) {
    const bool bf16 = precision == Precision::Bf16;
    switch (width) {
        case 16:
            return bf16 ? 0.87 : 0.93;
        case 32:
            return bf16 ? 0.95 : 0.93;
        case 64:
            return bf16 ? 0.91 : 0.92;
        default:
            return 0;
    }
}

// Arguments: kind (as UNetKind counts), width, bf16. An iteration is a batch and a turn of the loop; the time given is
// the batch's.
void networkShare(benchmark::State& state) {
    UNetShape shape;
    shape.kind = UNetKind(state.range(0));
    shape.width = int(state.range(1));
    shape.inputs = shape.kind == UNetKind::Paper ? kPlainPlanes : kGuidedPlanes;
    state.SetLabel(unetKindName(shape.kind));
    const auto precision = state.range(2) ? Precision::Bf16 : Precision::Fp32;
    const PeakLoop peak = peakLoop(precision);
    if (peak == nullptr || (precision == Precision::Bf16 && !cpuHasBf16())) {
        state.SkipWithError("not on this processor");
        return;
    }
    UNet net(UNetWeights::random(shape, 1), kBatch, precision);
    const size_t texels = size_t(shape.size) * size_t(shape.size);
    std::vector<float> input(size_t(kBatch * shape.inputs) * texels, 0.1f);
    std::vector<float> output(size_t(kBatch * shape.outputs) * texels);
    const double flop = 2 * shape.macs() * kBatch;
    double netTime = 0, peakTime = 0, peakFlop = 0, bestNet = 1e30, bestPeak = 1e30;
    for (auto _ : state) {
        const double start = threadSeconds();
        net.run(input.data(), output.data(), kBatch);
        benchmark::DoNotOptimize(output.data());
        const double middle = threadSeconds();
        const double done = peak();
        const double end = threadSeconds();
        netTime += middle - start;
        peakTime += end - middle;
        peakFlop += done;
        bestNet = std::min(bestNet, middle - start);
        bestPeak = std::min(bestPeak, (end - middle) / done);
        state.SetIterationTime(middle - start);
    }
    const double rate = 1e-9 * flop * double(state.iterations()) / netTime, peakRate = 1e-9 * peakFlop / peakTime;
    auto& c = state.counters;
    c["ms/map"] = 1e3 * netTime / (double(state.iterations()) * kBatch);
    c["GFLOP/s"] = rate;
    c["peak_GFLOP/s"] = peakRate;
    c["share_of_peak"] = rate / peakRate;
    c["best_ms/map"] = 1e3 * bestNet / kBatch;
    c["best_share_of_peak"] = flop / bestNet * bestPeak;
    c["MMAC"] = 1e-6 * shape.macs();
    if (shape.kind == UNetKind::Plain) c["reference_share"] = referenceShare(shape.width, precision);
}
BENCHMARK(networkShare)
    ->ArgNames({"kind", "width", "bf16"})
    ->ArgsProduct({{int(UNetKind::Plain)}, {8, 10, 12, 16, 24, 32, 64}, {0, 1}})
    ->ArgsProduct({{int(UNetKind::Residual)}, {8, 10, 12, 16, 24}, {0, 1}})
    ->ArgsProduct({{int(UNetKind::Separable)}, {16, 24, 32, 48}, {0, 1}})
    ->ArgsProduct({{int(UNetKind::Paper)}, {64}, {0, 1}})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace drc
BENCHMARK_MAIN();
