#include "cells/cell_deposits.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "base/parallel.h"

namespace drc {
namespace {

// The bound of a deposit is the mean around it times a factor: this share of the number of deposits so far, and at
// least kLeastBound, about the number of deposits in a large cell after a few passes. The mean is that of the largest
// cell around the deposit if the cell has kLeastForBound deposits, and then at least kLeastMean times the mean of all;
// otherwise it is the mean of all.
constexpr double kMostPerDeposits = 0x1p-10, kLeastBound = 1024, kLeastMean = 1 / 16.0;
constexpr uint32_t kLeastForBound = 64;
// Number of parts of the table, so large that each of many threads gets several.
constexpr size_t kParts = 256;
// Number of chunks that are placed before any is added. It bounds the memory to about 10 MB, and keeps many threads
// busy.
constexpr size_t kChunksAtATime = 128;

// The index of the cell that an addition goes to, created if need be; CellTable::kNone if its bucket has no room.
size_t cellFor(const PlacedDeposits::Addition& a, CellTable& table, const CellGrid& grid, uint32_t now) {
    const size_t cell = table.claim(a.key, now);
    if (cell == CellTable::kNone) return cell;
    CellAnswer& answer = table.answer(cell);
    if (answer.key != a.key) {
        answer = CellAnswer{.key = a.key, .points = a.points};
        CellSums& sums = table.sums(cell);
        sums = CellSums{};
        sums.cube = grid.cubeOf(a.deposit->at.p, int(a.level));
        sums.generation = uint32_t(grid.generationOf(int(a.level)));
        sums.facing = uint32_t(CellGrid::facing(a.deposit->at.n));
    }
    answer.lastUse = uint16_t(now);
    return cell;
}

// Nearly all of the time would be spent waiting for memory, so it is prefetched a batch ahead.
void addAll(std::span<const PlacedDeposits::Addition> additions, CellTable& table, const CellGrid& grid,
            const CellStatistics& statistics, uint32_t now) {
    std::array<size_t, CellTable::kBatch> cells;
    for (; !additions.empty(); additions = additions.subspan(std::min(CellTable::kBatch, additions.size()))) {
        const auto batch = additions.first(std::min(CellTable::kBatch, additions.size()));
        for (const auto& addition : batch) table.prefetch(addition.key);
        for (size_t k = 0; k < batch.size(); ++k) {
            cells[k] = cellFor(batch[k], table, grid, now);
            if (cells[k] != CellTable::kNone) table.prefetchSums(cells[k]);
        }
        for (size_t k = 0; k < batch.size(); ++k)
            if (cells[k] != CellTable::kNone)
                statistics.add(*batch[k].deposit, grid, int(batch[k].level), table.sums(cells[k]));
    }
}

}  // namespace

void PlacedDeposits::add(const Addition& addition, size_t part) { found_.push_back({addition, uint32_t(part)}); }

void PlacedDeposits::sort(size_t parts) {
    begins_.assign(parts + 1, 0);
    for (const Found& found : found_) ++begins_[found.part + 1];
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    sorted_.resize(found_.size());
    next_.assign(begins_.begin(), begins_.end() - 1);
    for (const Found& found : found_) sorted_[next_[found.part]++] = found.addition;
}

CellDeposits::CellDeposits(std::span<std::vector<CacheDeposit>* const> lists) : lists_(lists), begins_{0} {
    for (const auto* list : lists) begins_.push_back(begins_.back() + list->size());
}

template <class F>
void CellDeposits::forEach(size_t chunk, const F& f) const {
    const size_t end = std::min(count(), (chunk + 1) * kChunk);
    size_t at = chunk * kChunk;
    auto list = size_t(std::ranges::upper_bound(begins_, at) - begins_.begin()) - 1;
    for (; at < end; ++list)
        for (const size_t last = std::min(end, begins_[list + 1]); at < last; ++at)
            f((*lists_[list])[at - begins_[list]]);
}

double CellDeposits::robustMean() const {
    constexpr double kFar = kLeastBound;
    std::vector<double> sums(chunks());
    double mean = kInfinity, before;
    do {
        parallelFor(0, int(chunks()), 8, [&](int begin, int end) {
            for (auto chunk = size_t(begin); chunk < size_t(end); ++chunk) {
                double sum = 0;
                forEach(chunk, [&](const CacheDeposit& d) {
                    sum += std::min(CellStatistics::relativeLuminance(d), kFar * mean);
                });
                sums[chunk] = sum;
            }
        });
        const double sum = std::accumulate(sums.begin(), sums.end(), 0.0);
        before = std::exchange(mean, count() > 0 ? sum / double(count()) : 0);
    } while (mean < 0.5 * before);
    return mean;
}

void CellDeposits::bound(const CellTable& table, const CellGrid& grid, const CellStatistics& statistics,
                         double meanOfAll, uint64_t depositsBefore) {
    const double bound = std::max(kLeastBound, kMostPerDeposits * double(depositsBefore));
    const auto boundOne = [&](CacheDeposit& d, uint64_t key) {
        double mean = meanOfAll;
        const size_t cell = table.find(key);
        if (cell != CellTable::kNone && table.sums(cell).count >= kLeastForBound)
            mean = std::max(statistics.mean(table.sums(cell)), kLeastMean * meanOfAll);
        const double y = CellStatistics::relativeLuminance(d), most = bound * mean;
        if (y > most) d.light *= float(most / y);
    };
    parallelFor(0, int(chunks()), 8, [&](int begin, int end) {
        std::array<std::pair<CacheDeposit*, uint64_t>, CellTable::kBatch> batch;
        size_t waiting = 0;
        const auto boundAll = [&] {
            for (size_t k = 0; k < waiting; ++k) boundOne(*batch[k].first, batch[k].second);
            waiting = 0;
        };
        for (auto chunk = size_t(begin); chunk < size_t(end); ++chunk)
            forEach(chunk, [&](CacheDeposit& d) {
                const int largest = grid.largestLevel(d.at);
                const uint64_t key = grid.keyOf(d.at, largest, grid.pointsOf(largest));
                table.prefetch(key);
                batch[waiting++] = {&d, key};
                if (waiting == CellTable::kBatch) boundAll();
            });
        boundAll();
    });
}

void CellDeposits::addTo(CellTable& table, const CellGrid& grid, const CellStatistics& statistics, uint32_t now,
                         std::vector<PlacedDeposits>& placed) const {
    const size_t parts = std::min(kParts, table.buckets());
    placed.resize(kChunksAtATime);
    for (size_t first = 0; first < chunks(); first += placed.size()) {
        const size_t here = std::min(placed.size(), chunks() - first);
        parallelFor(0, int(here), 1, [&](int begin, int end) {
            for (auto k = size_t(begin); k < size_t(end); ++k) {
                PlacedDeposits& chunk = placed[k];
                chunk.clear();
                forEach(first + k, [&](const CacheDeposit& d) {
                    const int largest = grid.largestLevel(d.at);
                    const uint8_t points = grid.pointsOf(largest);
                    for (int level = 0; level <= largest; ++level) {
                        const uint64_t key = grid.keyOf(d.at, level, points);
                        chunk.add({key, &d, uint32_t(level), points}, table.bucketOf(key) * parts / table.buckets());
                    }
                });
                chunk.sort(parts);
            }
        });
        parallelFor(0, int(parts), 1, [&](int begin, int end) {
            for (auto part = size_t(begin); part < size_t(end); ++part)
                for (size_t k = 0; k < here; ++k) addAll(placed[k].part(part), table, grid, statistics, now);
        });
    }
}

}  // namespace drc
