#include "cells/carried_cells.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "base/parallel.h"

namespace drc {
namespace {

// A cell is compared once it has this many fresh deposits, and until it has kMostTimes as many as carried ones, which
// then no longer matter.
constexpr double kLeastFresh = 16, kMostTimes = 64;
// The means disagree if they differ by more than this many standard errors of their difference. Deposits have long
// tails, and each cell is compared after every commit.
constexpr double kStandardErrors = 4.5;
// Carried cells that a thread works on at a time.
constexpr int kCellsAtOnce = 1 << 10;

// The sums of some deposits of a cell, as numbers.
struct Sums {
    double count = 0, square = 0;
    double light[3]{}, viewFactor[3]{};
};

Sums sumsOf(const CellSums& all) {
    Sums sums{double(all.count), double(all.square), {}, {}};
    for (int c = 0; c < 3; ++c) {
        sums.light[c] = double(all.light[c]);
        sums.viewFactor[c] = double(all.viewFactor[c]);
    }
    return sums;
}

Sums sumsOf(const CollectedCell& cell) {
    Sums sums{double(cell.count), double(cell.square), {}, {}};
    for (int c = 0; c < 3; ++c) {
        sums.light[c] = double(cell.light[c]);
        sums.viewFactor[c] = double(cell.viewFactor[c]);
    }
    return sums;
}

Sums operator-(Sums a, const Sums& b) {
    a.count -= b.count;
    a.square -= b.square;
    for (int c = 0; c < 3; ++c) {
        a.light[c] -= b.light[c];
        a.viewFactor[c] -= b.viewFactor[c];
    }
    return a;
}

// Whether fresh and carried deposits have different means, in luminance or in a channel. The variance is that of all
// deposits together: fresh ones alone often lack the few bright ones that make up most of it, and cells would then
// forget whenever their fresh mean happens to be too dark.
bool disagree(const Sums& all, const Sums& carried, const CellStatistics& statistics) {
    const Sums fresh = all - carried;
    if (fresh.count < kLeastFresh || fresh.count > kMostTimes * carried.count) return false;
    const auto mean = [](const Sums& s, int c) { return s.viewFactor[c] > 0 ? s.light[c] / s.viewFactor[c] : 0; };
    const auto luminanceOf = [&](const Sums& s) {
        return 0.2126 * mean(s, 0) + 0.7152 * mean(s, 1) + 0.0722 * mean(s, 2);
    };
    const double whole = luminanceOf(all);
    if (!(whole > 0)) return false;
    // The relative variance of the deposits is the same in all units.
    CellSums of;
    for (int c = 0; c < 3; ++c) {
        of.light[c] = int64_t(all.light[c]);
        of.viewFactor[c] = uint32_t(all.viewFactor[c]);
    }
    of.square = int64_t(all.square);
    of.count = uint32_t(all.count);
    const double m = statistics.mean(of);
    const double relativeVariance = statistics.variance(of, m) / (m * m);
    const double limit = kStandardErrors * std::sqrt(relativeVariance * (1 / fresh.count + 1 / carried.count));
    const auto differ = [&](double a, double b, double unit) { return std::abs(a - b) > limit * unit; };
    if (differ(luminanceOf(fresh), luminanceOf(carried), whole)) return true;
    for (int c = 0; c < 3; ++c)
        if (differ(mean(fresh, c), mean(carried, c), std::max(mean(all, c), 0.1 * whole))) return true;
    return false;
}

// Where light has changed: cubes of each generation.
class ChangedCubes {
  public:
    // A cell of this cube has noticed a change. Its neighbours have it, too, and so has all within them.
    void add(const CellPlace& place, int largest) {
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z)
                    around_.insert(cubeKey(place.generation, place.cube[0] + x, place.cube[1] + y, place.cube[2] + z));
        for (int g = place.generation + 1, up = 1; g <= largest; ++g, ++up)
            containing_.insert(cubeKey(g, place.cube[0] >> up, place.cube[1] >> up, place.cube[2] >> up));
    }
    bool empty() const { return around_.empty(); }
    bool contains(const CellPlace& place, int largest) const {
        if (containing_.contains(cubeKey(place.generation, place.cube[0], place.cube[1], place.cube[2]))) return true;
        for (int g = place.generation, up = 0; g <= largest; ++g, ++up)
            if (around_.contains(cubeKey(g, place.cube[0] >> up, place.cube[1] >> up, place.cube[2] >> up)))
                return true;
        return false;
    }

  private:
    // All directions and kinds of points that share a cube share its key.
    static uint64_t cubeKey(int generation, int32_t x, int32_t y, int32_t z) {
        return CellGrid::keyOf({{x, y, z}}, 0, generation, 0);
    }
    std::unordered_set<uint64_t> around_, containing_;
};

// Takes the carried sums out of a cell. What was halved since it was carried is no longer there.
void takeOut(const CollectedCell& carried, CellAnswer& answer, CellSums& sums) {
    sums.carried = 0;
    if (sums.count <= carried.count) {
        answer = {};
        sums = {};
        return;
    }
    sums.count = uint32_t(sums.count - carried.count);
    sums.square = std::max<int64_t>(0, sums.square - carried.square);
    for (int c = 0; c < 3; ++c) {
        sums.light[c] -= carried.light[c];
        sums.viewFactor[c] = uint32_t(std::max<int64_t>(0, int64_t(sums.viewFactor[c]) - carried.viewFactor[c]));
        sums.position[c] = int32_t(sums.position[c] - carried.position[c]);
        sums.normal[c] = int32_t(sums.normal[c] - carried.normal[c]);
    }
}

// The cell in the table that still contains the carried sums, or kNone.
size_t carrierOf(const CollectedCell& cell, const CellTable& table) {
    const size_t at = table.find(keyOf(cell.place));
    return at != CellTable::kNone && table.sums(at).carried ? at : CellTable::kNone;
}

}  // namespace

const CollectedCell* CarriedCells::find(const CellPlace& place) const {
    const auto found = std::ranges::lower_bound(cells_.cells, place, {}, &CollectedCell::place);
    return found != cells_.cells.end() && found->place == place ? &*found : nullptr;
}

size_t CarriedCells::forget(CellTable& table, const CellGrid& grid, const CellStatistics& statistics) const {
    const std::vector<CollectedCell>& cells = cells_.cells;
    const int largest = grid.generationOf(grid.levels() - 1);
    const int pieces = (int(cells.size()) + kCellsAtOnce - 1) / kCellsAtOnce;
    const auto forEachPiece = [&](const auto& f) {
        parallelFor(0, pieces, 1, [&](int begin, int end) {
            for (auto piece = size_t(begin); piece < size_t(end); ++piece)
                for (size_t i = piece * kCellsAtOnce; i < std::min(cells.size(), (piece + 1) * kCellsAtOnce); ++i)
                    f(piece, cells[i]);
        });
    };
    std::vector<std::vector<const CollectedCell*>> noticed{size_t(pieces)};
    forEachPiece([&](size_t piece, const CollectedCell& cell) {
        const size_t at = carrierOf(cell, table);
        if (at != CellTable::kNone && disagree(sumsOf(table.sums(at)), sumsOf(cell), statistics))
            noticed[piece].push_back(&cell);
    });
    ChangedCubes changed;
    for (const auto& piece : noticed)
        for (const CollectedCell* cell : piece) changed.add(cell->place, largest);
    if (changed.empty()) return 0;
    std::vector<size_t> forgotten(static_cast<size_t>(pieces));
    forEachPiece([&](size_t piece, const CollectedCell& cell) {
        if (!changed.contains(cell.place, largest)) return;
        const size_t at = carrierOf(cell, table);
        if (at == CellTable::kNone) return;
        takeOut(cell, table.answer(at), table.sums(at));
        ++forgotten[piece];
    });
    size_t all = 0;
    for (const size_t count : forgotten) all += count;
    return all;
}

void CarriedCells::forgetAll(CellTable& table) const {
    for (const CollectedCell& cell : cells_.cells)
        if (const size_t at = carrierOf(cell, table); at != CellTable::kNone)
            takeOut(cell, table.answer(at), table.sums(at));
}

}  // namespace drc
