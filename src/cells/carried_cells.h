// Cells that are carried into a frame in which something has moved or a light has changed. It is told by the
// light itself whether this still holds: fresh deposits of a cell are compared with the carried ones, and where they
// disagree beyond their noise, that cell and those around it forget what was carried.
//
// A cell carries at most kMostCarried deposits, and only those of the frame before: a change that was too small to be
// noticed is gone in the second frame.
#pragma once
#include <vector>

#include "cells/cell_collection.h"
#include "cells/cell_statistics.h"

namespace drc {

class CarriedCells {
  public:
    static constexpr uint64_t kMostCarried = 256;

    // cells: those that RadianceCells::carry() returned in the frame before.
    explicit CarriedCells(CellCollection cells) : cells_(std::move(cells)) {}

    const CellCollection& cells() const { return cells_; }
    // The carried sums of a cell; null if there are none.
    const CollectedCell* find(const CellPlace& place) const;

    // Takes what no longer holds out of the table's sums, from cells with CellSums::carried. Returns the number of
    // cells that have forgotten. To be called after deposits were added and before answers are renewed.
    size_t forget(CellTable& table, const CellGrid& grid, const CellStatistics& statistics) const;
    // Takes all carried sums out of the table.
    void forgetAll(CellTable& table) const;

  private:
    CellCollection cells_;
};

}  // namespace drc
