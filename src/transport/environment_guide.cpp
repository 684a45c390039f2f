#include "transport/environment_guide.h"

#include <immintrin.h>

#include <algorithm>
#include <bit>
#include <functional>

#include "base/parallel.h"
#include "math/rng.h"

namespace drc {
namespace {

constexpr int kOne = 1 << 16;
// Share of the samples that are drawn without guiding.
constexpr double kUnguided = 0.25;
// Weight of the prior of a block's rate of unoccluded samples, the mean rate of its group; counted in samples.
constexpr double kPriorTries = 1;
// After this many sample passes, learning gains nothing more and counting would only cost time.
constexpr int kPassesToLearn = 64;

// cumulative[i]: sum of the first i weights, in units of 2^-16 of the total; each weight counts at least one unit.
template <size_t N>
void accumulate(const std::array<double, N>& weights, std::array<uint16_t, N>& cumulative) {
    double total = 0, sum = 0;
    for (const double w : weights) total += w;
    for (size_t i = 0; i < N; ++i) {
        cumulative[i] = uint16_t(i + size_t(sum / total * double(kOne - int(N)) + 0.5));
        sum += weights[i];
    }
}

struct Cell {
    int index;
    float local;  // position within the chosen interval, in [0, 1)
    int mass;     // probability, in units of 2^-16
};

template <size_t N>
bool isCumulative(const std::array<uint16_t, N>& numbers) {
    return numbers[0] == 0 && std::ranges::adjacent_find(numbers, std::greater_equal<>()) == numbers.end();
}

template <size_t N>
int massOf(const std::array<uint16_t, N>& cumulative, int i) {
    return (i + 1 < int(N) ? cumulative[size_t(i) + 1] : kOne) - cumulative[size_t(i)];
}

// Number of entries <= x, for x in [0, 2^16). Compares all entries in SIMD registers, without branches.
int countUpTo(const std::array<uint16_t, 8>& numbers, int x) {
    const __m128i n = _mm_loadu_si128(reinterpret_cast<const __m128i*>(numbers.data()));
    const __m128i most = _mm_set1_epi16(int16_t(x));
    const __m128i upTo = _mm_cmpeq_epi16(_mm_min_epu16(n, most), n);
    return std::popcount(unsigned(_mm_movemask_epi8(upTo))) / 2;
}
int countUpTo(const std::array<uint16_t, 16>& numbers, int x) {
    const __m256i n = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(numbers.data()));
    const __m256i most = _mm256_set1_epi16(int16_t(x));
    const __m256i upTo = _mm256_cmpeq_epi16(_mm256_min_epu16(n, most), n);
    return std::popcount(unsigned(_mm256_movemask_epi8(upTo))) / 2;
}

// u in [0, 1). The first cumulative number must be zero.
template <size_t N>
Cell choose(const std::array<uint16_t, N>& cumulative, float u) {
    const float x = u * float(kOne);
    const int i = countUpTo(cumulative, int(x)) - 1;
    const int mass = massOf(cumulative, i);
    return {i, std::min((x - float(cumulative[size_t(i)])) / float(mass), kOneMinusEpsilon), mass};
}

}  // namespace

EnvironmentGuide::EnvironmentGuide(EnvironmentWindows windows, float size)
    : windows_(std::move(windows)), perSize_(1 / std::max(size, 1e-20f)), tables_(kGroups) {
    Table uniform;
    std::array<double, kRows> rows;
    std::array<double, kColumns> columns;
    rows.fill(1);
    columns.fill(1);
    accumulate(rows, uniform.rows);
    for (auto& c : uniform.columns) accumulate(columns, c);
    std::fill(tables_.begin(), tables_.end(), uniform);
    counts_ = std::make_unique<std::atomic<uint64_t>[]>(size_t(kGroups) * kBlocks);
}

int EnvironmentGuide::group(const Vec3& p, const Vec3& n) const {
    const float x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
    const int axis = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
    // Points are jittered by up to half a voxel; otherwise the voxels would be visible as squares of different noise
    // levels. The bits of the point's coordinates serve as random numbers, so that the same point always falls into the
    // same group.
    const auto bits = [](float f) { return uint64_t(std::bit_cast<uint32_t>(f)); };
    const uint64_t random = mixBits(bits(p.x) ^ mixBits(bits(p.y) ^ mixBits(bits(p.z))));
    uint64_t key = uint64_t(2 * axis + (n[axis] < 0));
    for (int i = 0; i < 3; ++i) {
        const float jitter = float((random >> (20 * i)) & 0xfffff) * 0x1p-20f;
        // Clamped, because converting a float beyond an integer's range is undefined.
        const float voxel = std::clamp(std::floor(p[i] * perSize_ + jitter), -1e9f, 1e9f);
        key = mixBits(key ^ uint64_t(int64_t(voxel)));
    }
    return int(key % kGroups);
}

EnvironmentGuide::Guided EnvironmentGuide::sample(int group, const Vec2& u) const {
    const Table& table = tables_[size_t(group)];
    const Cell row = choose(table.rows, u.y);
    const Cell column = choose(table.columns[size_t(row.index)], u.x);
    Guided g;
    g.u = Vec2((float(column.index) + column.local) / kColumns, (float(row.index) + row.local) / kRows);
    g.density = float(row.mass) * float(column.mass) * (kBlocks * 0x1p-32f);
    g.slot = group * kBlocks + row.index * kColumns + column.index;
    __builtin_prefetch(&counts_[size_t(g.slot)], 1);  // for learn(), which follows after a shadow ray
    return g;
}

float EnvironmentGuide::density(int group, const Vec2& u) const {
    const Table& table = tables_[size_t(group)];
    const int row = std::clamp(int(u.y * kRows), 0, kRows - 1);
    const int column = std::clamp(int(u.x * kColumns), 0, kColumns - 1);
    return float(massOf(table.rows, row)) * float(massOf(table.columns[size_t(row)], column)) * (kBlocks * 0x1p-32f);
}

void EnvironmentGuide::update() {
    if (!learning_) return;
    ++passes_;
    if (passes_ >= kPassesToLearn) learning_ = false;
    // Rebuilds the tables after passes 1, 2, 4, 8, ..., as there is less and less to learn.
    if (!std::has_single_bit(unsigned(passes_))) return;
    parallelFor(0, kGroups, 256, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) rebuild(tables_[size_t(i)], &counts_[size_t(i) * kBlocks]);
    });
}

void EnvironmentGuide::rebuild(Table& table, const std::atomic<uint64_t>* counts) const {
    uint64_t tries = 0, arrivals = 0;
    for (int b = 0; b < kBlocks; ++b) {
        const uint64_t count = counts[b].load(std::memory_order_relaxed);
        tries += count % kArrival;
        arrivals += count / kArrival;
    }
    if (tries == 0) return;
    // The rate is never zero: samples of a block may arrive later even if none has arrived yet.
    const double rate = (double(arrivals) + 0.5) / (double(tries) + 1);
    double total = 0;
    std::array<std::array<double, kColumns>, kRows> p;
    for (int b = 0; b < kBlocks; ++b) {
        const uint64_t count = counts[b].load(std::memory_order_relaxed);
        const double known = (double(count / kArrival) + kPriorTries * rate) / (double(count % kArrival) + kPriorTries);
        total += p[size_t(b / kColumns)][size_t(b % kColumns)] = std::sqrt(known);
    }
    std::array<double, kRows> rows;
    for (size_t y = 0; y < kRows; ++y) {
        rows[y] = 0;
        for (double& x : p[y]) rows[y] += x = (1 - kUnguided) * x / total + kUnguided / kBlocks;
        accumulate(p[y], table.columns[y]);
    }
    accumulate(rows, table.rows);
}

void EnvironmentGuide::save(StateWriter& to) const {
    static_assert(sizeof(Table) == (kRows + kBlocks) * sizeof(uint16_t));
    to.value(int32_t(passes_));
    to.bytes(std::as_bytes(std::span(tables_)));
    // Once learning has ended, the counts are not needed any more.
    if (!learning_) return;
    for (size_t i = 0; i < size_t(kGroups) * kBlocks; ++i) to.value(counts_[i].load(std::memory_order_relaxed));
}

std::function<void()> EnvironmentGuide::load(StateReader& from) {
    struct State {
        int passes = 0;
        std::vector<Table> tables;
        std::vector<uint64_t> counts;
    };
    const auto state = std::make_shared<State>();
    state->passes = from.value<int32_t>();
    state->tables.resize(tables_.size());
    from.bytes(std::as_writable_bytes(std::span(state->tables)));
    for (const Table& table : state->tables)
        if (!isCumulative(table.rows) || !std::ranges::all_of(table.columns, isCumulative<kColumns>))
            from.fail("there cannot be such a table of where light comes from");
    const bool learning = state->passes < kPassesToLearn;
    if (learning) {
        state->counts.resize(size_t(kGroups) * kBlocks);
        from.values(std::span(state->counts));
    }
    return [this, state, learning] {
        passes_ = state->passes;
        learning_ = learning;
        tables_ = std::move(state->tables);
        for (size_t i = 0; i < state->counts.size(); ++i) counts_[i].store(state->counts[i], std::memory_order_relaxed);
    };
}

}  // namespace drc
