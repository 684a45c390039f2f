// The geometry of radiance cells: nested grids of cubes, one for each size, and 26 directions that a surface can face,
// so that the two sides of a thin wall lie in different cells. Each cube lies within one of the next larger size.
#pragma once
#include <cstdint>

#include "transport/radiance_cache.h"

namespace drc {

// Integer coordinates of a cube in the grid of its size.
struct GridCube {
    int32_t at[3]{};
};

class CellGrid {
  public:
    static constexpr int kMostRefined = 24, kMostSizes = 7;
    static constexpr int kFacings = 27;  // numbers of facing(); the middle one, no direction, is not used

    // size: edge of the smallest cubes, world units. sizes: number of sizes of cubes, each twice the one before.
    CellGrid(float size, int sizes);

    // A level is the number of a size, from 0 for the smallest on.
    int levels() const { return levels_; }
    float sizeOf(int level) const { return size_ * float(1 << level); }
    // A generation also stands for a size, but a cell keeps its generation when refine() halves all sizes.
    int generationOf(int level) const { return kMostRefined + level - refined_; }
    int levelOf(int generation) const { return generation - kMostRefined + refined_; }
    int refined() const { return refined_; }
    // Halves all sizes. Does nothing after kMostRefined - 1 calls.
    void refine();

    // The least CachePoint::reach of points that may use cells of this level, world units.
    float reachFor(int level) const;
    // The largest level that a point may use; 0 even if its reach is too short for that.
    int largestLevel(const CachePoint& at) const;
    // The class of a point by the largest level it may use: 0 for the largest level of all, else the level's
    // generation. Each class has cells of its own: otherwise the light of points that are seen from nearby, in corners
    // and beside lamps, would be mixed into that of open surfaces.
    uint8_t pointsOf(int largest) const { return largest == levels_ - 1 ? 0 : uint8_t(generationOf(largest)); }

    static int facing(const Vec3& n);
    GridCube cubeOf(const Vec3& p, int level) const;
    // The cube's corner of lowest coordinates, in world space.
    Vec3 cornerOf(const GridCube& cube, int level) const;

    // A hash of all properties that distinguish cells; never 0. points: see pointsOf().
    static uint64_t keyOf(const GridCube& cube, int facing, int generation, uint8_t points);
    uint64_t keyOf(const CachePoint& at, int level, uint8_t points) const {
        return keyOf(cubeOf(at.p, level), facing(at.n), generationOf(level), points);
    }
    // The key of the next larger cell that contains the given one; 0 if points of this class have no larger cells.
    uint64_t keyAround(const GridCube& cube, int facing, int generation, uint8_t points) const;

  private:
    float size_;
    int levels_;
    float shift_;  // of the grids, world units
    int refined_ = 0;
};

}  // namespace drc
