// Deposits on their way into the table of radiance cells, from several lists. Work is divided in chunks of deposits,
// and the table in parts, whatever the number of threads is: each part gets its deposits in the order of the lists.
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
    // After sort(), in the order of add().
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
    // The lists must not change meanwhile.
    explicit CellDeposits(std::span<std::vector<CacheDeposit>* const> lists);

    size_t count() const { return begins_.back(); }

    // The mean of relativeLuminance, in which deposits that stand out far count little.
    double robustMean() const;
    // Bounds the light of deposits that would be a large part of all light in the largest cell around them: such a
    // deposit has met something that is too rare for the cells to tell how much light it stands for. As a camera sample
    // it is a single bright pixel, which denoisers remove; a cell would show it to all who look at it. The bound is the
    // mean of that cell, or of all deposits where it knows little, times a factor that rises with depositsBefore, those
    // of earlier commits, so that the bias vanishes.
    void bound(const CellTable& table, const CellGrid& grid, const CellStatistics& statistics, double meanOfAll,
               uint64_t depositsBefore);
    // Adds each deposit to its cell of each size. now: the number of the commit. placed: memory that is kept from one
    // commit to the next.
    void addTo(CellTable& table, const CellGrid& grid, const CellStatistics& statistics, uint32_t now,
               std::vector<PlacedDeposits>& placed) const;

  private:
    static constexpr size_t kChunk = 1024;
    size_t chunks() const { return (count() + kChunk - 1) / kChunk; }
    // Calls f(deposit) for each deposit of a chunk.
    template <class F>
    void forEach(size_t chunk, const F& f) const;

    std::span<std::vector<CacheDeposit>* const> lists_;
    std::vector<size_t> begins_;  // of each list, counted over all lists, and the end
};

}  // namespace drc
