#include "maps/pass_maps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace drc {
namespace {

const PixelRegion kRegion{0, 0, 64, 48};
const Vec3 kUp(0, 0, 1);
constexpr float kMargin = 2;

// Captures a map for a site on the plane z = height, where a pixel is one world unit wide. It sees surfaces at
// distance 10.
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
    PassMaps maps(MapGrid(kRegion, 10, Vec2(0.3f, 0.6f)), kRegion, kMargin);
    for (MapSite& site : maps.addGrid(0)) place(site);
    std::vector<WeightedSite> around;
    for (float y = 0.5f; y < 48; y += 3)
        for (float x = 0.5f; x < 64; x += 3) {
            const PixelSite pixel = pixelAt(Vec2(x, y));
            EXPECT_GT(maps.coverage(0, pixel, 0), 0.3f) << x << " " << y;
            maps.findAround(0, pixel, 0.1f, around);
            ASSERT_FALSE(around.empty());
            float sum = 0;
            for (const WeightedSite& w : around) {
                EXPECT_LE(std::abs(w.site->film.x - x), 10);
                EXPECT_LE(std::abs(w.site->film.y - y), 10);
                sum += w.weight;
            }
            EXPECT_NEAR(sum, maps.coverage(0, pixel, 0), 1e-5f);
        }
}

TEST(PassMaps, MapsThatFillInServeWhatTheGridDoesNot) {
    PassMaps maps(MapGrid(kRegion, 20, Vec2(0.5f, 0.5f)), kRegion, kMargin);
    for (MapSite& site : maps.addGrid(0)) place(site);
    const PixelSite high = pixelAt(Vec2(30, 20), 1000);
    std::vector<WeightedSite> around;
    EXPECT_EQ(maps.coverage(0, high, 0), 0);
    maps.findAround(0, high, 0.1f, around);
    EXPECT_TRUE(around.empty());

    const std::vector<Vec2> points{Vec2(28, 20), Vec2(50, 20)};
    const std::span<MapSite> level = maps.addLevel(0, 10, points);
    ASSERT_EQ(level.size(), 2u);
    for (MapSite& site : level) place(site, 1000);
    EXPECT_GT(maps.coverage(0, high, 1), 0.3f);
    maps.findAround(0, high, 0.1f, around);
    ASSERT_EQ(around.size(), 1u);  // the other is beyond its radius
    EXPECT_EQ(around[0].site->film.x, 28);
    EXPECT_EQ(around[0].site->radius, 10);
}

TEST(PassMaps, MapsAsideServeOnlyForWantOfBetterOnes) {
    PassMaps maps(MapGrid(kRegion, 20, Vec2(0.5f, 0.5f)), kRegion, kMargin);
    for (MapSite& site : maps.addGrid(0)) place(site);
    std::vector<WeightedSite> around;
    // The pixel is off the maps' plane by 8, which leaves them a small relaxed weight.
    const PixelSite aside = pixelAt(Vec2(30, 20), 8);
    const float strict = maps.coverage(0, aside, 0);
    maps.findAround(0, aside, strict, around);
    const size_t found = around.size();
    maps.findAround(0, aside, strict + 1e-3f, around);
    EXPECT_GE(around.size(), found);
    float relaxed = 0;
    for (const WeightedSite& w : around) relaxed += w.weight;
    EXPECT_GT(relaxed, strict);
}

// By distance alone, maps on a wall serve the floor. Preventing this is the purpose of the normals.
TEST(PassMaps, ByDistanceAloneNormalsDoNotMatter) {
    PixelSite wall = pixelAt(Vec2(30, 20), 500);
    wall.n = Vec3(1, 0, 0);
    for (const Interpolation interpolation : {Interpolation::Geometry, Interpolation::Distance}) {
        PassMaps maps(MapGrid(kRegion, 20, Vec2(0.5f, 0.5f)), kRegion, kMargin, interpolation);
        for (MapSite& site : maps.addGrid(0)) place(site);
        std::vector<WeightedSite> around;
        maps.findAround(0, wall, 0.1f, around);
        // A third of the way between two rows of the grid, exactly on a column.
        EXPECT_EQ(around.size(), interpolation == Interpolation::Distance ? 2u : 0u);
        EXPECT_NEAR(maps.coverage(0, wall, 0), interpolation == Interpolation::Distance ? 1 : 0, 1e-5);
    }
}

// The maps that serve a pixel and their weights, as comparable numbers.
std::vector<std::array<float, 4>> served(const PassMaps& maps, int band, const PixelSite& pixel) {
    std::vector<WeightedSite> around;
    maps.findAround(band, pixel, 0.01f, around);
    std::vector<std::array<float, 4>> result;
    for (const WeightedSite& w : around) result.push_back({w.site->radius, w.site->film.x, w.site->film.y, w.weight});
    std::sort(result.begin(), result.end());
    return result;
}

// A film position of a sample of the pixel, anywhere within the filter's support.
Vec2 sampleOf(int x, int y) {
    const uint64_t random = hashCombine(uint64_t(x), uint64_t(y));
    const auto offset = [](uint64_t r) { return kMargin * (float(r % 5) / 2 - 1); };
    return Vec2(float(x) + 0.5f + offset(random), float(y) + 0.5f + offset(random >> 32));
}

TEST(PassMaps, BandsThatComeAndGoServeAsAllAtOnce) {
    const PixelRegion region{3, 5, 40, 400};
    const MapGrid grid(region, 6, Vec2(0.3f, 0.6f));
    constexpr float kReach = 3;
    PassMaps bands(grid, region, kMargin, Interpolation::Geometry, 20);
    PassMaps whole(grid, region, kMargin, Interpolation::Geometry, grid.count());
    ASSERT_EQ(whole.bandCount(), 1);
    ASSERT_GT(bands.bandCount(), 10);

    const auto pointsOf = [](const PixelRegion& pixels) {
        std::vector<Vec2> result;
        for (int y = pixels.y0; y < pixels.y1; ++y)
            for (int x = pixels.x0 + y % 3; x < pixels.x1; x += 3) result.push_back(sampleOf(x, y));
        return result;
    };
    for (MapSite& site : whole.addGrid(0)) place(site);
    for (MapSite& site : whole.addLevel(0, kReach, pointsOf(region))) place(site);

    int row = region.y0;
    size_t fromBelow = 0;
    for (int band = 0; band < bands.bandCount() + 1; ++band) {
        if (band < bands.bandCount()) {
            for (MapSite& site : bands.addGrid(band)) place(site);
            for (MapSite& site : bands.addLevel(band, kReach, pointsOf(bands.pixels(band)))) place(site);
        }
        if (band == 0) continue;
        const PixelRegion pixels = bands.pixels(band - 1);
        EXPECT_EQ(pixels.y0, row);
        row = pixels.y1;
        for (int y = pixels.y0; y < pixels.y1; ++y)
            for (int x = pixels.x0; x < pixels.x1; ++x) {
                const PixelSite pixel = pixelAt(sampleOf(x, y));
                const auto found = served(bands, band - 1, pixel);
                ASSERT_EQ(found, served(whole, 0, pixel)) << x << " " << y;
                for (const auto& site : found) fromBelow += site[2] > float(pixels.y1) + kMargin;
            }
        if (band > 1) bands.release(band - 2);
    }
    EXPECT_EQ(row, region.y1);
    EXPECT_GT(fromBelow, 0u);
}

TEST(FillPoints, LieAmongTheLackingTheWorstBlocksFirst) {
    // All pixels with x < 20 lack maps, a fifth of those with x < 40, and none of the others.
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
    EXPECT_EQ(fillPoints({0, 0, 40, 40}, 3, 100, lacking, order, film).size(), 1u);  // one pixel of nine is enough
}

}  // namespace
}  // namespace drc
