#include "film/splat_filter.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

constexpr PixelRegion kRegion{10, 20, 18, 26};

FilmLayer layer() { return {kRegion, {.name = "splats", .weighted = false}}; }

double total(const FilmLayer& layer) {
    double sum = 0;
    for (int y = kRegion.y0; y < kRegion.y1; ++y)
        for (int x = kRegion.x0; x < kRegion.x1; ++x) sum += layer.sum(x, y, 1);
    return sum;
}

TEST(SplatFilter, ABoxOfAPixelIsOnePixel) {
    const auto filter = makeBoxFilter(Vec2(0.5f, 0.5f));
    FilmLayer l = layer();
    SplatFilter(*filter).add({Vec2(12.3f, 22.9f), Rgb(3, 2, 1)}, l);
    EXPECT_NEAR(l.sum(12, 22, 0), 3, 1e-4);
    EXPECT_EQ(l.sum(13, 22, 0), 0);
    EXPECT_EQ(l.sum(12, 23, 0), 0);
}

TEST(SplatFilter, FiltersShareASplatAmongPixelsAndLoseNone) {
    for (const FilterPtr& filter : {makeBoxFilter(Vec2(0.5f, 0.5f)), makeBoxFilter(Vec2(1.5f, 1.5f)),
                                    makeTriangleFilter(Vec2(2, 2)), makeMitchellFilter(Vec2(2, 2), 1 / 3.f, 1 / 3.f)}) {
        FilmLayer l = layer();
        const SplatFilter splats(*filter);
        // Over all positions in a pixel, the sum is the filter's integral.
        constexpr int kSide = 32;
        for (int i = 0; i < kSide * kSide; ++i)
            splats.add({Vec2(14 + (float(i % kSide) + 0.5f) / kSide, 23 + (float(i / kSide) + 0.5f) / kSide), Rgb(1.f)},
                       l);
        EXPECT_NEAR(total(l) / (kSide * kSide), 1, 2e-3);
    }
}

TEST(SplatFilter, BordersGetOnlyTheirPart) {
    const auto filter = makeBoxFilter(Vec2(1.5f, 1.5f));
    FilmLayer l = layer();
    const SplatFilter splats(*filter);
    for (const Vec2& at : {Vec2(10.5f, 22.5f), Vec2(9.5f, 22.5f), Vec2(-1e30f, 22.5f)}) splats.add({at, Rgb(1.f)}, l);
    // Two of the three columns of the first splat, one of the second.
    EXPECT_NEAR(total(l), 1, 1e-3);
}

}  // namespace
}  // namespace drc
