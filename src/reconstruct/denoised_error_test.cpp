#include "reconstruct/denoised_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "film/film_testing.h"
#include "image/relative_norm.h"

namespace drc {
namespace {

constexpr int kWidth = 192, kHeight = 128;

// A wall with a gradient, an edge, and a lamp.
Rgb truthAt(int x, int y) {
    if (x > 140 && y > 90) return Rgb(2.f, 1.8f, 1.5f);
    const float v = 0.1f + float(x) / kWidth;
    return x > 60 ? Rgb(v, 0.8f * v, 0.5f * v) : Rgb(0.05f, 0.3f * v, v);
}

// Samples with exponentially distributed values, whose standard deviation is their mean: about the noise of paths.
LayeredPicture pictureOf(int samples, uint64_t seed, bool antithetic = false) {
    const auto film = std::make_shared<Film>(test::filmSettings({0, 0, kWidth, kHeight}),
                                             std::vector<FilmLayerSpec>{{.name = "beauty", .groups = 2}});
    std::mt19937 random{uint32_t(seed)};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            double u = 0;
            for (int i = 0; i < samples; ++i) {
                u = antithetic && i % 2 == 1 ? 1 - u : (random() + 0.5) * 0x1p-32;
                film->layer(0).add(x, y, i % 2, truthAt(x, y) * float(-std::log(u)), 1);
            }
        }
    LayeredPicture picture;
    picture.film = film;
    picture.layers.push_back(pictureLayer(*film, "beauty", "", 1));
    picture.compose();
    return picture;
}

// Averages (2 radius + 1)^2 pixels: its bias grows with the radius, and what is left of the noise falls.
std::function<void(LayeredPicture&)> blur(int radius) {
    return [radius](LayeredPicture& picture) {
        const Image before = picture.beauty;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                Rgb sum(0.f);
                float count = 0;
                for (int j = std::max(0, y - radius); j <= std::min(kHeight - 1, y + radius); ++j)
                    for (int i = std::max(0, x - radius); i <= std::min(kWidth - 1, x + radius); ++i, ++count)
                        sum += before.rgb(i, j);
                picture.beauty.setRgb(x, y, sum / count);
            }
    };
}

double trueError(LayeredPicture picture, const std::function<void(LayeredPicture&)>& filter) {
    filter(picture);
    Image truth(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) truth.setRgb(x, y, truthAt(x, y));
    const Image norm = relativeNorm(truth, truth);
    double sum = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            for (int c = 0; c < 3; ++c) {
                const double e = picture.beauty.rgb(x, y)[c] - truth.rgb(x, y)[c], d = norm.rgb(x, y)[c];
                sum += e * e / (d * d + 0.01);
            }
    return std::sqrt(sum / (3 * kWidth * kHeight));
}

// What the denoiser leaves of the noise and what it smears are both in the estimate, whichever is more.
TEST(DenoisedError, IsNearTheTrueError) {
    for (const int radius : {0, 1, 2, 4})
        for (const int samples : {8, 64}) {
            const LayeredPicture picture = pictureOf(samples, uint64_t(radius + 1));
            const double error = estimateDenoisedError(picture, blur(radius)).whole;
            const double truth = trueError(picture, blur(radius));
            EXPECT_GT(error, 0.85 * truth) << radius << " " << samples;
            EXPECT_LT(error, 1.15 * truth) << radius << " " << samples;
        }
}

// What is left of the noise of halves is more than what is left of the noise of the whole.
TEST(DenoisedError, IsThatOfAllSamples) {
    const auto nothing = [](LayeredPicture&) {};
    const double error = estimateDenoisedError(pictureOf(16, 1), nothing).whole;
    EXPECT_NEAR(error, trueError(pictureOf(16, 2), nothing), 0.05 * error);
    EXPECT_LT(error, 0.8 * trueError(pictureOf(8, 2), nothing));
}

// The reason for RenderParams::independentHalves: with halves of which one errs where the other does not, the estimate
// is far too small.
TEST(DenoisedError, NeedsIndependentHalves) {
    // Most of the error is what the blur smears: half of it goes unnoticed.
    const LayeredPicture antithetic = pictureOf(4, 1, true), independent = pictureOf(4, 1);
    EXPECT_LT(estimateDenoisedError(antithetic, blur(4)).whole, 0.8 * trueError(antithetic, blur(4)));
    EXPECT_NEAR(estimateDenoisedError(independent, blur(4)).whole, trueError(independent, blur(4)), 0.1);
}

TEST(DenoisedError, IsWhereTheDenoiserFails) {
    // Leaves everything clean, but invents a square.
    const auto filter = [](LayeredPicture& picture) {
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const bool inside = x >= 16 && x < 48 && y >= 40 && y < 72;
                picture.beauty.setRgb(x, y, truthAt(x, y) * (inside ? 1.5f : 1));
            }
    };
    const DenoisedError error = estimateDenoisedError(pictureOf(64, 3), filter);
    // Relative to what the denoiser makes of it, half as bright again as the truth.
    EXPECT_NEAR(error.local.at(32, 56, 0), 0.25f, 0.03f);
    EXPECT_LT(error.local.at(100, 56, 0), 0.05f);
    EXPECT_LT(error.local.at(32, 110, 0), 0.05f);
}

TEST(DenoisedError, IsUnknownWithoutBothHalves) {
    EXPECT_TRUE(std::isnan(estimateDenoisedError(pictureOf(1, 1), blur(1)).whole));
}

}  // namespace
}  // namespace drc
