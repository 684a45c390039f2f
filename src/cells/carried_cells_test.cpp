#include "cells/carried_cells.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/folder_testing.h"
#include "base/parallel.h"
#include "cells/radiance_cells.h"
#include "math/rng.h"

namespace drc {
namespace {

constexpr float kSize = 0.05f, kWidth = 2;

RadianceCellSettings settings() { return {.size = kSize}; }

// Deposits all over the floor [0, kWidth]^2, with the long-tailed noise of light that is found by chance: most see
// nothing, and their mean is light(p).
template <class F>
void lightFloor(RadianceCells& cells, int perCell, uint64_t seed, const F& light) {
    Pcg32 random(seed);
    std::vector<CacheDeposit> deposits;
    const int n = int(kWidth / kSize * std::sqrt(float(perCell)));
    for (int i = 0; i < n * n; ++i) {
        const Vec2 u = random.nextVec2();
        const Vec3 p((float(i % n) + u.x) / float(n) * kWidth, (float(i / n) + u.y) / float(n) * kWidth, 0);
        const bool found = random.nextFloat() < 0.2f;
        deposits.push_back({{p, Vec3(0, 0, 1), 1000}, found ? Rgb(light(p) * 5) : Rgb(0.f), cacheableFactor(Rgb(1.f))});
    }
    std::vector<CacheDeposit>* const list[] = {&deposits};
    cells.commit(list);
}

// The mean answer, red, over the part of the floor where x is in [from, to].
double meanAnswer(const RadianceCells& cells, float from, float to) {
    double sum = 0;
    int count = 0;
    for (float x = from; x < to; x += kSize / 3)
        for (float y = 0.01f; y < kWidth; y += kSize / 3) {
            CacheAnswer answer;
            if (!cells.lookUp({Vec3(x, y, 0), Vec3(0, 0, 1), 1000}, answer)) continue;
            sum += double(answer.perFactor.x);
            ++count;
        }
    EXPECT_GT(count, 100);
    return sum / count;
}

float dim(const Vec3&) { return 1; }

RadianceCells carried(int perCell = 64) {
    RadianceCells first(settings());
    lightFloor(first, perCell, 1, dim);
    return RadianceCells(CarriedCells(first.carry(Vec3(0.f))), settings().capacity);
}

TEST(CarriedCells, AreTheCellsOfTheFrameBefore) {
    RadianceCells cells = carried();
    CacheAnswer answer;
    EXPECT_FALSE(cells.lookUp({Vec3(1, 1, 0), Vec3(0, 0, 1), 1000}, answer));  // not compared yet
    lightFloor(cells, 1, 4, dim);
    EXPECT_NEAR(meanAnswer(cells, 0, kWidth), 1, 0.03);
}

TEST(CarriedCells, CarryTheFrameBeforeAndNothingOlder) {
    RadianceCells cells(settings());
    for (int frame = 0; frame < 4; ++frame) {
        lightFloor(cells, 24, uint64_t(frame), dim);
        const CellCollection next = cells.carry(Vec3(0.f));
        ASSERT_FALSE(next.cells.empty());
        double finest = 0, count = 0;
        for (const CollectedCell& cell : next.cells) {
            EXPECT_LE(cell.count, CarriedCells::kMostCarried);
            if (cell.place.generation != CellGrid::kMostRefined) continue;
            finest += double(cell.count);
            ++count;
        }
        EXPECT_LE(finest / count, 24 * 1.02) << frame;
        cells = RadianceCells(CarriedCells(next), settings().capacity);
    }
}

TEST(CarriedCells, WhereNothingChangesNearlyNothingIsForgotten) {
    RadianceCells cells = carried();
    for (int commit = 0; commit < 12; ++commit) lightFloor(cells, 16, uint64_t(100 + commit), dim);
    EXPECT_LT(double(cells.forgotten()), 0.02 * double(cells.used()));
    EXPECT_NEAR(meanAnswer(cells, 0, kWidth), 1, 0.03);
}

// A lamp is switched on, off, or over half of the floor: fresh light alone remains.
TEST(CarriedCells, WhereLightChangesItIsForgotten) {
    for (const float now : {3.f, 0.f}) {
        RadianceCells cells = carried();
        lightFloor(cells, 32, 7, [&](const Vec3& p) { return p.x < kWidth / 2 ? now : 1; });
        const double share = double(cells.forgotten()) / double(cells.used());
        EXPECT_GT(share, 0.4) << now;
        EXPECT_LT(share, 0.85) << now;
        EXPECT_NEAR(meanAnswer(cells, 0.01f, kWidth / 2 - 0.1f), now, 0.05 * std::max(1.f, now)) << now;
        EXPECT_NEAR(meanAnswer(cells, kWidth / 2 + 0.1f, kWidth), 1, 0.05) << now;
    }
}

TEST(CarriedCells, ChangesOfTintAreNoticed) {
    RadianceCells cells = carried();
    Pcg32 random(3);
    std::vector<CacheDeposit> deposits;
    for (int i = 0; i < 60000; ++i) {
        const Vec2 u = random.nextVec2() * kWidth;
        // As bright as before, but without blue.
        const Rgb light = random.nextFloat() < 0.2f ? Rgb(5 * 1.0722f, 5 * 1.0722f, 0) : Rgb(0.f);
        deposits.push_back({{Vec3(u.x, u.y, 0), Vec3(0, 0, 1), 1000}, light, cacheableFactor(Rgb(1.f))});
    }
    std::vector<CacheDeposit>* const list[] = {&deposits};
    cells.commit(list);
    EXPECT_GT(double(cells.forgotten()), 0.9 * double(cells.used()));
}

// Changes too small to be noticed are gone in the second frame: its cells are those of two frames of the new light.
TEST(CarriedCells, SmallChangesAreGoneInTheSecondFrame) {
    const auto light = [](const Vec3&) { return 1.1f; };
    RadianceCells cells = carried(16);
    lightFloor(cells, 16, 50, light);
    EXPECT_LT(meanAnswer(cells, 0, kWidth), 1.09);
    cells = RadianceCells(CarriedCells(cells.carry(Vec3(0.f))), settings().capacity);
    lightFloor(cells, 16, 51, light);
    RadianceCells both(settings());
    lightFloor(both, 16, 50, light);
    lightFloor(both, 16, 51, light);
    EXPECT_NEAR(meanAnswer(cells, 0, kWidth), meanAnswer(both, 0, kWidth), 1e-3);
}

TEST(CarriedCells, CanBeDropped) {
    RadianceCells cells = carried(16);
    lightFloor(cells, 16, 50, dim);
    cells.dropCarried();
    RadianceCells alone(settings());
    lightFloor(alone, 16, 50, dim);
    EXPECT_NEAR(meanAnswer(cells, 0, kWidth), meanAnswer(alone, 0, kWidth), 1e-3);
}

TEST(CarriedCells, TheSameBitsOnAnyNumberOfThreadsAndAfterLoading) {
    const TemporaryFolder folder;
    const auto bytes = [&](int threads, bool reload) {
        const int before = threadCount();
        setThreadCount(threads);
        RadianceCells cells = carried();
        const auto half = [](const Vec3& p) { return p.x < 1 ? 4.f : 1.f; };
        lightFloor(cells, 8, 5, half);
        if (reload) {
            StateWriter file(folder.path("state"), "cells");
            cells.save(file);
            file.commit();
            // Into cells of any size.
            cells = RadianceCells(RadianceCellSettings{.size = 3});
            StateReader reader(folder.path("state"), "cells", "cells");
            cells.load(reader);
            reader.finish();
        }
        lightFloor(cells, 24, 6, half);
        setThreadCount(before);
        StateWriter file(folder.path("end"), "cells");
        cells.save(file);
        file.commit();
        return readFile(folder.path("end"));
    };
    const std::string one = bytes(1, false);
    EXPECT_EQ(one, bytes(3, false));
    EXPECT_EQ(one, bytes(3, true));
}

}  // namespace
}  // namespace drc
