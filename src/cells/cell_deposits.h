// Deposits on their way from several lists into the table of radiance cells. Deposits are divided into chunks, and the
// table into parts, independently of the number of threads: each part gets its deposits in the order of the lists.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "cells/cell_statistics.h"

namespace drc {

// The additions of a chunk of deposits to the table, sorted by the part of the table. clear() keeps the memory for
// reuse.
class PlacedDeposits {
  public:
    struct Addition {
        uint64_t key;
        const CacheDeposit* deposit;
        uint32_t level;
        uint8_t points;
    };
    void clear() { found_.clear(); }
    void add(const Addition& addition, size_t part);
    void sort(size_t parts);
    // The additions to a part, in the order of add(). Only after sort().
    std::span<const Addition> part(size_t part) const {
        return std::span(sorted_).subspan(begins_[part], begins_[part + 1] - begins_[part]);
    }

  private:
    struct Found {
        Addition addition;
        uint32_t part;
    };
    std::vector<Found> found_;
    std::vector<Addition> sorted_;
    std::vector<uint32_t> begins_, next_;
};

class CellDeposits {
  public:
    // The lists must outlive this object, and their sizes must not change.
    explicit CellDeposits(std::span<std::vector<CacheDeposit>* const> lists);

    size_t count() const { return begins_.back(); }

    // The mean of relativeLuminance over all deposits, each of which counts at most about 1024 times the mean.
    double robustMean() const;
    // Bounds the light of deposits that would be a large part of all light in the largest cell around them. Such a
    // deposit found something too rare for the cells to estimate its mean. In a camera sample it is a single bright
    // pixel, which denoisers remove; a cell would show it in every look-up. The bound is the mean of that cell, or of
    // all deposits (meanOfAll) where the cell has too few, times a factor that rises with depositsBefore, the number of
    // deposits in earlier commits, so that the bias vanishes.
    void bound(const CellTable& table, const CellGrid& grid, const CellStatistics& statistics, double meanOfAll,
               uint64_t depositsBefore);
    // Adds each deposit to its cell of each size. now: the number of the commit. placed: scratch memory, reused by the
    // next commit.
    void addTo(CellTable& table, const CellGrid& grid, const CellStatistics& statistics, uint32_t now,
               std::vector<PlacedDeposits>& placed) const;

  private:
    static constexpr size_t kChunk = 1024;
    size_t chunks() const { return (count() + kChunk - 1) / kChunk; }
    // Calls f(deposit) for each deposit of a chunk.
    template <class F>
    void forEach(size_t chunk, const F& f) const;

    std::span<std::vector<CacheDeposit>* const> lists_;
    std::vector<size_t> begins_;  // index of each list's first deposit among all deposits; last, their number
};

}  // namespace drc
