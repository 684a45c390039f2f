#include "render/film_variance.h"

#include <gtest/gtest.h>

#include "math/rng.h"

namespace drc {
namespace {

constexpr PixelRegion kRegion{3, 5, 5, 6};

TEST(FilmVariance, IsThatOfTheMean) {
    FilmVariance film(kRegion);
    for (float v : {1.f, 2.f, 3.f, 6.f}) film.add(4, 5, Rgb(v, 2 * v, 100));
    // Squares of the differences from 3 sum to 14; 14 / 3 is the samples' variance, a quarter of it the mean's.
    EXPECT_FLOAT_EQ(film.ofMean(4, 5).x, 14.f / 12);
    EXPECT_FLOAT_EQ(film.ofMean(4, 5).y, 4 * 14.f / 12);
    EXPECT_EQ(film.ofMean(4, 5).z, 0);
    EXPECT_EQ(film.count(4, 5), 4);
    EXPECT_EQ(film.count(3, 5), 0);
}

TEST(FilmVariance, OneSampleTellsNothing) {
    FilmVariance film(kRegion);
    film.add(3, 5, Rgb(7));
    EXPECT_EQ(film.ofMean(3, 5), Rgb(0.f));
}

// A mean of a thousand and noise of one: sums of squares in single precision would have lost it.
TEST(FilmVariance, SurvivesABrightMean) {
    FilmVariance film(kRegion);
    Pcg32 rng(1);
    constexpr int kCount = 10000;
    for (int i = 0; i < kCount; ++i) film.add(3, 5, Rgb(1000 + rng.nextFloat()));
    EXPECT_NEAR(film.ofMean(3, 5).x * kCount, 1.0 / 12, 0.003);
}

}  // namespace
}  // namespace drc
