// Radiance cells: a hash table over the surfaces of a scene, of the radiance that their separable lobes scatter,
// divided by their view factor, so that textures stay sharp. Paths of final gather end in it. World-space hash tables
// of this kind are described by Binder et al., "Massively Parallel Path Space Filtering" (2018).
//
// Deposits are unbiased samples, but for a bound on those that stand out far: the cells' own answers are never
// deposited, so that no error builds up. Look-ups see what earlier calls of commit() have added. The same deposits give
// the same bits on any number of threads. The memory is bounded. Cells live in world space and survive camera moves.
#pragma once
#include <span>
#include <vector>

#include "base/state_file.h"
#include "cells/cell_answers.h"
#include "cells/cell_collection.h"
#include "cells/cell_deposits.h"

namespace drc {

struct RadianceCellSettings {
    float size = 1;     // edge of the finest cells, world units
    int sizes = 4;      // number of nested sizes, each twice the one before
    int deposits = 16;  // that a cell needs before it answers
    // The relative variance of a mean up to which cells are used that are not of the largest size.
    float variance = 0.1f;
    size_t capacity = 1 << 20;  // greatest number of cells, a power of two
    float lightScale = 1;       // by which radiance is multiplied for display; it sets the unit of the sums
};

class RadianceCells final : public RadianceCache {
  public:
    // Memory for one cell.
    static constexpr size_t bytesPerCell() { return sizeof(CellAnswer) + sizeof(CellSums); }

    explicit RadianceCells(const RadianceCellSettings& settings);
    // Cells that know what a collection does, as far as the capacity allows; where a bucket of the table is full, the
    // cells with the most deposits stay.
    RadianceCells(const CellCollection& collection, size_t capacity);

    bool accepts(const CachePoint& at) const override { return at.reach >= grid_.reachFor(0); }
    void prefetch(const CachePoint& at) const override;
    bool lookUp(const CachePoint& at, CacheAnswer& answer) const override;

    // Adds all deposits and empties the lists; returns how many there were. Their order matters only for which cells
    // are kept when memory is short. Not while others look up.
    size_t commit(std::span<std::vector<CacheDeposit>* const> lists);
    // Halves the sizes of all cells. What is known about the sizes that remain is kept. Not while others look up.
    void refine();
    // Writes all cells as the latest call of commit() left them. load reads them into an object of the settings that
    // this one was made with, which then goes on as this one would; it throws Error if they contradict each other, and
    // only the destructor may follow that. Not while others look up.
    void save(StateWriter& to) const;
    void load(StateReader& from);
    // All cells, for a file. origin: Scene::origin. Not while others look up.
    CellCollection collect(const Vec3& origin) const;
    // The number of commits so far.
    int commits() const { return int(now_ - 1); }

    // With the size of the finest cells as it is now.
    const RadianceCellSettings& settings() const { return settings_; }
    size_t used() const { return totals_.used; }
    // The mean of the answers' relative standard errors, weighted by deposits; 1 if there are none.
    double error() const { return totals_.any ? totals_.error : 1; }
    size_t bytes() const { return table_.size() * bytesPerCell(); }

  private:
    void renewAnswers();

    RadianceCellSettings settings_;
    CellGrid grid_;
    CellStatistics statistics_;
    CellTable table_;
    CellTotals totals_;
    std::vector<PlacedDeposits> placed_;
    uint32_t now_ = 1;       // counts commits
    uint64_t deposits_ = 0;  // so far
    float training_ = 1;     // CacheAnswer::training of what is known
};

}  // namespace drc
