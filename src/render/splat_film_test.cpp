#include "render/splat_film.h"

#include <gtest/gtest.h>

#include <random>

#include "base/parallel.h"

namespace drc {
namespace {

constexpr PixelRegion kRegion{10, 20, 18, 26};

double total(const SplatFilm& film) {
    double sum = 0;
    for (int y = kRegion.y0; y < kRegion.y1; ++y)
        for (int x = kRegion.x0; x < kRegion.x1; ++x) sum += double(film.value(x, y).y);
    return sum;
}

TEST(SplatFilm, IsBlackBeforeTheFirstPath) {
    const auto filter = makeBoxFilter(Vec2(0.5f, 0.5f));
    EXPECT_TRUE(isBlack(SplatFilm(kRegion, *filter).value(12, 22)));
}

TEST(SplatFilm, CountsPathsThatBroughtNothing) {
    const auto filter = makeBoxFilter(Vec2(0.5f, 0.5f));
    SplatFilm film(kRegion, *filter);
    const SplatFilm::Catch catches[] = {{1, {{Vec2(12.3f, 22.9f), Rgb(3, 2, 1)}}}, {1, {}}};
    film.add(catches);
    // The value is meant for a sample pass, of as many paths as there are pixels.
    const float passes = 2.f / float(kRegion.count());
    EXPECT_NEAR(film.value(12, 22).x, 3 / passes, 1e-3);
    EXPECT_TRUE(isBlack(film.value(13, 22)) && isBlack(film.value(12, 23)));
}

TEST(SplatFilm, FiltersShareASplatAmongPixelsAndLoseNone) {
    for (const FilterPtr& filter : {makeBoxFilter(Vec2(0.5f, 0.5f)), makeBoxFilter(Vec2(1.5f, 1.5f)),
                                    makeTriangleFilter(Vec2(2, 2)), makeMitchellFilter(Vec2(2, 2), 1 / 3.f, 1 / 3.f)}) {
        SplatFilm film(kRegion, *filter);
        // Over all positions in a pixel, a filter's integral.
        constexpr int kSide = 32;
        SplatFilm::Catch caught{kSide * kSide, {}};
        for (int i = 0; i < kSide * kSide; ++i)
            caught.splats.push_back(
                {Vec2(14 + (float(i % kSide) + 0.5f) / kSide, 23 + (float(i / kSide) + 0.5f) / kSide), Rgb(1.f)});
        film.add({&caught, 1});
        EXPECT_NEAR(total(film) / double(kRegion.count()), 1, 2e-3);
    }
}

TEST(SplatFilm, BordersGetOnlyTheirPart) {
    const auto filter = makeBoxFilter(Vec2(1.5f, 1.5f));
    SplatFilm film(kRegion, *filter);
    const SplatFilm::Catch caught{
        1, {{Vec2(10.5f, 22.5f), Rgb(1.f)}, {Vec2(9.5f, 22.5f), Rgb(1.f)}, {Vec2(-1e30f, 22.5f), Rgb(1.f)}}};
    film.add({&caught, 1});
    // 2 of 3 columns of the first, 1 of the second.
    EXPECT_NEAR(total(film) / double(kRegion.count()), 1, 1e-3);
}

std::vector<SplatFilm::Catch> randomCatches(const PixelRegion& region, size_t splats) {
    std::mt19937 rng(7);
    std::uniform_real_distribution<float> u(-0.1f, 1.1f);
    std::vector<SplatFilm::Catch> catches(11);
    for (size_t i = 0; i < splats; ++i)
        catches[i % catches.size()].splats.push_back({Vec2(float(region.x0) + u(rng) * float(region.width()),
                                                           float(region.y0) + u(rng) * float(region.height())),
                                                      Rgb(u(rng), u(rng), u(rng))});
    for (SplatFilm::Catch& c : catches) c.paths = 100;
    return catches;
}

TEST(SplatFilm, WorkGrowsWithTheSplatsAndNotWithTheFilm) {
    const auto filter = makeBoxFilter(Vec2(0.5f, 0.5f));
    constexpr size_t kSplats = 5000;
    for (const int height : {16, 160, 1600, 16000}) {
        const PixelRegion region{0, 3, 8, 3 + height};
        SplatFilm film(region, *filter);
        film.add(randomCatches(region, kSplats));
        // A filter of one row reaches one band. Some splats lie outside.
        EXPECT_LE(film.visits(), kSplats) << height;
        EXPECT_GE(film.visits(), kSplats / 2) << height;
    }
}

TEST(SplatFilm, SumsAreTheSameBitsForAnyNumberOfThreads) {
    constexpr PixelRegion kTall{5, -7, 25, 150};
    const auto catches = randomCatches(kTall, 4000);
    // Narrower than a band of rows, and wider than several.
    for (const float radius : {2.f, 40.f}) {
        const auto filter = makeGaussianFilter(Vec2(2, radius), 0.5f);
        // One splat after the other: what the sums of all of them at once have to be.
        SplatFilm one(kTall, *filter);
        for (const SplatFilm::Catch& c : catches) {
            const SplatFilm::Catch none{c.paths, {}};
            one.add({&none, 1});
            for (const Splat& splat : c.splats) {
                const SplatFilm::Catch single{0, {splat}};
                one.add({&single, 1});
            }
        }
        for (const int threads : {1, 2, 5}) {
            setThreadCount(threads);
            SplatFilm film(kTall, *filter);
            film.add(catches);
            for (int y = kTall.y0; y < kTall.y1; ++y)
                for (int x = kTall.x0; x < kTall.x1; ++x) ASSERT_EQ(film.value(x, y), one.value(x, y)) << x << ' ' << y;
        }
        setThreadCount(0);
    }
}

}  // namespace
}  // namespace drc
