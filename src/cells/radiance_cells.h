// Radiance cells: a hash table over the surfaces of a scene, of the radiance that their separable lobes scatter,
// divided by their view factor, so that textures stay sharp. Paths of final gather end in it. World-space hash tables
// of this kind are described by Binder et al., "Massively Parallel Path Space Filtering" (2018).
//
// Cells are cubes of a few nested sizes: each lies within one cell of the next larger size. Each belongs to one of 26
// directions that a surface can face, so that the two sides of a thin wall are two cells. A cell keeps sums over
// deposits, which are unbiased samples: the cells' own answers are never deposited, so that no error builds up. Sums
// are integers, and look-ups see what earlier calls of commit() have added. The same deposits therefore give the same
// bits on any number of threads. The memory is bounded: cells that have not been used for long give way to new ones.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/huge_array.h"
#include "base/state_file.h"
#include "transport/radiance_cache.h"

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
    static constexpr size_t bytesPerCell() { return sizeof(Answer) + sizeof(Sums); }

    explicit RadianceCells(const RadianceCellSettings& settings);

    bool accepts(const CachePoint& at) const override { return at.reach >= reachFor(0); }
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
    // The number of commits so far.
    int commits() const { return int(now_ - 1); }

    const RadianceCellSettings& settings() const { return settings_; }
    size_t used() const { return used_; }
    size_t bytes() const { return answers_.size() * bytesPerCell(); }

  private:
    // What look-ups read: half a cache line. A cell that knows too little itself has the answer of the smallest one
    // around it that knows enough, so that most look-ups read one cell.
    struct alignas(32) Answer {
        uint64_t key = 0;  // hash of size, place and facing; 0: there is no cell
        float perFactor[3]{};
        int8_t normal[3]{};  // of the surface, in units of 1/127
        bool known = false;
        float plane = 0;       // distance of the surface from the world's origin along the normal, world units
        uint16_t lastUse = 0;  // number of the commit, modulo 2^16
        uint8_t points = 0;    // whose cell it is, see pointsOf
    };
    struct Sums {
        int64_t light[3]{};
        int64_t square = 0;  // of the light's luminance divided by the view factor's
        // As square, but about the means of the cells of the next smaller size, summed up over them.
        int64_t within = 0;
        uint32_t viewFactor[3]{};  // in steps of kViewFactorSteps
        int32_t position[3]{};     // relative to the cell's corner
        int32_t normal[3]{};
        int32_t grid[3]{};         // the cell's place in the grid of its size
        uint32_t countWithin = 0;  // deposits in the cells of the next smaller size
        uint32_t count : 22 = 0;
        uint32_t generation : 5 = 0;  // of the cell's size, see generationOf
        uint32_t facing : 5 = 0;
    };
    // What renewAnswers finds out about a cell before it renews the answers.
    struct Link {
        uint32_t larger : 30 = kNone;  // index of the cell of the next larger size around it
        uint32_t enough : 1 = 0;       // whether it knows enough to answer
        uint32_t divides : 1 = 0;      // and whether the cells within it should answer, where they know enough
    };
    static constexpr uint32_t kNone = (1u << 30) - 1;
    struct Around {
        uint64_t key;
        uint32_t cell;
    };
    struct Source {
        uint32_t source, cell;  // indices
    };
    // Halves all sums when there are so many deposits, before 32 bits overflow.
    static constexpr uint32_t kMostDeposits = (1 << 17) - 1;
    static_assert(sizeof(Answer) == 32 && sizeof(Sums) == 96);
    // Cells in a bucket, two cache lines, any of which may hold a key.
    static constexpr size_t kWays = 4;
    static constexpr int kMostRefined = 24;
    static constexpr size_t kMostSizes = 7;

    // Where a point lies in the grid of one size.
    struct Place {
        uint64_t key;
        int32_t grid[3];
        int facing;
        uint8_t points;
    };
    float sizeOf(int level) const { return settings_.size * float(1 << level); }
    // Numbers sizes, from small to large, so that a cell keeps its number when all sizes are halved.
    int generationOf(int level) const { return kMostRefined + level - refined_; }
    int levelOf(int generation) const { return generation - kMostRefined + refined_; }
    float reachFor(int level) const;
    // The largest size that a point may use.
    int largestLevel(const CachePoint& at) const;
    // Points that may not use the largest cells, because they are seen from nearby, have cells of their own: otherwise
    // the light in corners, and beside lamps, would be mixed into that of open surfaces. 0: all sizes, else the largest
    // one's generation.
    uint8_t pointsOf(int largest) const { return largest == settings_.sizes - 1 ? 0 : uint8_t(generationOf(largest)); }
    static uint64_t keyOf(const int32_t (&grid)[3], int facing, int generation, uint8_t points);
    Place placeOf(const Vec3& p, const Vec3& n, int level, uint8_t points) const;
    Vec3 cornerOf(const int32_t (&grid)[3], int level) const;
    size_t bucketOf(uint64_t key) const { return size_t(key) & (answers_.size() - kWays); }
    const Answer* find(uint64_t key) const;
    void prefetchBucket(uint64_t key) const;
    // The key of the cell of the next larger size around one; 0: there is none.
    uint64_t keyAround(const Sums& sums) const;
    void add(const CacheDeposit& deposit, int level, const Place& place);
    // sums: of the cell whose answer it gets. Returns the relative standard error of the answer.
    double renewAnswer(Answer& answer, const Sums& sums) const;
    const Answer& answerOf(const Sums& sums) const { return answers_[size_t(&sums - sums_.begin())]; }
    const Sums& sumsOf(const Answer& cell) const { return sums_[size_t(&cell - answers_.begin())]; }
    bool knowsEnough(const Sums& sums) const;
    // Whether the means of the cells within this one would be good enough.
    bool divides(const Sums& sums) const;
    double meanOf(const Sums& sums) const { return double(luminance(perFactor(sums))); }
    // The age of a cell, in commits.
    uint16_t age(const Answer& cell) const { return uint16_t(now_ - cell.lastUse); }
    Rgb perFactor(const Sums& sums) const;
    double perSquare() const { return perQuantum_ * perQuantum_ * 0x1p-32; }
    void boundDeposits(std::span<std::vector<CacheDeposit>* const> lists);
    void renewAnswers();
    void grow();

    RadianceCellSettings settings_;
    float shift_;  // of the grids, world units
    double perQuantum_;
    int refined_ = 0;        // how often
    uint32_t now_ = 1;       // counts commits
    uint64_t deposits_ = 0;  // so far
    size_t used_ = 0;
    float training_ = 1;  // CacheAnswer::training of what is known
    double mean_ = 0;     // of all deposits' luminance, divided by the view factor's
    HugeArray<Answer> answers_;
    HugeArray<Sums> sums_;  // by the same indices
};

}  // namespace drc
