// Radiance cells: a hash table over the surfaces of a scene, with the radiance that their separable lobes scatter. It
// is divided by the lobes' view factor, so that textures stay sharp. Paths of final gather end in this table.
// World-space hash tables of this kind are described by Binder et al., "Massively Parallel Path Space Filtering"
// (2018).
//
// Deposits are unbiased samples, except that outliers are bounded. The cells' own answers are never deposited, so that
// no error builds up. Look-ups see the deposits of earlier calls of commit(). The same deposits give the same bits on
// any number of threads. The memory is bounded. Cells live in world space and survive camera moves.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "base/state_file.h"
#include "cells/carried_cells.h"
#include "cells/cell_answers.h"
#include "cells/cell_collection.h"
#include "cells/cell_deposits.h"

namespace drc {

struct RadianceCellSettings {
    float size = 1;     // edge of the finest cells, world units
    int sizes = 4;      // number of nested sizes, each twice the one before
    int deposits = 16;  // deposits that a cell needs before it answers
    // Cells smaller than the largest size are used if the relative variance of their mean is at most this.
    float variance = 0.1f;
    size_t capacity = 1 << 20;  // greatest number of cells, a power of two
    float lightScale = 1;       // factor on radiance for display; sets the unit of the sums
};

class RadianceCells final : public RadianceCache {
  public:
    // Memory for one cell.
    static constexpr size_t bytesPerCell() { return sizeof(CellAnswer) + sizeof(CellSums); }

    explicit RadianceCells(const RadianceCellSettings& settings);
    // Cells that know what a collection does, as far as the capacity allows; where a bucket of the table is full, the
    // cells with the most deposits stay.
    RadianceCells(const CellCollection& collection, size_t capacity);
    // Cells that begin with those of the frame before, from carry(), and forget them where fresh deposits disagree
    // (CarriedCells). They answer only after the first commit, which compares them: else the first samples would show
    // the light of the frame before.
    RadianceCells(CarriedCells carried, size_t capacity);

    bool accepts(const CachePoint& at) const override { return at.reach >= grid_.reachFor(0); }
    void prefetch(const CachePoint& at) const override;
    bool lookUp(const CachePoint& at, CacheAnswer& answer) const override;

    // Adds all deposits, empties the lists, and returns the number of deposits. Their order matters only when memory is
    // short, for which cells are kept. Must not run during look-ups.
    size_t commit(std::span<std::vector<CacheDeposit>* const> lists);
    // Halves the sizes of all cells. Cells of the sizes that remain keep their deposits. Must not run during look-ups.
    void refine();
    // Writes all cells as the latest call of commit() left them. load reads them into an object of the same capacity,
    // which then continues as this one would. It throws Error if the values contradict each other; after that, the
    // object may only be destroyed. Neither may run during look-ups.
    void save(StateWriter& to) const;
    void load(StateReader& from);
    // All cells, for a file. origin: Scene::origin. Not while others look up.
    CellCollection collect(const Vec3& origin) const;
    // The cells for the next frame of an animation, in which something else than the camera changes: bounded as
    // CarriedCells says. Not while others look up.
    CellCollection carry(const Vec3& origin) const;
    // Forgets all that was carried. Not while others look up.
    void dropCarried();
    // Whether the carried cells have not been compared yet.
    bool awaitsComparison() const { return carried_ && commits() == 0; }
    // Number of cells that have forgotten what they carried.
    size_t forgotten() const { return forgotten_; }
    // The number of commits so far.
    int commits() const { return int(now_ - 1); }

    // The settings, with the present size of the finest cells.
    const RadianceCellSettings& settings() const { return settings_; }
    // How often the sizes have been halved.
    int refined() const { return grid_.refined(); }
    size_t used() const { return totals_.used; }
    // The mean of the answers' relative standard errors, weighted by deposits; 1 if there are none.
    double error() const { return totals_.any ? totals_.error : 1; }
    size_t bytes() const { return table_.size() * bytesPerCell(); }

  private:
    void renewAnswers();
    void withholdAnswers();
    // Puts a collection into the empty table; returns how many cells found no room.
    size_t fill(const CellCollection& collection);

    RadianceCellSettings settings_;
    CellGrid grid_;
    CellStatistics statistics_;
    CellTable table_;
    CellTotals totals_;
    std::vector<PlacedDeposits> placed_;
    std::optional<CarriedCells> carried_;
    size_t forgotten_ = 0;
    uint32_t now_ = 1;       // number of commits, plus 1
    uint64_t deposits_ = 0;  // number of deposits so far
    float training_ = 1;     // CacheAnswer::training of points with an answer
};

}  // namespace drc
