// Where radiance cells lie: nested grids of cubes, one for each size, and 26 directions that a surface can face, so
// that the two sides of a thin wall are two cells. Each cube lies within one of the next larger size.
#pragma once
#include <cstdint>

#include "transport/radiance_cache.h"

namespace drc {

// A cube of the grid of one size: integer coordinates.
struct GridCube {
    int32_t at[3]{};
};

class CellGrid {
  public:
    static constexpr int kMostRefined = 24, kMostSizes = 7;
    static constexpr int kFacings = 27;  // as facing() numbers them, which leaves out the middle one

    // size: edge of the smallest cubes, world units. sizes: their number, each twice the one before.
    CellGrid(float size, int sizes);

    // Levels number the sizes from the smallest on, 0.
    int levels() const { return levels_; }
    float sizeOf(int level) const { return size_ * float(1 << level); }
    // Generations number the sizes so that a cell keeps its number when all sizes are halved.
    int generationOf(int level) const { return kMostRefined + level - refined_; }
    int levelOf(int generation) const { return generation - kMostRefined + refined_; }
    int refined() const { return refined_; }
    // Halves all sizes, at most kMostRefined times.
    void refine();

    // The reach (CachePoint) from which a point may use cells of this level.
    float reachFor(int level) const;
    // The largest size that a point may use.
    int largestLevel(const CachePoint& at) const;
    // Points that may not use the largest cells, because they are seen from nearby, have cells of their own: otherwise
    // the light in corners, and beside lamps, would be mixed into that of open surfaces. 0: all sizes, else the largest
    // one's generation.
    uint8_t pointsOf(int largest) const { return largest == levels_ - 1 ? 0 : uint8_t(generationOf(largest)); }

    static int facing(const Vec3& n);
    GridCube cubeOf(const Vec3& p, int level) const;
    // World space.
    Vec3 cornerOf(const GridCube& cube, int level) const;

    // A hash of all that tells cells apart; never 0.
    static uint64_t keyOf(const GridCube& cube, int facing, int generation, uint8_t points);
    uint64_t keyOf(const CachePoint& at, int level, uint8_t points) const {
        return keyOf(cubeOf(at.p, level), facing(at.n), generationOf(level), points);
    }
    // The key of the cell of the next larger size around one; 0: there is none.
    uint64_t keyAround(const GridCube& cube, int facing, int generation, uint8_t points) const;

  private:
    float size_;
    int levels_;
    float shift_;  // of the grids, world units
    int refined_ = 0;
};

}  // namespace drc
