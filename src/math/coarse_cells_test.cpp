#include "math/coarse_cells.h"

#include <gtest/gtest.h>

#include <cmath>

namespace drc {
namespace {

TexelIntegrals gradient(int width, int height) {
    TexelIntegrals f{width, height, {}};
    for (int i = 0; i < width * height; ++i) f.values.push_back(1 + 0.01f * float(i % width));
    return f;
}

TEST(CoarseCells, AreLargeWhereTheFunctionIsSmooth) {
    TexelIntegrals f = gradient(128, 64);
    const std::vector<double> sizes(64, 1.0);
    EXPECT_EQ(coarsestCell(f, sizes), 32);
    // A texel that holds half of the integral must have a cell of its own.
    f.values[20 * 128 + 77] = 128 * 64;
    EXPECT_EQ(coarsestCell(f, sizes), 1);
    // Both sides are divided evenly: 12 by 20 texels.
    EXPECT_EQ(coarsestCell(gradient(12, 20), std::vector<double>(20, 1.0)), 4);
    EXPECT_EQ(coarsestCell(gradient(15, 20), std::vector<double>(20, 1.0)), 1);
}

// The second moment, computed from the definition: the integral of f^2 / p, with the density p of the cells.
double secondMoment(const TexelIntegrals& f, const std::vector<double>& sizes, int cell) {
    const TexelIntegrals sums = sumsOverCells(f, cell);
    double total = 0, moment = 0;
    for (const float v : f.values) total += double(v);
    for (int y = 0; y < f.height; ++y)
        for (int x = 0; x < f.width; ++x) {
            double cellSize = 0;
            for (int k = 0; k < cell; ++k) cellSize += cell * sizes[size_t(y / cell * cell + k)];
            const double density =
                double(sums.values[size_t(y / cell) * size_t(sums.width) + size_t(x / cell)]) / total / cellSize;
            const double value = double(f.values[size_t(y) * size_t(f.width) + size_t(x)]) / sizes[size_t(y)];
            moment += value * value / density * sizes[size_t(y)];
        }
    return moment;
}

TEST(CoarseCells, AddAtMostTheNoiseThatIsAllowed) {
    // Waves of growing contrast, on rows of different size, as those of a map of the sky are.
    std::vector<double> sizes;
    for (int y = 0; y < 32; ++y) sizes.push_back(std::sin((y + 0.5) * 0.098));
    int last = 32;
    for (float contrast : {0.01f, 0.3f, 0.6f, 0.9f, 0.99f}) {
        TexelIntegrals f{64, 32, {}};
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 64; ++x)
                f.values.push_back(float(sizes[size_t(y)]) * (1 + contrast * std::sin(0.25f * float(x + y))));
        const int cell = coarsestCell(f, sizes);
        const double least = secondMoment(f, sizes, 1);
        EXPECT_LE(secondMoment(f, sizes, cell), kNoiseAllowed * least + 1e-6);
        if (cell < 32) {
            EXPECT_GT(secondMoment(f, sizes, 2 * cell), kNoiseAllowed * least);
        }
        EXPECT_LE(cell, last);
        last = cell;
    }
    EXPECT_LT(last, 8);
}

TEST(CoarseCells, SumsKeepTheIntegral) {
    const TexelIntegrals sums = sumsOverCells({4, 2, {1, 2, 3, 4, 5, 6, 7, 8}}, 2);
    EXPECT_EQ(sums.width, 2);
    EXPECT_EQ(sums.height, 1);
    EXPECT_EQ(sums.values, (std::vector<float>{14, 22}));
}

}  // namespace
}  // namespace drc
