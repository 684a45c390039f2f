// Radiance cells in checkpoints and in files of their own.
#include <algorithm>
#include <bit>
#include <cmath>

#include "cells/radiance_cells.h"

namespace drc {

// Writes only what renewAnswers() cannot compute. Cells are written in table order, so that load() restores their order
// within each bucket.
void RadianceCells::save(StateWriter& to) const {
    size_t cells = 0;
    for (size_t i = 0; i < table_.size(); ++i) cells += table_.answer(i).key != 0;
    to.value(settings_.size * float(1 << grid_.refined()));
    to.value(int32_t(settings_.sizes));
    to.value(settings_.lightScale);
    to.value(uint8_t(carried_.has_value()));
    if (carried_) carried_->cells().save(to);
    to.value(int32_t(grid_.refined()));
    to.value(now_);
    to.value(deposits_);
    to.value(uint64_t(table_.size()));
    to.value(uint64_t(cells));
    for (size_t i = 0; i < table_.size(); ++i) {
        const CellAnswer& answer = table_.answer(i);
        if (answer.key == 0) continue;
        const CellSums& sums = table_.sums(i);
        to.value(uint8_t(sums.generation));
        to.value(uint8_t(sums.facing));
        to.value(answer.points);
        to.value(answer.lastUse);
        to.value(uint32_t(sums.count));
        to.value(uint8_t(sums.carried));
        to.values(std::span(sums.cube.at));
        to.values(std::span(sums.light));
        to.value(sums.square);
        to.values(std::span(sums.viewFactor));
        to.values(std::span(sums.position));
        to.values(std::span(sums.normal));
    }
}

void RadianceCells::load(StateReader& from) {
    const auto edge = from.value<float>();
    const auto sizes = from.value<int32_t>();
    const auto lightScale = from.value<float>();
    if (!(edge > 0) || !std::isfinite(edge) || sizes < 1 || sizes > CellGrid::kMostSizes || !std::isfinite(lightScale))
        from.fail("there cannot be radiance cells of such a size");
    RadianceCellSettings settings = settings_;
    settings.size = edge;
    settings.sizes = sizes;
    settings.lightScale = lightScale;
    *this = RadianceCells(settings);
    if (from.value<uint8_t>() != 0) carried_.emplace(CellCollection::load(from));
    const auto refined = from.value<int32_t>();
    now_ = from.value<uint32_t>();
    deposits_ = from.value<uint64_t>();
    const auto size = from.value<uint64_t>(), cells = from.value<uint64_t>();
    if (refined < 0 || refined >= CellGrid::kMostRefined || !std::has_single_bit(size) || size < CellTable::kWays ||
        size > settings_.capacity || cells > size)
        from.fail("there cannot be such a table of radiance cells");
    while (grid_.refined() < refined) refine();
    table_ = CellTable(size);
    for (uint64_t k = 0; k < cells; ++k) {
        const auto generation = from.value<uint8_t>(), facing = from.value<uint8_t>(), points = from.value<uint8_t>();
        CellAnswer answer;
        CellSums sums;
        answer.lastUse = from.value<uint16_t>();
        const auto count = from.value<uint32_t>();
        sums.carried = from.value<uint8_t>() != 0;
        from.values(std::span(sums.cube.at));
        from.values(std::span(sums.light));
        from.values(std::span(&sums.square, 1));
        from.values(std::span(sums.viewFactor));
        from.values(std::span(sums.position));
        from.values(std::span(sums.normal));
        if (grid_.levelOf(generation) < 0 || grid_.levelOf(generation) >= grid_.levels() + grid_.refined() ||
            facing >= CellGrid::kFacings || count == 0 || count >= CellStatistics::kMostDeposits ||
            (sums.carried && !carried_))
            from.fail("there cannot be such a radiance cell");
        sums.generation = generation;
        sums.facing = facing;
        sums.count = count;
        answer.points = points;
        answer.key = CellGrid::keyOf(sums.cube, facing, generation, points);
        const size_t bucket = table_.bucketOf(answer.key) * CellTable::kWays;
        size_t at = bucket;
        while (at < bucket + CellTable::kWays && table_.answer(at).key != 0 && table_.answer(at).key != answer.key)
            ++at;
        if (at == bucket + CellTable::kWays || table_.answer(at).key != 0)
            from.fail("it has a radiance cell more than once");
        table_.answer(at) = answer;
        table_.sums(at) = sums;
    }
    renewAnswers();
    if (awaitsComparison()) withholdAnswers();
}

RadianceCells::RadianceCells(const CellCollection& collection, size_t capacity)
    : RadianceCells({.size = collection.size,
                     .sizes = collection.sizes,
                     .capacity = capacity,
                     .lightScale = collection.lightScale}) {
    while (grid_.refined() < collection.refined) refine();
    deposits_ = collection.deposits;
    // At this load one bucket of 300 has more cells than places; a table at its capacity may have to leave out more. A
    // small table grows until there is room for all.
    constexpr size_t kPlacesPerCell = 4, kSmall = 1 << 16;
    size_t places = std::bit_ceil(std::max<size_t>(1, collection.cells.size()) * kPlacesPerCell);
    for (;; places *= 2) {
        places = std::clamp(places, CellTable::kWays, settings_.capacity);
        table_ = CellTable(places);
        if (fill(collection) == 0 || places >= std::min(kSmall, settings_.capacity)) break;
    }
    renewAnswers();
}

RadianceCells::RadianceCells(CarriedCells carried, size_t capacity) : RadianceCells(carried.cells(), capacity) {
    for (size_t i = 0; i < table_.size(); ++i) table_.sums(i).carried = table_.answer(i).key != 0;
    carried_ = std::move(carried);
    withholdAnswers();
}

void RadianceCells::withholdAnswers() {
    for (size_t i = 0; i < table_.size(); ++i) table_.answer(i).known = false;
}

size_t RadianceCells::fill(const CellCollection& collection) {
    size_t lost = 0;
    for (CollectedCell cell : collection.cells) {
        cell.reduce(CellStatistics::kMostDeposits);
        CellSums sums;
        for (int c = 0; c < 3; ++c) {
            sums.cube.at[c] = cell.place.cube[c];
            sums.light[c] = cell.light[c];
            sums.viewFactor[c] = uint32_t(cell.viewFactor[c]);
            sums.position[c] = int32_t(cell.position[c]);
            sums.normal[c] = int32_t(cell.normal[c]);
        }
        sums.square = cell.square;
        sums.generation = cell.place.generation;
        sums.facing = cell.place.facing;
        sums.count = uint32_t(cell.count);
        CellAnswer answer;
        answer.points = cell.place.points;
        answer.key = CellGrid::keyOf(sums.cube, cell.place.facing, cell.place.generation, cell.place.points);
        answer.lastUse = uint16_t(now_);
        // An empty place in the bucket, else that of the cell with the fewest deposits.
        const size_t bucket = table_.bucketOf(answer.key) * CellTable::kWays;
        size_t at = bucket;
        for (size_t other = bucket; other < bucket + CellTable::kWays; ++other) {
            if (table_.answer(other).key == 0) {
                at = other;
                break;
            }
            if (table_.sums(other).count < table_.sums(at).count) at = other;
        }
        const bool isFull = table_.answer(at).key != 0;
        lost += isFull;
        if (isFull && table_.sums(at).count >= sums.count) continue;
        table_.answer(at) = answer;
        table_.sums(at) = sums;
    }
    return lost;
}

CellCollection RadianceCells::collect(const Vec3& origin) const {
    CellCollection all;
    all.size = settings_.size * float(1 << grid_.refined());
    all.sizes = grid_.levels();
    all.refined = grid_.refined();
    all.lightScale = settings_.lightScale;
    all.origin = origin;
    all.deposits = deposits_;
    for (size_t i = 0; i < table_.size(); ++i) {
        const CellAnswer& answer = table_.answer(i);
        if (answer.key == 0) continue;
        const CellSums& sums = table_.sums(i);
        CollectedCell& cell = all.cells.emplace_back();
        for (int c = 0; c < 3; ++c) {
            cell.place.cube[c] = sums.cube.at[c];
            cell.light[c] = sums.light[c];
            cell.viewFactor[c] = sums.viewFactor[c];
            cell.position[c] = sums.position[c];
            cell.normal[c] = sums.normal[c];
        }
        cell.place.generation = uint8_t(sums.generation);
        cell.place.facing = uint8_t(sums.facing);
        cell.place.points = answer.points;
        cell.square = sums.square;
        cell.count = sums.count;
    }
    std::ranges::sort(all.cells, {}, &CollectedCell::place);
    return all;
}

CellCollection RadianceCells::carry(const Vec3& origin) const {
    CellCollection all = collect(origin);
    for (CollectedCell& cell : all.cells) {
        const size_t at = table_.find(keyOf(cell.place));
        const CollectedCell* old = carried_ && table_.sums(at).carried ? carried_->find(cell.place) : nullptr;
        if (old) cell.takeOut(*old);
        cell.reduce(CarriedCells::kMostCarried + 1);
    }
    std::erase_if(all.cells, [](const CollectedCell& cell) { return cell.count == 0; });
    // Deposits are bounded anew: their bound may have been that of other light.
    all.deposits = 0;
    return all;
}

}  // namespace drc
