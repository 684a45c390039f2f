#include "film/sample_pass.h"

#include <gtest/gtest.h>

#include <map>

namespace drc {
namespace {

constexpr int kWidth = 13, kHeight = 11;

TEST(SamplePass, EachPixelHasEachOfItsSamplesOnce) {
    std::map<std::array<int, 3>, int> taken;
    constexpr int kSamples = 3;
    for (int p = 0; p < SamplePass::passesFor(kSamples); ++p) {
        const SamplePass pass{p};
        for (int row = 0; row < kHeight; ++row)
            pass.forEachColumn(row, kWidth, [&](int column) { ++taken[{int(pass.sample()), row, column}]; });
        EXPECT_EQ(int(taken.size()) >= SamplePass::wholeSamples(p + 1) * kWidth * kHeight, true) << p;
    }
    EXPECT_EQ(int(taken.size()), kSamples * kWidth * kHeight);
    for (const auto& [at, count] : taken) EXPECT_EQ(count, 1);
}

TEST(SamplePass, PixelsBetweenLatticesAreFilled) {
    const PixelRegion region{5, 7, 5 + kWidth, 7 + kHeight};
    FilmLayer layer(region, {.name = "l"});
    const auto colour = [](int column, int row) { return Rgb(float(column), float(row), 1); };
    for (int p = 0; p < SamplePass::kLattices; ++p) {
        for (int row = 0; row < kHeight; ++row)
            SamplePass{p}.forEachColumn(row, kWidth,
                                        [&](int column) { layer.add(5 + column, 7 + row, 0, colour(column, row), 1); });
        Image image = layer.image();
        fillUnsampled({&image}, layer);
        const int lattice = 4 >> p;
        for (int row = 0; row < kHeight; ++row)
            for (int column = 0; column < kWidth; ++column)
                EXPECT_EQ(image.rgb(column, row), colour(column - column % lattice, row - row % lattice));
    }
}

}  // namespace
}  // namespace drc
