// The hash table of radiance cells: the sums over each cell's deposits, and its answer. A key may lie in any cell of
// one bucket, which is two cache lines. The memory is bounded: in a full bucket, a new cell replaces the least recently
// used one.
#pragma once
#include <cstdint>

#include "base/huge_array.h"
#include "cells/cell_grid.h"

namespace drc {

// The data that a look-up reads: half a cache line.
struct alignas(32) CellAnswer {
    uint64_t key = 0;  // from CellGrid::keyOf; 0: there is no cell
    float perFactor[3]{};
    int8_t normal[3]{};  // of the surface, in units of 1/127
    bool known = false;
    float plane = 0;       // distance of the surface from the world's origin along the normal, world units
    uint16_t lastUse = 0;  // number of the latest commit in which the cell was used, modulo 2^16
    uint8_t points = 0;    // class of the points that the cell is for, see CellGrid::pointsOf
};

// Sums over a cell's deposits: integers, so that their order does not matter.
struct CellSums {
    int64_t light[3]{};
    int64_t square = 0;  // of CellStatistics::relativeLuminance
    // Sum of the squared deviations of the deposits in the cells of the next smaller size from those cells' means.
    // Nonzero only while answers are renewed.
    int64_t within = 0;
    uint32_t viewFactor[3]{};  // in steps of kViewFactorSteps
    int32_t position[3]{};     // from the cube's corner, in units of kCellPositionUnits
    int32_t normal[3]{};
    GridCube cube;
    uint32_t countWithin = 0;  // deposits in the cells of the next smaller size; nonzero like `within`
    uint32_t count : 21 = 0;
    uint32_t carried : 1 = 0;     // whether the sums contain those of CarriedCells
    uint32_t generation : 5 = 0;  // of the cell's size, see CellGrid::generationOf
    uint32_t facing : 5 = 0;
};
static_assert(sizeof(CellAnswer) == 32 && sizeof(CellSums) == 96);

class CellTable {
  public:
    // Cells in a bucket.
    static constexpr size_t kWays = 4;
    static constexpr size_t kNone = ~size_t(0);
    // Number of cells whose memory is prefetched together. Without prefetching, nearly all of the time of a walk over
    // cells would be spent waiting for memory.
    static constexpr size_t kBatch = 32;

    // cells: a power of two, at least kWays.
    explicit CellTable(size_t cells) : answers_(cells), sums_(cells) {}

    size_t size() const { return answers_.size(); }
    size_t buckets() const { return size() / kWays; }
    size_t bucketOf(uint64_t key) const { return (size_t(key) & (size() - kWays)) / kWays; }

    CellAnswer& answer(size_t cell) { return answers_[cell]; }
    const CellAnswer& answer(size_t cell) const { return answers_[cell]; }
    CellSums& sums(size_t cell) { return sums_[cell]; }
    const CellSums& sums(size_t cell) const { return sums_[cell]; }

    // The index of the key's cell, or kNone.
    size_t find(uint64_t key) const {
        const size_t first = bucketOf(key) * kWays;
        for (size_t cell = first; cell < first + kWays; ++cell)
            if (answers_[cell].key == key) return cell;
        return kNone;
    }
    void prefetch(uint64_t key) const {
        const auto* bucket = reinterpret_cast<const char*>(&answers_[bucketOf(key) * kWays]);
        __builtin_prefetch(bucket);
        __builtin_prefetch(bucket + 64);
    }
    void prefetchSums(size_t cell) const {
        const auto* sums = reinterpret_cast<const char*>(&sums_[cell]);
        __builtin_prefetch(sums, 1);
        __builtin_prefetch(sums + 64, 1);
    }
    // The index of the key's cell. If there is none, the index of a cell to use for it, which still has its old key: an
    // empty cell, or the least recently used one. kNone: all were used in the commit `now` or in the one before.
    size_t claim(uint64_t key, uint32_t now) const;
    // Grows the table to this number of cells, a greater power of two.
    void grow(size_t cells);

  private:
    HugeArray<CellAnswer> answers_;
    HugeArray<CellSums> sums_;  // by the same indices
};

}  // namespace drc
