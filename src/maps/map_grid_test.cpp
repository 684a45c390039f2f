#include "maps/map_grid.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

// The paper's schedule at 1280x720: one to six passes do 2, 4, 6, 10, 16 and 22 tasks, and task 256 falls into pass 18.
TEST(MapGrid, TasksAreThePapers) {
    const int expected[][2] = {{1, 1},  {2, 1},  {3, 2},   {6, 3},    {10, 4},
                               {16, 5}, {17, 6}, {54, 10}, {126, 14}, {256, 18}};
    for (const auto& [tasks, passes] : expected) EXPECT_EQ(passesForTasks(tasks, 1280, 720), passes) << tasks;
    EXPECT_EQ(passesForTasks(0, 1280, 720), 0);
}

TEST(MapGrid, SpacingShrinksByAConstantFactorDownToOnePixel) {
    EXPECT_FLOAT_EQ(passSpacing(0, 720), 100);
    EXPECT_FLOAT_EQ(passSpacing(0, 360), 50);
    EXPECT_NEAR(passSpacing(4, 720) / passSpacing(3, 720), 0.891859f, 1e-5f);
    EXPECT_EQ(passSpacing(1000, 720), 1);
}

TEST(MapGrid, EveryPositionLiesInItsCell) {
    const PixelRegion region{30, 10, 160, 97};
    for (const float spacing : {3.3f, 17.f, 200.f})
        for (const Vec2& offset : {Vec2(0, 0), Vec2(0.5f, 0.99f)}) {
            const MapGrid grid(region, spacing, offset);
            for (float y = 10; y < 97; y += 0.7f)
                for (float x = 30; x < 160; x += 0.7f) {
                    const int corner = grid.cell(Vec2(x, y));
                    ASSERT_LT(corner + grid.columns() + 1, grid.count());
                    const Vec2 a = grid.point(corner), b = grid.point(corner + grid.columns() + 1);
                    EXPECT_LE(a.x, x + 1e-3f);
                    EXPECT_LE(a.y, y + 1e-3f);
                    EXPECT_GE(b.x, x - 1e-3f);
                    EXPECT_GE(b.y, y - 1e-3f);
                }
        }
}

TEST(FilmBuckets, FindsAllWithinReach) {
    const PixelRegion region{5, 5, 105, 85};
    FilmBuckets buckets(region, 9);
    std::vector<Vec2> points;
    for (int i = 0; i < 400; ++i) {
        points.emplace_back(5 + float((i * 37) % 1000) * 0.1f, 5 + float((i * 53) % 800) * 0.1f);
        buckets.add(points.back(), i);
    }
    for (const Vec2& at : {Vec2(5, 5), Vec2(50, 40), Vec2(104.9f, 84.9f)}) {
        std::vector<bool> found(points.size());
        buckets.forEachNear(at, [&](int id) {
            EXPECT_FALSE(found[size_t(id)]) << "reported twice";
            found[size_t(id)] = true;
        });
        for (size_t i = 0; i < points.size(); ++i) EXPECT_TRUE(found[i] || (points[i] - at).length() >= 9);
    }
}

}  // namespace
}  // namespace drc
