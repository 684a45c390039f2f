#include "math/square_warp.h"

#include <gtest/gtest.h>

#include <random>

namespace drc {
namespace {

constexpr SquareGrid kGrid{7, 5};
constexpr int kMembers = 6;

// Six densities of different shapes and sums, with zeros.
std::vector<float> someValues() {
    std::mt19937 rng(1);
    std::vector<float> values;
    for (int m = 0; m < kMembers; ++m)
        for (int i = 0; i < kGrid.size(); ++i)
            values.push_back(rng() % 4 == 0 ? 0 : float(m + 1) * float(rng() >> 8) * 0x1p-24f);
    return values;
}
const FamilyGrid kFamily({0, 1, 3}, {-1, 1});

float uniform(std::mt19937& rng) { return float(rng() >> 8) * 0x1p-24f; }

TEST(FamilyGrid, InterpolatesLinearly) {
    for (const float a : {-1.f, 0.f, 0.3f, 1.f, 2.5f, 3.f, 9.f})
        for (const float b : {-2.f, -1.f, 0.4f, 1.f}) {
            const FamilyWeights w = kFamily.at(a, b);
            float sum = 0, first = 0, second = 0;
            for (size_t k = 0; k < 4; ++k) {
                sum += w.weight[k];
                first += w.weight[k] * kFamily.first()[size_t(w.member[k] / 2)];
                second += w.weight[k] * kFamily.second()[size_t(w.member[k] % 2)];
            }
            EXPECT_NEAR(sum, 1, 1e-6f);
            EXPECT_NEAR(first, std::clamp(a, 0.f, 3.f), 1e-6f);
            EXPECT_NEAR(second, std::clamp(b, -1.f, 1.f), 1e-6f);
        }
    const FamilyWeights one = FamilyGrid({5}, {7}).at(1, 2);
    EXPECT_EQ(one.weight[0], 1);
    EXPECT_EQ(one.member[0], 0);
}

TEST(SquareTable, IsBilinear) {
    std::vector<Rgb> values;
    for (int y = 0; y < kGrid.height; ++y)
        for (int x = 0; x < kGrid.width; ++x) values.push_back(Rgb(float(x), float(y), float(x * y)));
    const SquareTable<Rgb> table(kGrid, values);
    for (const float u : {0.f, 0.21f, 0.5f, 0.93f, 1.f})
        for (const float v : {0.f, 0.4f, 1.f}) {
            const Rgb found = table.eval(Vec2(u, v));
            EXPECT_NEAR(found.x, 6 * u, 1e-5f);
            EXPECT_NEAR(found.y, 4 * v, 1e-5f);
            EXPECT_NEAR(found.z, 24 * u * v, 1e-4f);
        }
}

TEST(SquareWarp, InvertIsTheInverse) {
    const SquareWarp warp(kGrid, someValues(), kMembers);
    std::mt19937 rng(2);
    for (int i = 0; i < 5000; ++i) {
        const FamilyWeights family = kFamily.at(3 * uniform(rng), 2 * uniform(rng) - 1);
        const float ux = uniform(rng);
        const Vec2 u(ux, uniform(rng));
        const SquareWarp::Warped there = warp.sample(u, family);
        const SquareWarp::Warped back = warp.invert(there.p, family);
        if (there.pdf < 0.05f) continue;  // where nothing is, rounding decides
        EXPECT_NEAR(back.p.x, u.x, 2e-5f);
        EXPECT_NEAR(back.p.y, u.y, 2e-5f);
        EXPECT_NEAR(back.pdf, there.pdf, 1e-3f * there.pdf);
    }
}

// The pdf is the table, scaled so that its integral is one; and samples in each cell are as many as its integral says.
TEST(SquareWarp, SamplesHaveTheDensityOfTheTable) {
    const std::vector<float> values = someValues();
    const SquareWarp warp(kGrid, values, kMembers);
    const SquareTable<float> table(kGrid, values);
    constexpr int kSteps = 300;
    for (const FamilyWeights& family : {kFamily.at(0, -1), kFamily.at(3, 1)}) {
        double integral = 0, inTable = 0;
        for (int i = 0; i < kSteps * kSteps; ++i) {
            const Vec2 p((float(i % kSteps) + 0.5f) / kSteps, (float(i / kSteps) + 0.5f) / kSteps);
            integral += warp.invert(p, family).pdf;
            inTable += table.eval(p, family);
        }
        EXPECT_NEAR(integral / (kSteps * kSteps), 1, 1e-3);
        const Vec2 p(0.3f, 0.7f);
        EXPECT_NEAR(warp.invert(p, family).pdf, table.eval(p, family) / (inTable / (kSteps * kSteps)), 5e-3);
    }
    const FamilyWeights between = kFamily.at(1.7f, 0.2f);
    constexpr int kCells = 12, kSamples = 400000;
    std::vector<int> found(kCells * kCells);
    std::mt19937 rng(3);
    for (int i = 0; i < kSamples; ++i) {
        const float x = uniform(rng);
        const Vec2 p = warp.sample(Vec2(x, uniform(rng)), between).p;
        ++found[size_t(std::min(int(p.y * kCells), kCells - 1) * kCells + std::min(int(p.x * kCells), kCells - 1))];
    }
    for (int cell = 0; cell < kCells * kCells; ++cell) {
        constexpr int kSub = 16;
        double expected = 0;
        for (int i = 0; i < kSub * kSub; ++i)
            expected += warp.invert(Vec2((float(cell % kCells) + (float(i % kSub) + 0.5f) / kSub) / kCells,
                                         (float(cell / kCells) + (float(i / kSub) + 0.5f) / kSub) / kCells),
                                    between)
                            .pdf;
        expected *= double(kSamples) / (kSub * kSub * kCells * kCells);
        EXPECT_NEAR(found[size_t(cell)], expected, 5 * std::sqrt(expected) + 0.01 * expected + 2) << cell;
    }
}

TEST(SquareWarp, ATableOfZerosIsConstant) {
    const SquareWarp warp({3, 3}, std::vector<float>(9, 0.f), 1);
    const SquareWarp::Warped w = warp.sample(Vec2(0.3f, 0.6f), {});
    EXPECT_NEAR(w.p.x, 0.3f, 1e-6f);
    EXPECT_NEAR(w.p.y, 0.6f, 1e-6f);
    EXPECT_NEAR(w.pdf, 1, 1e-6f);
}

}  // namespace
}  // namespace drc
