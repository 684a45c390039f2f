#include "cache/pass_maps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace drc {
namespace {

const PixelRegion kRegion{0, 0, 64, 48};
const Vec3 kUp(0, 0, 1);

// Places a map at a site on the plane z = height, a unit of the world a pixel, that sees surfaces at distance 10.
void place(MapSite& site, float height = 0) {
    const MapLayout layout(Projection::EqualArea, 4);
    CapturedMap map;
    site.p = map.origin = Vec3(site.film.x, site.film.y, height);
    site.n = kUp;
    map.frame = Frame::fromNormal(kUp);
    map.radiance.assign(3 * 16, 1.f);
    map.normal.assign(3 * 16, 0.f);
    map.distance.assign(16, 10.f);
    site.front = RadianceMap(map, layout);
    site.hasFront = true;
}

PixelSite pixelAt(const Vec2& film, float height = 0) {
    PixelSite pixel;
    pixel.p = Vec3(film.x, film.y, height);
    pixel.n = kUp;
    pixel.film = film;
    pixel.pixelSize = 1;
    return pixel;
}

TEST(PassMaps, GridServesAPlaneEverywhere) {
    PassMaps maps(MapGrid(kRegion, 10, Vec2(0.3f, 0.6f)));
    for (MapSite& site : maps.grid()) place(site);
    std::vector<WeightedSite> around;
    for (float y = 0.5f; y < 48; y += 3)
        for (float x = 0.5f; x < 64; x += 3) {
            const PixelSite pixel = pixelAt(Vec2(x, y));
            EXPECT_GT(maps.coverage(pixel, 0), 0.3f) << x << " " << y;
            maps.findAround(pixel, 0.1f, around);
            ASSERT_FALSE(around.empty());
            float sum = 0;
            for (const WeightedSite& w : around) {
                EXPECT_LE(std::abs(w.site->film.x - x), 10);
                EXPECT_LE(std::abs(w.site->film.y - y), 10);
                sum += w.weight;
            }
            EXPECT_NEAR(sum, maps.coverage(pixel, 0), 1e-5f);
        }
}

TEST(PassMaps, MapsThatFillInServeWhatTheGridDoesNot) {
    PassMaps maps(MapGrid(kRegion, 20, Vec2(0.5f, 0.5f)));
    for (MapSite& site : maps.grid()) place(site);
    const PixelSite high = pixelAt(Vec2(30, 20), 1000);
    std::vector<WeightedSite> around;
    EXPECT_EQ(maps.coverage(high, 0), 0);
    maps.findAround(high, 0.1f, around);
    EXPECT_TRUE(around.empty());

    const std::vector<Vec2> points{Vec2(28, 20), Vec2(50, 20)};
    const std::span<MapSite> level = maps.addLevel(kRegion, 10, points);
    ASSERT_EQ(level.size(), 2u);
    for (MapSite& site : level) place(site, 1000);
    EXPECT_GT(maps.coverage(high, 1), 0.3f);
    maps.findAround(high, 0.1f, around);
    ASSERT_EQ(around.size(), 1u);  // the other is out of reach
    EXPECT_EQ(around[0].site->film.x, 28);
    EXPECT_EQ(around[0].site->radius, 10);
}

TEST(PassMaps, MapsAsideServeOnlyForWantOfBetterOnes) {
    PassMaps maps(MapGrid(kRegion, 20, Vec2(0.5f, 0.5f)));
    for (MapSite& site : maps.grid()) place(site);
    std::vector<WeightedSite> around;
    // Off the maps' plane by as much as they see half the way to.
    const PixelSite aside = pixelAt(Vec2(30, 20), 8);
    const float strict = maps.coverage(aside, 0);
    maps.findAround(aside, strict, around);
    const size_t found = around.size();
    maps.findAround(aside, strict + 1e-3f, around);
    EXPECT_GE(around.size(), found);
    float relaxed = 0;
    for (const WeightedSite& w : around) relaxed += w.weight;
    EXPECT_GT(relaxed, strict);
}

// A wall's maps count for the floor, which is what normals are there to prevent.
TEST(PassMaps, ByDistanceAloneNormalsDoNotMatter) {
    PixelSite wall = pixelAt(Vec2(30, 20), 500);
    wall.n = Vec3(1, 0, 0);
    for (const Interpolation interpolation : {Interpolation::Geometry, Interpolation::Distance}) {
        PassMaps maps(MapGrid(kRegion, 20, Vec2(0.5f, 0.5f)), interpolation);
        for (MapSite& site : maps.grid()) place(site);
        std::vector<WeightedSite> around;
        maps.findAround(wall, 0.1f, around);
        // At a third of the way between rows of the grid, and on one of its columns.
        EXPECT_EQ(around.size(), interpolation == Interpolation::Distance ? 2u : 0u);
        EXPECT_NEAR(maps.coverage(wall, 0), interpolation == Interpolation::Distance ? 1 : 0, 1e-5);
    }
}

TEST(FillPoints, LieAmongTheLackingTheWorstBlocksFirst) {
    // All pixels with x < 20 lack, a fifth of those with x < 40, none of the others.
    const auto lacking = [](int x, int y) { return x < 20 ? true : x < 40 && y % 10 < 2; };
    const auto order = [](int x, int y) { return uint64_t((x * 7919 + y * 104729) % 1009); };
    const auto film = [](int x, int y) { return Vec2(float(x) + 0.5f, float(y) + 0.5f); };
    const PixelRegion region{0, 0, 60, 40};
    const std::vector<Vec2> all = fillPoints(region, 10, 1000, lacking, order, film);
    ASSERT_EQ(all.size(), 16u);  // four columns of four blocks
    for (size_t i = 0; i < all.size(); ++i) {
        EXPECT_TRUE(lacking(int(all[i].x), int(all[i].y)));
        EXPECT_EQ(all[i].x < 20, i < 8) << i;
    }
    const std::vector<Vec2> some = fillPoints(region, 10, 5, lacking, order, film);
    EXPECT_EQ(some, std::vector<Vec2>(all.begin(), all.begin() + 5));
}

TEST(FillPoints, PassesOverBlocksThatHardlyLack) {
    const auto lacking = [](int x, int y) { return x == 5 && y == 5; };
    const auto order = [](int, int) { return uint64_t(1); };
    const auto film = [](int x, int y) { return Vec2(float(x), float(y)); };
    EXPECT_TRUE(fillPoints({0, 0, 40, 40}, 10, 100, lacking, order, film).empty());
    EXPECT_EQ(fillPoints({0, 0, 40, 40}, 3, 100, lacking, order, film).size(), 1u);  // one of nine is enough
}

}  // namespace
}  // namespace drc
