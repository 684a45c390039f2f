// The sums of a radiance cell over its deposits, and their statistics. The sums are integers: the same deposits give
// the same bits in any order.
#pragma once
#include "cells/cell_table.h"

namespace drc {

class CellStatistics {
  public:
    // When a cell has this many deposits, all its sums are halved, before 32 bits overflow.
    static constexpr uint32_t kMostDeposits = (1 << 17) - 1;

    // lightScale: factor on radiance for display; sets the unit of the sums.
    explicit CellStatistics(float lightScale);

    // Adds a deposit to a cell of this level, whose cube it lies in.
    void add(const CacheDeposit& deposit, const CellGrid& grid, int level, CellSums& sums) const;

    // The mean of the deposits' light, divided by the mean of their view factors.
    Rgb perFactor(const CellSums& sums) const;
    // The luminance of perFactor().
    double mean(const CellSums& sums) const { return double(luminance(perFactor(sums))); }
    // The variance of the deposits' relativeLuminance() about `mean`.
    double variance(const CellSums& sums, double mean) const;
    // The squared deviations of relativeLuminance() from the cell's mean, summed over the deposits, in units of
    // CellSums::square.
    int64_t squaredDeviations(const CellSums& sums) const;
    // Sum of the deposits' squared deviations, each from the mean of its smaller cell within this one: their variance
    // times their number.
    double summedVarianceWithin(const CellSums& sums) const;

    // Units per luminance, in a coarser unit whose sums over all deposits do not overflow.
    double perCoarseUnit() const { return perUnit_ * 0x1p-16; }
    static int64_t unitsOf(double value, double perUnit);

    // The luminance of a deposit's light, divided by that of its view factor.
    static double relativeLuminance(const CacheDeposit& d);

  private:
    double perSquare() const { return perUnit_ * perUnit_ * 0x1p-32; }
    double perUnit_;
};

// Units of the sums of positions, per edge of a cell, and of normals, per unit length.
inline constexpr float kCellPositionUnits = 512, kCellNormalUnits = 127;

}  // namespace drc
