#include "cells/cell_statistics.h"

#include <algorithm>
#include <cmath>

namespace drc {

CellStatistics::CellStatistics(float lightScale) : perUnit_(1 / 0x1p-24 * double(lightScale > 0 ? lightScale : 1)) {}

int64_t CellStatistics::unitsOf(double value, double perUnit) {
    constexpr double kMost = 0x1p42;
    return std::llrint(std::clamp(value * perUnit, -kMost, kMost));
}

double CellStatistics::relativeLuminance(const CacheDeposit& d) {
    return double(luminance(d.light)) / std::max(0.01, double(luminance(d.viewFactor)));
}

void CellStatistics::add(const CacheDeposit& d, const CellGrid& grid, int level, CellSums& sums) const {
    const float perSize = 1 / grid.sizeOf(level);
    const Vec3 corner = grid.cornerOf(sums.cube, level);
    for (int c = 0; c < 3; ++c) {
        sums.light[c] += unitsOf(double(d.light[c]), perUnit_);
        sums.viewFactor[c] += uint32_t(std::lrint(d.viewFactor[c] * kViewFactorSteps));
        sums.position[c] += int32_t(std::lrint((d.at.p[c] - corner[c]) * perSize * kCellPositionUnits));
        sums.normal[c] += int32_t(std::lrint(d.at.n[c] * kCellNormalUnits));
    }
    const double y = relativeLuminance(d);
    sums.square += unitsOf(y * y, perSquare());
    if (++sums.count < kMostDeposits) return;
    for (int c = 0; c < 3; ++c) {
        sums.light[c] /= 2;
        sums.viewFactor[c] /= 2;
        sums.position[c] /= 2;
        sums.normal[c] /= 2;
    }
    sums.square /= 2;
    sums.count = sums.count / 2;
}

Rgb CellStatistics::perFactor(const CellSums& sums) const {
    Rgb result(0.f);
    for (int c = 0; c < 3; ++c)
        if (sums.viewFactor[c] > 0)
            result[c] =
                float(double(sums.light[c]) / perUnit_ / (double(sums.viewFactor[c]) / double(kViewFactorSteps)));
    return result;
}

double CellStatistics::variance(const CellSums& sums, double mean) const {
    return std::max(0.0, double(sums.square) / (perSquare() * double(sums.count)) - mean * mean);
}

int64_t CellStatistics::squaredDeviations(const CellSums& sums) const {
    const double m = mean(sums);
    return int64_t(std::max(0.0, double(sums.square) - m * m * double(sums.count) * perSquare()));
}

double CellStatistics::summedVarianceWithin(const CellSums& sums) const { return double(sums.within) / perSquare(); }

}  // namespace drc
