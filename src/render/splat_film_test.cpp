#include "render/splat_film.h"

#include <gtest/gtest.h>

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
    // Half a sweep's paths are twice as few as the value is meant for.
    const float sweeps = 2.f / float(kRegion.count());
    EXPECT_NEAR(film.value(12, 22).x, 3 / sweeps, 1e-3);
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

}  // namespace
}  // namespace drc
