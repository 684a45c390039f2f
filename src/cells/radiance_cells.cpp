#include "cells/radiance_cells.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>

namespace drc {
namespace {

// A cell belongs to another surface than a point if the plane of its deposits is farther from the point than this share
// of the cell's size, or if the cosine between the normals is below this.
constexpr float kPlaneDistance = 0.4f, kLeastCosine = 0.7f;
// The table doubles when more than this share of it is used.
constexpr double kMostUsed = 0.4;
constexpr size_t kFirstCapacity = 1 << 14;
// The probability that a path continues past an answer to improve it is proportional to the mean of all answers'
// relative standard errors (relative to the answer, or to a share of the mean of all cells, whichever is more). It is
// the same everywhere: if it depended on each cell's own error, noisy and bright parts of a larger cell would have more
// weight in its mean than look-ups give them, and a cell that happens to lack its brightest samples would long keep
// that answer.
constexpr double kTrainingPerError = 1, kLeastTraining = 1 / 8.0, kMostTraining = 0.5;

RadianceCellSettings valid(RadianceCellSettings settings) {
    settings.capacity = std::bit_ceil(std::max(settings.capacity, CellTable::kWays));
    return settings;
}

}  // namespace

RadianceCells::RadianceCells(const RadianceCellSettings& settings)
    : settings_(valid(settings)),
      grid_(settings_.size, settings_.sizes),
      statistics_(settings_.lightScale),
      table_(std::min(kFirstCapacity, settings_.capacity)) {
    settings_.sizes = grid_.levels();
}

void RadianceCells::prefetch(const CachePoint& at) const {
    table_.prefetch(grid_.keyOf(at, 0, grid_.pointsOf(grid_.largestLevel(at))));
}

bool RadianceCells::lookUp(const CachePoint& at, CacheAnswer& answer) const {
    answer.training = 1;
    if (!accepts(at)) return false;
    const int largest = grid_.largestLevel(at);
    for (int level = 0; level <= largest; ++level) {
        const size_t index = table_.find(grid_.keyOf(at, level, grid_.pointsOf(largest)));
        if (index == CellTable::kNone) continue;
        const CellAnswer& cell = table_.answer(index);
        if (!cell.known) continue;
        const Vec3 normal = Vec3(cell.normal[0], cell.normal[1], cell.normal[2]) * (1 / kCellNormalUnits);
        if (dot(normal, at.n) < kLeastCosine) continue;
        if (std::abs(dot(normal, at.p) - cell.plane) > kPlaneDistance * grid_.sizeOf(level)) continue;
        answer.perFactor = Rgb(cell.perFactor[0], cell.perFactor[1], cell.perFactor[2]);
        answer.training = training_;
        // All threads write the same number, and only if it is another one, so that they share the cache line.
        std::atomic_ref<uint16_t> lastUse(const_cast<CellAnswer&>(cell).lastUse);
        if (lastUse.load(std::memory_order_relaxed) != uint16_t(now_))
            lastUse.store(uint16_t(now_), std::memory_order_relaxed);
        return true;
    }
    return false;
}

size_t RadianceCells::commit(std::span<std::vector<CacheDeposit>* const> lists) {
    ++now_;
    CellDeposits deposits(lists);
    const size_t count = deposits.count();
    // In a first pass nearly every deposit creates a cell or more; cells that do not fit into their bucket would be
    // lost.
    size_t cells = table_.size();
    while (cells<settings_.capacity&& double(totals_.used) + double(count)> kMostUsed * double(cells)) cells *= 2;
    if (cells > table_.size()) table_.grow(cells);
    deposits.bound(table_, grid_, statistics_, totals_.mean == 0 ? deposits.robustMean() : totals_.mean, deposits_);
    deposits_ += count;
    deposits.addTo(table_, grid_, statistics_, now_, placed_);
    if (carried_) forgotten_ += carried_->forget(table_, grid_, statistics_);
    for (auto* list : lists) list->clear();
    renewAnswers();
    return count;
}

void RadianceCells::renewAnswers() {
    totals_ = renewCellAnswers(table_, grid_, statistics_, {settings_.deposits, settings_.variance});
    const double training = totals_.any ? kTrainingPerError * totals_.error : kMostTraining;
    training_ = float(std::clamp(training, kLeastTraining, kMostTraining));
}

void RadianceCells::dropCarried() {
    if (!carried_) return;
    carried_->forgetAll(table_);
    carried_.reset();
    renewAnswers();
}

void RadianceCells::refine() {
    grid_.refine();
    settings_.size = grid_.sizeOf(0);
}

}  // namespace drc
