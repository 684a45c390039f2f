#include "cache/radiance_cells.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>

#include "base/parallel.h"
#include "math/frame.h"
#include "math/rng.h"

namespace drc {
namespace {

// A point may use cells whose size is at most this share of its reach. For diffuse reflection that is a distance of
// about one and a half cells.
constexpr float kSizePerReach = 1 / 3.f;
// A component of a unit normal counts for the facing if it is larger than this, the sine of 22.5 degrees: the 26
// directions then have about equal parts of the sphere.
constexpr float kFacing = 0.3827f;
// A cell has another surface than a point if the plane of its deposits is farther away than this share of its size, or
// if the cosine between the normals is below this.
constexpr float kPlaneDistance = 0.4f, kLeastCosine = 0.7f;
// Positions, normals and albedos are summed up in units of these.
constexpr float kPositionUnits = 512, kNormalUnits = 127, kAlbedoUnits = 1024;
// The table doubles when more than this share of it is used.
constexpr double kMostUsed = 0.4;
constexpr size_t kFirstCapacity = 1 << 14;
// The probability that a path goes on where the cache has answered, so as to improve the answer: in proportion to the
// standard error of the answer, divided by the answer or by this share of the mean of all cells, whichever is more.
constexpr double kTrainingPerError = 0.25, kLeastTraining = 1 / 64.0, kMostTraining = 0.25, kDimmest = 0.25;
// The grids are shifted by this share of a cell, because scenes have many surfaces at round coordinates.
constexpr float kGridShift = 0.3819f;

int facing(const Vec3& n) {
    const auto digit = [](float v) { return v > kFacing ? 2 : v < -kFacing ? 0 : 1; };
    return digit(n.x) + 3 * (digit(n.y) + 3 * digit(n.z));
}

int64_t unitsOf(double value, double perUnit) {
    constexpr double kMost = 0x1p42;
    return std::llrint(std::clamp(value * perUnit, -kMost, kMost));
}

}  // namespace

RadianceCells::RadianceCells(const RadianceCellSettings& settings)
    : settings_(settings), perQuantum_(1 / 0x1p-24 * double(settings.lightScale > 0 ? settings.lightScale : 1)) {
    settings_.capacity = std::bit_ceil(std::max(settings.capacity, kWays));
    const size_t first = std::min(kFirstCapacity, settings_.capacity);
    answers_ = HugeArray<Answer>(first);
    sums_ = HugeArray<Sums>(first);
}

float RadianceCells::reachFor(int level) const { return sizeOf(level) / kSizePerReach; }

int RadianceCells::largestLevel(const CachePoint& at) const {
    int level = settings_.sizes - 1;
    while (level > 0 && at.reach < reachFor(level)) --level;
    return level;
}

RadianceCells::Place RadianceCells::placeOf(const Vec3& p, const Vec3& n, int level, int largest) const {
    const float size = sizeOf(level), perSize = 1 / size;
    const float x = std::floor(p.x * perSize + kGridShift), y = std::floor(p.y * perSize + kGridShift),
                z = std::floor(p.z * perSize + kGridShift);
    // Points that may not use the largest cells, because they are seen from nearby, have cells of their own: otherwise
    // the light in corners, and beside lamps, would be mixed into that of open surfaces.
    const int points = largest == settings_.sizes - 1 ? 0 : generationOf(largest);
    const auto kind = uint64_t((points * 64 + generationOf(level)) * 27 + facing(n));
    const uint64_t key = mixBits(mixBits(uint64_t(int64_t(x)) + uint64_t(int64_t(y)) * 0x9e3779b97f4a7c15ull) +
                                 uint64_t(int64_t(z)) * 0xd1342543de82ef95ull + kind * 0xaf251af3b0f025b5ull);
    return {key == 0 ? 1 : key, Vec3(x - kGridShift, y - kGridShift, z - kGridShift) * size};
}

Vec3 RadianceCells::jittered(const CachePoint& at, int level, const Vec2& u) const {
    const Frame frame = Frame::fromNormal(at.n);
    return at.p + (frame.s * (u.x - 0.5f) + frame.t * (u.y - 0.5f)) * sizeOf(level);
}

const RadianceCells::Answer* RadianceCells::find(uint64_t key) const {
    const Answer* bucket = &answers_[bucketOf(key)];
    for (size_t way = 0; way < kWays; ++way)
        if (bucket[way].key == key) return bucket + way;
    return nullptr;
}

void RadianceCells::prefetch(const CachePoint& at, const Vec2& u) const {
    const auto* bucket =
        reinterpret_cast<const char*>(&answers_[bucketOf(placeOf(jittered(at, 0, u), at.n, 0, largestLevel(at)).key)]);
    __builtin_prefetch(bucket);
    __builtin_prefetch(bucket + 64);
}

bool RadianceCells::lookUp(const CachePoint& at, const Vec2& u, CacheAnswer& answer) const {
    const int largest = largestLevel(at);
    for (int level = 0; level <= largest; ++level) {
        // At a random position around the point, so that the borders of cells do not show; where that is not on the
        // same surface, at the point.
        for (const Vec3& p : {jittered(at, level, u), at.p}) {
            const Answer* cell = find(placeOf(p, at.n, level, largest).key);
            if (cell == nullptr || !cell->known) continue;
            const Vec3 normal = Vec3(cell->normal[0], cell->normal[1], cell->normal[2]) * (1 / kNormalUnits);
            if (dot(normal, at.n) < kLeastCosine) continue;
            if (std::abs(dot(normal, at.p) - cell->plane) > kPlaneDistance * sizeOf(level)) continue;
            answer.training = float(cell->training) * (1 / 255.f);
            answer.perAlbedo = Rgb(cell->perAlbedo[0], cell->perAlbedo[1], cell->perAlbedo[2]);
            // All threads write the same number, and only if it is another one, so that they share the cache line.
            std::atomic_ref<uint16_t> lastUse(const_cast<Answer*>(cell)->lastUse);
            if (lastUse.load(std::memory_order_relaxed) != uint16_t(now_))
                lastUse.store(uint16_t(now_), std::memory_order_relaxed);
            return true;
        }
    }
    answer.training = 1;
    return false;
}

void RadianceCells::add(const CacheDeposit& d, int level, const Place& place, uint64_t parent) {
    const size_t bucket = bucketOf(place.key);
    size_t at = bucket, oldest = bucket;
    for (; at < bucket + kWays; ++at) {
        if (answers_[at].key == place.key || answers_[at].key == 0) break;
        if (age(answers_[at]) > age(answers_[oldest])) oldest = at;
    }
    if (at == bucket + kWays) {
        // Cells that were used since the last commit but one stay.
        if (age(answers_[oldest]) <= 1) return;
        at = oldest;
    }
    Sums& sums = sums_[at];
    if (answers_[at].key != place.key) {
        answers_[at] = Answer{.key = place.key};
        sums = Sums{};
        sums.corner = place.corner;
        sums.generation = uint8_t(generationOf(level));
    }
    sums.parent = parent;
    answers_[at].lastUse = uint16_t(now_);
    const float perSize = 1 / sizeOf(level);
    for (int c = 0; c < 3; ++c) {
        sums.light[c] += unitsOf(double(d.light[c]), perQuantum_);
        sums.albedo[c] += uint32_t(std::lrint(std::clamp(d.albedo[c], 0.f, 1.f) * kAlbedoUnits));
        sums.position[c] += int32_t(std::lrint((d.at.p[c] - place.corner[c]) * perSize * kPositionUnits));
        sums.normal[c] += int32_t(std::lrint(d.at.n[c] * kNormalUnits));
    }
    const double y = double(luminance(d.light)) / std::max(0.01, double(luminance(d.albedo)));
    sums.square += unitsOf(y * y, perSquare());
    if (++sums.count < kMostDeposits) return;
    for (int c = 0; c < 3; ++c) {
        sums.light[c] /= 2;
        sums.albedo[c] /= 2;
        sums.position[c] /= 2;
        sums.normal[c] /= 2;
    }
    sums.square /= 2;
    sums.count /= 2;
}

Rgb RadianceCells::perAlbedo(const Sums& sums) const {
    Rgb result(0.f);
    for (int c = 0; c < 3; ++c)
        if (sums.albedo[c] > 0)
            result[c] = float(double(sums.light[c]) / perQuantum_ / (double(sums.albedo[c]) / double(kAlbedoUnits)));
    return result;
}

// The cells within it share the deposits; their means are compared with the mean of all, which is what viewers see of
// them together. What the means differ by is no noise, but what smaller cells are there to show.
bool RadianceCells::divides(const Sums& sums) const {
    const double count = double(sums.count), mean = meanOf(sums);
    const double within = std::max(0.0, double(sums.square - sums.between) / (perSquare() * count));
    constexpr double kCellsWithin = 4;
    return kCellsWithin * within <= double(settings_.variance) * mean * mean * count;
}

void RadianceCells::renewAnswer(Answer& answer, const Sums& own) {
    answer.known = false;
    // The smallest of the nested cells that knows enough. The one around it decides for all cells within it: if each
    // decided by its own variance, those that happen to lack their brightest samples would be preferred.
    const Sums* sums = &own;
    for (;;) {
        const Answer* around = sums->parent != 0 ? find(sums->parent) : nullptr;
        const bool trusted = around == nullptr ? sums->parent == 0 : divides(sumsOf(*around));
        if (trusted && sums->count >= uint32_t(settings_.deposits)) break;
        if (around == nullptr) return;
        sums = &sumsOf(*around);
    }
    const auto vector = [](const int32_t(&v)[3]) { return Vec3(float(v[0]), float(v[1]), float(v[2])); };
    const float length2 = lengthSquared(vector(sums->normal));
    if (!(length2 > 0)) return;
    const Vec3 normal = vector(sums->normal) * (1 / std::sqrt(length2));
    for (int c = 0; c < 3; ++c) answer.normal[c] = int8_t(std::lrint(normal[c] * kNormalUnits));
    // By the normal that look-ups see.
    const Vec3 seen = Vec3(answer.normal[0], answer.normal[1], answer.normal[2]) * (1 / kNormalUnits);
    const float perUnit = sizeOf(levelOf(sums->generation)) / (kPositionUnits * float(sums->count));
    answer.plane = dot(seen, sums->corner + vector(sums->position) * perUnit);
    const Rgb value = perAlbedo(*sums);
    for (int c = 0; c < 3; ++c) answer.perAlbedo[c] = value[c];
    const double count = double(sums->count), mean = double(luminance(value));
    const double variance = std::max(0.0, double(sums->square) / (perSquare() * count) - mean * mean) / count;
    const double error = std::sqrt(variance) / std::max(1e-30, std::max(mean, kDimmest * mean_));
    answer.training = uint8_t(std::lrint(255 * std::clamp(kTrainingPerError * error, kLeastTraining, kMostTraining)));
    answer.known = true;
}

size_t RadianceCells::commit(std::span<std::vector<CacheDeposit>* const> lists) {
    ++now_;
    size_t deposits = 0;
    for (const auto* list : lists) deposits += list->size();
    while (answers_.size() < settings_.capacity &&
           double(used_) + double(deposits) / 4 > kMostUsed * double(answers_.size()))
        grow();
    // Each thread fills a part of the table, from all deposits in their order.
    const int parts = int(std::bit_ceil(unsigned(threadCount())));
    parallelFor(0, parts, 1, [&](int part, int) {
        for (const auto* list : lists)
            for (const CacheDeposit& d : *list) {
                // From the largest cells that may be used on.
                uint64_t parent = 0;
                const int largest = largestLevel(d.at);
                for (int level = largest; level >= 0; --level) {
                    const Place place = placeOf(d.at.p, d.at.n, level, largest);
                    if (bucketOf(place.key) * size_t(parts) / answers_.size() == size_t(part))
                        add(d, level, place, parent);
                    parent = place.key;
                }
            }
    });
    for (auto* list : lists) list->clear();
    renewAnswers();
    return deposits;
}

void RadianceCells::renewAnswers() {
    const auto forEachCell = [&](const auto& f) {
        parallelFor(0, int(answers_.size()), 1 << 14, [&](int begin, int end) {
            for (auto i = size_t(begin); i < size_t(end); ++i)
                if (answers_[i].key != 0) f(i);
        });
    };
    // Integers, so that the order of additions does not matter.
    std::atomic<int64_t> light = 0, count = 0;
    std::atomic<size_t> used = 0;
    forEachCell([&](size_t i) { sums_[i].between = 0; });
    forEachCell([&](size_t i) {
        const Sums& sums = sums_[i];
        const double mean = meanOf(sums);
        used.fetch_add(1, std::memory_order_relaxed);
        if (sums.parent == 0) {
            light.fetch_add(unitsOf(mean * double(sums.count), perQuantum_), std::memory_order_relaxed);
            count.fetch_add(int64_t(sums.count), std::memory_order_relaxed);
        } else if (const Answer* around = find(sums.parent)) {
            auto& between = const_cast<Sums&>(sumsOf(*around)).between;
            std::atomic_ref(between).fetch_add(unitsOf(mean * mean * double(sums.count), perSquare()),
                                               std::memory_order_relaxed);
        }
    });
    used_ = used;
    mean_ = count > 0 ? double(light) / perQuantum_ / double(count) : 0;
    forEachCell([&](size_t i) { renewAnswer(answers_[i], sums_[i]); });
}

// A bucket's cells go to the bucket of the same number or to the one that the new bit of the index leads to.
void RadianceCells::grow() {
    HugeArray<Answer> answers = std::exchange(answers_, HugeArray<Answer>(2 * answers_.size()));
    HugeArray<Sums> sums = std::exchange(sums_, HugeArray<Sums>(2 * sums_.size()));
    for (size_t i = 0; i < answers.size(); ++i) {
        if (answers[i].key == 0) continue;
        size_t to = bucketOf(answers[i].key);
        while (answers_[to].key != 0) ++to;
        answers_[to] = answers[i];
        sums_[to] = sums[i];
    }
}

void RadianceCells::refine() {
    if (refined_ + 1 >= kMostRefined) return;
    settings_.size *= 0.5f;
    ++refined_;
}

}  // namespace drc
