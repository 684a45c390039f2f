#include "cells/radiance_cells.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>

#include "base/parallel.h"
#include "math/rng.h"

namespace drc {
namespace {

// A point may use cells whose size is at most this share of its reach. For diffuse reflection that is a distance of
// about one and a half cells.
constexpr float kSizePerReach = 1 / 3.f;
// A component of a unit normal counts for the facing if it is larger than this, the sine of 22.5 degrees: the 26
// directions then have about equal parts of the sphere.
constexpr float kFacing = 0.3827f;
constexpr int kFacings = 27;  // as numbered by facing(), which leaves out the middle one
// A cell has another surface than a point if the plane of its deposits is farther away than this share of its size, or
// if the cosine between the normals is below this.
constexpr float kPlaneDistance = 0.4f, kLeastCosine = 0.7f;
// Positions and normals are summed up in units of these.
constexpr float kPositionUnits = 512, kNormalUnits = 127;
// Cells of points with a short reach need so many times the deposits.
constexpr uint32_t kNearby = 16;
// The table doubles when more than this share of it is used.
constexpr double kMostUsed = 0.4;
constexpr size_t kFirstCapacity = 1 << 14;
// The probability that a path goes on where the cache has answered, so as to improve the answer: in proportion to the
// mean over all cells of the answers' standard error, divided by the answer or by this share of the mean of all cells,
// whichever is more.
constexpr double kTrainingPerError = 1, kLeastTraining = 1 / 8.0, kMostTraining = 0.5, kDimmest = 0.25;
// The grids are shifted by this share of the largest cells, because scenes have many surfaces at round coordinates. By
// the same distance at all sizes, so that cells are nested; a third remains a third or two thirds of all smaller sizes.
constexpr float kGridShift = 1 / 3.f;

// The bound of a deposit, in units of the mean of the cell of the largest size around it if that has so many deposits,
// or of a share of the mean of all deposits, if that is more: a share of the number of deposits so far, and at least as
// many as there are in a large cell after a few passes.
constexpr double kMostPerDeposits = 0x1p-10, kLeastBound = 1024, kLeastMean = 1 / 16.0;
constexpr uint32_t kLeastForBound = 64;
// The number of cells whose memory is asked for at a time.
constexpr size_t kBatch = 32;

int facing(const Vec3& n) {
    const auto digit = [](float v) { return v > kFacing ? 2 : v < -kFacing ? 0 : 1; };
    return digit(n.x) + 3 * (digit(n.y) + 3 * digit(n.z));
}

// A deposit's light divided by its view factor.
double relativeLuminance(const CacheDeposit& d) {
    return double(luminance(d.light)) / std::max(0.01, double(luminance(d.viewFactor)));
}

// The mean of some deposits, in which those that stand out far count little.
double firstMean(std::span<std::vector<CacheDeposit>* const> lists) {
    constexpr double kFar = kLeastBound;
    double mean = kInfinity, before;
    do {
        double sum = 0, count = 0;
        for (const auto* list : lists)
            for (const CacheDeposit& d : *list) {
                sum += std::min(relativeLuminance(d), kFar * mean);
                ++count;
            }
        before = std::exchange(mean, count > 0 ? sum / count : 0);
    } while (mean < 0.5 * before);
    return mean;
}

int64_t unitsOf(double value, double perUnit) {
    constexpr double kMost = 0x1p42;
    return std::llrint(std::clamp(value * perUnit, -kMost, kMost));
}

}  // namespace

RadianceCells::RadianceCells(const RadianceCellSettings& settings)
    : settings_(settings), perQuantum_(1 / 0x1p-24 * double(settings.lightScale > 0 ? settings.lightScale : 1)) {
    settings_.capacity = std::bit_ceil(std::max(settings.capacity, kWays));
    settings_.sizes = std::clamp(settings.sizes, 1, int(kMostSizes));
    shift_ = kGridShift * sizeOf(settings_.sizes - 1);
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

uint64_t RadianceCells::keyOf(const int32_t (&grid)[3], int facing, int generation, uint8_t points) {
    const auto kind = uint64_t((int(points) * 64 + generation) * kFacings + facing);
    const uint64_t key = mixBits(mixBits(uint64_t(grid[0]) + uint64_t(grid[1]) * 0x9e3779b97f4a7c15ull) +
                                 uint64_t(grid[2]) * 0xd1342543de82ef95ull + kind * 0xaf251af3b0f025b5ull);
    return key == 0 ? 1 : key;
}

RadianceCells::Place RadianceCells::placeOf(const Vec3& p, const Vec3& n, int level, uint8_t points) const {
    constexpr float kMost = 1 << 30;
    const float perSize = 1 / sizeOf(level);
    Place place{};
    for (int c = 0; c < 3; ++c)
        place.grid[c] = int32_t(std::clamp(std::floor((p[c] + shift_) * perSize), -kMost, kMost));
    place.facing = facing(n);
    place.points = points;
    place.key = keyOf(place.grid, place.facing, generationOf(level), points);
    return place;
}

Vec3 RadianceCells::cornerOf(const int32_t (&grid)[3], int level) const {
    return Vec3(float(grid[0]), float(grid[1]), float(grid[2])) * sizeOf(level) - Vec3(shift_);
}

uint64_t RadianceCells::keyAround(const Sums& sums) const {
    const int generation = int(sums.generation) + 1;
    const uint8_t points = answerOf(sums).points;
    if (levelOf(generation) >= settings_.sizes || (points != 0 && generation > points)) return 0;
    return keyOf({sums.grid[0] >> 1, sums.grid[1] >> 1, sums.grid[2] >> 1}, int(sums.facing), generation, points);
}

const RadianceCells::Answer* RadianceCells::find(uint64_t key) const {
    const Answer* bucket = &answers_[bucketOf(key)];
    for (size_t way = 0; way < kWays; ++way)
        if (bucket[way].key == key) return bucket + way;
    return nullptr;
}

void RadianceCells::prefetchBucket(uint64_t key) const {
    const auto* bucket = reinterpret_cast<const char*>(&answers_[bucketOf(key)]);
    __builtin_prefetch(bucket);
    __builtin_prefetch(bucket + 64);
}

void RadianceCells::prefetch(const CachePoint& at) const {
    prefetchBucket(placeOf(at.p, at.n, 0, pointsOf(largestLevel(at))).key);
}

bool RadianceCells::lookUp(const CachePoint& at, CacheAnswer& answer) const {
    answer.training = 1;
    if (!accepts(at)) return false;
    const int largest = largestLevel(at);
    for (int level = 0; level <= largest; ++level) {
        const Answer* cell = find(placeOf(at.p, at.n, level, pointsOf(largest)).key);
        if (cell == nullptr || !cell->known) continue;
        const Vec3 normal = Vec3(cell->normal[0], cell->normal[1], cell->normal[2]) * (1 / kNormalUnits);
        if (dot(normal, at.n) < kLeastCosine) continue;
        if (std::abs(dot(normal, at.p) - cell->plane) > kPlaneDistance * sizeOf(level)) continue;
        answer.perFactor = Rgb(cell->perFactor[0], cell->perFactor[1], cell->perFactor[2]);
        answer.training = training_;
        // All threads write the same number, and only if it is another one, so that they share the cache line.
        std::atomic_ref<uint16_t> lastUse(const_cast<Answer*>(cell)->lastUse);
        if (lastUse.load(std::memory_order_relaxed) != uint16_t(now_))
            lastUse.store(uint16_t(now_), std::memory_order_relaxed);
        return true;
    }
    return false;
}

void RadianceCells::add(const CacheDeposit& d, int level, const Place& place) {
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
        answers_[at] = Answer{.key = place.key, .points = place.points};
        sums = Sums{};
        std::copy_n(place.grid, 3, sums.grid);
        sums.generation = uint32_t(generationOf(level));
        sums.facing = uint32_t(place.facing);
    }
    answers_[at].lastUse = uint16_t(now_);
    const float perSize = 1 / sizeOf(level);
    const Vec3 corner = cornerOf(place.grid, level);
    for (int c = 0; c < 3; ++c) {
        sums.light[c] += unitsOf(double(d.light[c]), perQuantum_);
        sums.viewFactor[c] += uint32_t(std::lrint(d.viewFactor[c] * kViewFactorSteps));
        sums.position[c] += int32_t(std::lrint((d.at.p[c] - corner[c]) * perSize * kPositionUnits));
        sums.normal[c] += int32_t(std::lrint(d.at.n[c] * kNormalUnits));
    }
    const double y = relativeLuminance(d);
    sums.square += unitsOf(y * y, perSquare());
    if (++sums.count < kMostDeposits) return;
    for (int c = 0; c < 3; ++c) {
        sums.light[c] /= 2;
        sums.viewFactor[c] /= 2;
        sums.position[c] /= 2;
        sums.normal[c] /= 2;
    }
    sums.square /= 2;
    sums.count = sums.count / 2;
}

Rgb RadianceCells::perFactor(const Sums& sums) const {
    Rgb result(0.f);
    for (int c = 0; c < 3; ++c)
        if (sums.viewFactor[c] > 0)
            result[c] =
                float(double(sums.light[c]) / perQuantum_ / (double(sums.viewFactor[c]) / double(kViewFactorSteps)));
    return result;
}

// A cell that is seen from nearby is seen by few pixels, in which its noise would stand out.
bool RadianceCells::knowsEnough(const Sums& sums) const {
    return sums.count >= uint32_t(settings_.deposits) * (answerOf(sums).points == 0 ? 1 : kNearby);
}

// The cells within it share the deposits; their means are compared with the mean of all, which is what viewers see of
// them together. What the means differ by is no noise, but what smaller cells are there to show.
bool RadianceCells::divides(const Sums& sums) const {
    const double count = double(sums.countWithin), mean = meanOf(sums);
    constexpr double kCellsWithin = 4;
    return kCellsWithin * double(sums.within) / perSquare() <= double(settings_.variance) * mean * mean * count * count;
}

double RadianceCells::renewAnswer(Answer& answer, const Sums& sums) const {
    answer.known = false;
    const auto vector = [](const int32_t(&v)[3]) { return Vec3(float(v[0]), float(v[1]), float(v[2])); };
    const float length2 = lengthSquared(vector(sums.normal));
    if (!(length2 > 0)) return 1;
    const Vec3 normal = vector(sums.normal) * (1 / std::sqrt(length2));
    for (int c = 0; c < 3; ++c) answer.normal[c] = int8_t(std::lrint(normal[c] * kNormalUnits));
    // By the normal that look-ups see.
    const Vec3 seen = Vec3(answer.normal[0], answer.normal[1], answer.normal[2]) * (1 / kNormalUnits);
    const int level = levelOf(int(sums.generation));
    const float perUnit = sizeOf(level) / (kPositionUnits * float(sums.count));
    answer.plane = dot(seen, cornerOf(sums.grid, level) + vector(sums.position) * perUnit);
    const Rgb value = perFactor(sums);
    for (int c = 0; c < 3; ++c) answer.perFactor[c] = value[c];
    answer.known = true;
    const double count = double(sums.count), mean = double(luminance(value));
    const double variance = std::max(0.0, double(sums.square) / (perSquare() * count) - mean * mean) / count;
    return std::sqrt(variance) / std::max(1e-30, std::max(mean, kDimmest * mean_));
}

size_t RadianceCells::commit(std::span<std::vector<CacheDeposit>* const> lists) {
    ++now_;
    size_t deposits = 0;
    for (const auto* list : lists) deposits += list->size();
    // In a first pass nearly every deposit makes a cell or more; what does not fit into its bucket would be lost.
    while (answers_.size() < settings_.capacity &&
           double(used_) + double(deposits) > kMostUsed * double(answers_.size()))
        grow();
    boundDeposits(lists);
    deposits_ += deposits;
    // Each thread fills a part of the table, from all deposits in their order.
    const int parts = int(std::bit_ceil(unsigned(threadCount())));
    parallelFor(0, parts, 1, [&](int part, int) {
        struct Addition {
            const CacheDeposit* deposit;
            int level;
            Place place;
        };
        std::array<Addition, kBatch> batch;
        size_t waiting = 0;
        const auto addAll = [&] {
            for (size_t k = 0; k < waiting; ++k) add(*batch[k].deposit, batch[k].level, batch[k].place);
            waiting = 0;
        };
        for (const auto* list : lists)
            for (const CacheDeposit& d : *list) {
                const int largest = largestLevel(d.at);
                for (int level = 0; level <= largest; ++level) {
                    const Place place = placeOf(d.at.p, d.at.n, level, pointsOf(largest));
                    if (bucketOf(place.key) * size_t(parts) / answers_.size() != size_t(part)) continue;
                    prefetchBucket(place.key);
                    batch[waiting++] = {&d, level, place};
                    if (waiting == kBatch) addAll();
                }
            }
        addAll();
    });
    for (auto* list : lists) list->clear();
    renewAnswers();
    return deposits;
}

// A deposit so bright that it alone would be a large part of all light in the largest cell around it has met something
// that is too rare for the cells to tell how much light it stands for. A camera sample like that is a single bright
// pixel, which denoisers remove; a cell would show it to all who look at it. With the number of deposits nothing is
// lost.
void RadianceCells::boundDeposits(std::span<std::vector<CacheDeposit>* const> lists) {
    if (mean_ == 0) mean_ = firstMean(lists);
    const double bound = std::max(kLeastBound, kMostPerDeposits * double(deposits_));
    parallelFor(0, int(lists.size()), 1, [&](int begin, int end) {
        std::array<std::pair<CacheDeposit*, uint64_t>, kBatch> batch;
        size_t waiting = 0;
        const auto boundAll = [&] {
            for (size_t k = 0; k < waiting; ++k) {
                auto [d, key] = batch[k];
                double mean = mean_;
                if (const Answer* cell = find(key); cell != nullptr && sumsOf(*cell).count >= kLeastForBound)
                    mean = std::max(meanOf(sumsOf(*cell)), kLeastMean * mean_);
                const double y = relativeLuminance(*d), most = bound * mean;
                if (y > most) d->light *= float(most / y);
            }
            waiting = 0;
        };
        for (int i = begin; i < end; ++i)
            for (CacheDeposit& d : *lists[size_t(i)]) {
                const int largest = largestLevel(d.at);
                const uint64_t key = placeOf(d.at.p, d.at.n, largest, pointsOf(largest)).key;
                prefetchBucket(key);
                batch[waiting++] = {&d, key};
                if (waiting == kBatch) boundAll();
            }
        boundAll();
    });
}

// The cells around each cell are found once. All of it would else wait for memory, so that the cells of a batch are
// asked for before any of them is looked at.
void RadianceCells::renewAnswers() {
    constexpr int kPiece = 1 << 14;
    const int pieces = (int(answers_.size()) + kPiece - 1) / kPiece;
    // f gets the index of the piece and the range of its cells.
    const auto forEachPiece = [&](const auto& f) {
        parallelFor(0, pieces, 1, [&](int begin, int end) {
            for (int piece = begin; piece < end; ++piece)
                f(size_t(piece), size_t(piece) * kPiece, std::min(answers_.size(), size_t(piece + 1) * kPiece));
        });
    };
    struct Totals {
        int64_t light = 0, count = 0, errors = 0;
        size_t used = 0;
    };
    std::vector<Totals> totals(static_cast<size_t>(pieces));
    HugeArray<Link> links(answers_.size());

    // The deposits of cells of the smallest size, which are all deposits, and what the means of cells differ by within
    // a larger one. Integers, so that the order of additions does not matter.
    const double perMeanQuantum = perQuantum_ * 0x1p-16;
    forEachPiece([&](size_t, size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) sums_[i].within = sums_[i].countWithin = 0;
    });
    forEachPiece([&](size_t piece, size_t begin, size_t end) {
        Totals& total = totals[piece];
        std::array<Around, kBatch> batch;
        size_t waiting = 0;
        const auto addToLarger = [&] {
            for (size_t k = 0; k < waiting; ++k) {
                const Answer* larger = batch[k].key != 0 ? find(batch[k].key) : nullptr;
                links[batch[k].cell].larger = larger != nullptr ? uint32_t(larger - answers_.begin()) : kNone;
                if (larger != nullptr) __builtin_prefetch(&sumsOf(*larger).within, 1);
            }
            for (size_t k = 0; k < waiting; ++k) {
                const uint32_t larger = links[batch[k].cell].larger;
                if (larger == kNone) continue;
                const Sums& sums = sums_[batch[k].cell];
                const double mean = meanOf(sums);
                const double square = double(sums.square) - mean * mean * double(sums.count) * perSquare();
                Sums& its = sums_[larger];
                std::atomic_ref(its.within).fetch_add(int64_t(std::max(0.0, square)), std::memory_order_relaxed);
                std::atomic_ref(its.countWithin).fetch_add(uint32_t(sums.count), std::memory_order_relaxed);
            }
            waiting = 0;
        };
        for (size_t i = begin; i < end; ++i) {
            if (answers_[i].key == 0) continue;
            const Sums& sums = sums_[i];
            ++total.used;
            if (levelOf(int(sums.generation)) == 0) {
                total.light += unitsOf(meanOf(sums) * double(sums.count), perMeanQuantum);
                total.count += int64_t(sums.count);
            }
            const uint64_t key = keyAround(sums);
            if (key != 0) prefetchBucket(key);
            batch[waiting++] = {key, uint32_t(i)};
            if (waiting == kBatch) addToLarger();
        }
        addToLarger();
    });
    Totals all;
    for (const Totals& total : totals) {
        all.light += total.light;
        all.count += total.count;
        all.used += total.used;
    }
    used_ = all.used;
    mean_ = all.count > 0 ? double(all.light) / perMeanQuantum / double(all.count) : 0;

    forEachPiece([&](size_t, size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            if (answers_[i].key == 0) continue;
            links[i].enough = knowsEnough(sums_[i]);
            links[i].divides = links[i].enough && divides(sums_[i]);
        }
    });
    // From the largest cell around it on to smaller ones, as long as each may be divided. The larger one decides for
    // all cells within it: if each decided by its own variance, or by that of a part, those that happen to lack their
    // brightest samples would be preferred, and light would be lost.
    const auto sourceOf = [&](size_t cell) {
        std::array<uint32_t, kMostSizes> nested{uint32_t(cell)};
        size_t sizes = 1;
        for (uint32_t larger; sizes < kMostSizes && (larger = links[nested[sizes - 1]].larger) != kNone;)
            nested[sizes++] = larger;
        uint32_t source = kNone;
        while (sizes-- > 0) {
            if (!links[nested[sizes]].enough) continue;
            if (source != kNone && !links[source].divides) break;
            source = nested[sizes];
        }
        return source;
    };
    // The probability of training is the same everywhere. If it went by each cell's own error, noisy and bright parts
    // of a larger cell would have more weight in its mean than look-ups give them, and a cell that happens to lack its
    // brightest samples would long keep that answer.
    constexpr double kPerError = 0x1p10;
    forEachPiece([&](size_t piece, size_t begin, size_t end) {
        std::array<Source, kBatch> batch;
        size_t waiting = 0;
        const auto answer = [&] {
            for (size_t k = 0; k < waiting; ++k) {
                const auto [source, cell] = batch[k];
                const double error = source == kNone ? 1 : renewAnswer(answers_[cell], sums_[source]);
                if (source == kNone) answers_[cell].known = false;
                const Sums& own = sums_[cell];
                if (levelOf(int(own.generation)) == 0)
                    totals[piece].errors += std::llrint(std::min(error, 4.0) * kPerError) * int64_t(own.count);
            }
            waiting = 0;
        };
        for (size_t i = begin; i < end; ++i) {
            if (answers_[i].key == 0) continue;
            const uint32_t source = sourceOf(i);
            if (source != kNone && source != i) {
                const auto* sums = reinterpret_cast<const char*>(&sums_[source]);
                __builtin_prefetch(sums);
                __builtin_prefetch(sums + 64);
            }
            batch[waiting++] = {source, uint32_t(i)};
            if (waiting == kBatch) answer();
        }
        answer();
    });
    for (const Totals& total : totals) all.errors += total.errors;
    const double error =
        all.count > 0 ? double(all.errors) / kPerError / double(all.count) : kMostTraining / kTrainingPerError;
    training_ = float(std::clamp(kTrainingPerError * error, kLeastTraining, kMostTraining));
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

// Only what renewAnswers() does not find by itself. Cells come in their order in the table, so that those of a bucket
// have the same order again.
void RadianceCells::save(StateWriter& to) const {
    to.value(int32_t(refined_));
    to.value(now_);
    to.value(deposits_);
    to.value(uint64_t(answers_.size()));
    to.value(uint64_t(std::ranges::count_if(answers_, [](const Answer& a) { return a.key != 0; })));
    for (size_t i = 0; i < answers_.size(); ++i) {
        if (answers_[i].key == 0) continue;
        const Sums& sums = sums_[i];
        to.value(uint8_t(sums.generation));
        to.value(uint8_t(sums.facing));
        to.value(answers_[i].points);
        to.value(answers_[i].lastUse);
        to.value(uint32_t(sums.count));
        to.values(std::span(sums.grid));
        to.values(std::span(sums.light));
        to.value(sums.square);
        to.values(std::span(sums.viewFactor));
        to.values(std::span(sums.position));
        to.values(std::span(sums.normal));
    }
}

void RadianceCells::load(StateReader& from) {
    const auto refined = from.value<int32_t>();
    now_ = from.value<uint32_t>();
    deposits_ = from.value<uint64_t>();
    const auto size = from.value<uint64_t>(), cells = from.value<uint64_t>();
    if (refined < 0 || refined >= kMostRefined || !std::has_single_bit(size) || size < kWays ||
        size > settings_.capacity || cells > size)
        from.fail("there cannot be such a table of radiance cells");
    while (refined_ < refined) refine();
    answers_ = HugeArray<Answer>(size);
    sums_ = HugeArray<Sums>(size);
    for (uint64_t k = 0; k < cells; ++k) {
        const auto generation = from.value<uint8_t>(), facing = from.value<uint8_t>(), points = from.value<uint8_t>();
        Answer answer;
        Sums sums;
        answer.lastUse = from.value<uint16_t>();
        const auto count = from.value<uint32_t>();
        from.values(std::span(sums.grid));
        from.values(std::span(sums.light));
        from.values(std::span(&sums.square, 1));
        from.values(std::span(sums.viewFactor));
        from.values(std::span(sums.position));
        from.values(std::span(sums.normal));
        if (levelOf(generation) < 0 || levelOf(generation) >= settings_.sizes + refined_ || facing >= kFacings ||
            count == 0 || count >= kMostDeposits)
            from.fail("there cannot be such a radiance cell");
        sums.generation = generation;
        sums.facing = facing;
        sums.count = count;
        answer.points = points;
        answer.key = keyOf(sums.grid, facing, generation, points);
        const size_t bucket = bucketOf(answer.key);
        size_t at = bucket;
        while (at < bucket + kWays && answers_[at].key != 0 && answers_[at].key != answer.key) ++at;
        if (at == bucket + kWays || answers_[at].key != 0) from.fail("it has a radiance cell more than once");
        answers_[at] = answer;
        sums_[at] = sums;
    }
    renewAnswers();
}

void RadianceCells::refine() {
    if (refined_ + 1 >= kMostRefined) return;
    settings_.size *= 0.5f;
    ++refined_;
}

}  // namespace drc
