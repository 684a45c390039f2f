#include "cells/cell_grid.h"

#include <algorithm>
#include <cmath>

#include "math/rng.h"

namespace drc {
namespace {

// A point may use cells whose size is at most this share of its reach. After a diffuse reflection, the path must then
// have travelled at least about one and a half cells.
constexpr float kSizePerReach = 1 / 3.f;
// A component of a unit normal counts for the facing if it is larger than this, the sine of 22.5 degrees: the 26
// directions then have about equal parts of the sphere.
constexpr float kFacing = 0.3827f;
// The grids are shifted by this share of the largest cells, because scenes have many surfaces at round coordinates. The
// shift is the same distance at all sizes, so that cells are nested; at each smaller size it is again one or two thirds
// of a cell, beyond whole cells.
constexpr float kGridShift = 1 / 3.f;

}  // namespace

CellGrid::CellGrid(float size, int sizes)
    : size_(size), levels_(std::clamp(sizes, 1, kMostSizes)), shift_(kGridShift * sizeOf(levels_ - 1)) {}

void CellGrid::refine() {
    if (refined_ + 1 >= kMostRefined) return;
    size_ *= 0.5f;
    ++refined_;
}

float CellGrid::reachFor(int level) const { return sizeOf(level) / kSizePerReach; }

int CellGrid::largestLevel(const CachePoint& at) const {
    int level = levels_ - 1;
    while (level > 0 && at.reach < reachFor(level)) --level;
    return level;
}

int CellGrid::facing(const Vec3& n) {
    const auto digit = [](float v) { return v > kFacing ? 2 : v < -kFacing ? 0 : 1; };
    return digit(n.x) + 3 * (digit(n.y) + 3 * digit(n.z));
}

GridCube CellGrid::cubeOf(const Vec3& p, int level) const {
    constexpr float kMost = 1 << 30;
    const float perSize = 1 / sizeOf(level);
    GridCube cube;
    for (int c = 0; c < 3; ++c) cube.at[c] = int32_t(std::clamp(std::floor((p[c] + shift_) * perSize), -kMost, kMost));
    return cube;
}

Vec3 CellGrid::cornerOf(const GridCube& cube, int level) const {
    return Vec3(float(cube.at[0]), float(cube.at[1]), float(cube.at[2])) * sizeOf(level) - Vec3(shift_);
}

uint64_t CellGrid::keyOf(const GridCube& cube, int facing, int generation, uint8_t points) {
    const auto kind = uint64_t((int(points) * 64 + generation) * kFacings + facing);
    const uint64_t key = mixBits(mixBits(uint64_t(cube.at[0]) + uint64_t(cube.at[1]) * 0x9e3779b97f4a7c15ull) +
                                 uint64_t(cube.at[2]) * 0xd1342543de82ef95ull + kind * 0xaf251af3b0f025b5ull);
    return key == 0 ? 1 : key;
}

uint64_t CellGrid::keyAround(const GridCube& cube, int facing, int generation, uint8_t points) const {
    const int larger = generation + 1;
    if (levelOf(larger) >= levels_ || (points != 0 && larger > points)) return 0;
    return keyOf({{cube.at[0] >> 1, cube.at[1] >> 1, cube.at[2] >> 1}}, facing, larger, points);
}

}  // namespace drc
