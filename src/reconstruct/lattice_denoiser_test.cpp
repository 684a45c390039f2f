#include "reconstruct/lattice_denoiser.h"

#include <gtest/gtest.h>

#include <cmath>

#include "film/film_testing.h"
#include "film/sample_pass.h"
#include "math/rng.h"

namespace drc {
namespace {

constexpr int kWidth = 61, kHeight = 47;

// A film that has had so many passes; the last one has reached the rows above this one alone.
Film filmAfter(int passes, int rows) {
    RenderSettings settings;
    settings.film.width = kWidth;
    settings.film.height = kHeight;
    settings.pixelBounds = PixelRegion{0, 0, kWidth, kHeight};
    Film film(settings, {{.name = "beauty"}});
    for (int y = 0; y < kHeight; ++y) {
        const int done = y < rows ? passes : passes - 1;
        for (int p = 0; p < done; ++p)
            SamplePass{p}.forEachColumn(y, kWidth, [&](int x) {
                Pcg32 random(uint64_t(y * kWidth + x), uint64_t(p));
                const float value = 0.5f + 0.02f * float(x) + (random.nextFloat() - 0.5f);
                film.layer(0).add(x, y, 0, Rgb(value), 1);
            });
        film.setRowPasses(y, done);
    }
    return film;
}

// Means over neighbourhoods of 5 x 5 pixels: like a denoiser, they remove noise that is narrower than that.
void blur(Image& color, const Image& albedo, const Image& normal) {
    EXPECT_EQ(sizeString(color), sizeString(albedo));
    EXPECT_EQ(sizeString(color), sizeString(normal));
    const Image before = color;
    for (int y = 0; y < color.height(); ++y)
        for (int x = 0; x < color.width(); ++x) {
            Rgb sum(0.f);
            int count = 0;
            for (int v = std::max(0, y - 2); v <= std::min(color.height() - 1, y + 2); ++v)
                for (int u = std::max(0, x - 2); u <= std::min(color.width() - 1, x + 2); ++u, ++count)
                    sum += before.rgb(u, v);
            color.setRgb(x, y, sum * (1.f / float(count)));
        }
}

// The root mean square of the differences from the true picture, without its border.
double errorOf(const Image& image, int fromRow, int toRow) {
    double sum = 0;
    int count = 0;
    for (int y = std::max(fromRow, 4); y < std::min(toRow, kHeight - 4); ++y)
        for (int x = 8; x < kWidth - 8; ++x, ++count) sum += std::pow(double(image.at(x, y, 0)) - (0.5 + 0.02 * x), 2);
    return std::sqrt(sum / count);
}

Image pictureOf(const Film& film) {
    Image image = film.layer(0).image();
    fillUnsampled({&image}, film.layer(0));
    return image;
}

// In rows that the latest pass has not reached there is as little noise as in the others.
TEST(LatticeDenoiser, LeavesNoBlocksOfNoise) {
    for (const int passes : {1, 2, 3}) {
        for (const int rows : {0, kHeight / 2, kHeight}) {
            if (passes == 1 && rows < kHeight) continue;
            const Film film = filmAfter(passes, rows);
            const Image noisy = pictureOf(film), features(kWidth, kHeight);
            Image denoised = noisy, asOne = noisy;
            denoiseByLattices(denoised, features, features, film, blur);
            blur(asOne, features, features);
            const bool complete = passes == 3 && rows == kHeight;
            if (complete) {
                EXPECT_EQ(denoised.data(), asOne.data());
                continue;
            }
            for (const auto& [from, to] : {std::pair(0, rows), std::pair(rows, kHeight)}) {
                if (to - from < 8) continue;
                EXPECT_LT(errorOf(denoised, from, to), 0.09) << passes << " " << rows << " " << from;
                // What it would be otherwise. A whole row has no blocks.
                if (passes < 3 || from == rows) {
                    EXPECT_GT(errorOf(asOne, from, to), 0.1) << passes << " " << rows << " " << from;
                }
            }
        }
    }
}

// Where every pixel that the film has is true already, nothing is moved: enlarging a ramp gives that ramp.
TEST(LatticeDenoiser, KeepsPlaces) {
    const Film film = filmAfter(2, kHeight);
    Image ramp(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) ramp.setRgb(x, y, Rgb(float(x - x % 2), float(y - y % 2), 1));
    denoiseByLattices(ramp, ramp, ramp, film, [](Image&, const Image&, const Image&) {});
    for (int y = 0; y < kHeight - 1; ++y)
        for (int x = 0; x < kWidth - 1; ++x) EXPECT_EQ(ramp.rgb(x, y), Rgb(float(x), float(y), 1));
}

// A film that a deadline ended before its first pass: nothing to read out of bounds.
TEST(LatticeDenoiser, TakesFilmsWithoutAnyPass) {
    const Film film = filmAfter(1, 9);
    Image image = pictureOf(film);
    const Image features(kWidth, kHeight);
    denoiseByLattices(image, features, features, film, blur);
    EXPECT_EQ(image.width(), kWidth);
    for (const float v : image.data()) EXPECT_TRUE(std::isfinite(v));
}

}  // namespace
}  // namespace drc
