#include "math/windowed_distribution.h"

#include <gtest/gtest.h>

#include "math/rank_statistics.h"
#include "math/rng.h"

namespace drc {
namespace {

constexpr int kWidth = 7, kHeight = 5;

// A third of the cells are zero.
std::vector<float> table() {
    std::vector<float> f;
    Pcg32 rng(4);
    for (int i = 0; i < kWidth * kHeight; ++i) f.push_back(i % 3 == 1 ? 0.f : 0.1f + 3 * rng.nextFloat());
    return f;
}

std::vector<Window> windows() {
    std::vector<Window> result = {{}, {Vec2(0.3f, 0.4f), Vec2(0.31f, 0.41f)}, {Vec2(0, 0.2f), Vec2(1, 0.21f)}};
    Pcg32 rng(5);
    for (int i = 0; i < 12; ++i) {
        const Vec2 a = rng.nextVec2(), b = rng.nextVec2();
        result.push_back({Vec2(std::min(a.x, b.x), std::min(a.y, b.y)), Vec2(std::max(a.x, b.x), std::max(a.y, b.y))});
    }
    return result;
}

// The area in which a cell and a window overlap.
double overlap(const Window& window, int x, int y) {
    const auto along = [](float low, float high, int i, int n) {
        return std::max(0.0, std::min(double(high), double(i + 1) / n) - std::max(double(low), double(i) / n));
    };
    return along(window.low.x, window.high.x, x, kWidth) * along(window.low.y, window.high.y, y, kHeight);
}

TEST(WindowedDistribution, IntegratesOverWindows) {
    const std::vector<float> f = table();
    const WindowedDistribution2D d(f, kWidth, kHeight);
    for (const Window& window : windows()) {
        double expected = 0;
        for (int i = 0; i < kWidth * kHeight; ++i)
            expected += double(f[size_t(i)]) * overlap(window, i % kWidth, i / kWidth);
        EXPECT_NEAR(d.integral(window), expected, 1e-7);
    }
}

// The pdf is that of the function within the window; samples follow it, and go back to their random numbers.
TEST(WindowedDistribution, SamplesInProportionWithinTheWindow) {
    const std::vector<float> f = table();
    const WindowedDistribution2D d(f, kWidth, kHeight);
    constexpr int kSamples = 20000;
    for (const Window& window : windows()) {
        const double total = d.integral(window);
        if (!(total > 1e-4)) continue;
        std::vector<double> counts(size_t(kWidth) * kHeight);
        Pcg32 rng(6);
        for (int i = 0; i < kSamples; ++i) {
            const Vec2 u = rng.nextVec2();
            const auto s = d.sample(u, window);
            ASSERT_TRUE(s);
            ASSERT_TRUE(window.contains(s->at)) << s->at;
            const int x = std::min(int(s->at.x * kWidth), kWidth - 1),
                      y = std::min(int(s->at.y * kHeight), kHeight - 1);
            const float value = f[size_t(y * kWidth + x)];
            // A point exactly at the edge of a cell may be counted in its neighbour.
            if (std::abs(s->pdf - value / total) < 1e-3f * s->pdf) {
                EXPECT_NEAR(d.pdf(s->at, window), s->pdf, 1e-3f * s->pdf);
            }
            EXPECT_LT((d.inverse(s->at, window) - u).length(), 2e-3f);
            ++counts[size_t(y * kWidth + x)];
        }
        double chi2 = 0;
        int cells = 0;
        for (int i = 0; i < kWidth * kHeight; ++i) {
            const double p = double(f[size_t(i)]) * overlap(window, i % kWidth, i / kWidth) / total;
            if (p * kSamples < 5) {
                EXPECT_LT(counts[size_t(i)], 25);
                continue;
            }
            chi2 += sqr(float(counts[size_t(i)] - p * kSamples)) / (p * kSamples);
            ++cells;
        }
        EXPECT_GT(chiSquareUpperTail(chi2, std::max(1, cells - 1)), 1e-5) << chi2 << " of " << cells;
    }
}

TEST(WindowedDistribution, NothingInAWindowThatIsEmptyOrBlack) {
    const WindowedDistribution2D d(std::vector<float>{0, 1, NAN, -2}, 2, 2);
    EXPECT_FALSE(d.sample(Vec2(0.3f, 0.4f), {Vec2(0, 0), Vec2(0.5f, 1)}));
    EXPECT_FALSE(d.sample(Vec2(0.3f, 0.4f), {Vec2(0.7f, 0.2f), Vec2(0.7f, 0.2f)}));
    EXPECT_FALSE(d.sample(Vec2(0.3f, 0.4f), {Vec2(0.8f, 0.2f), Vec2(0.2f, 0.4f)}));
    EXPECT_EQ(d.pdf(Vec2(0.2f, 0.2f), {Vec2(0, 0), Vec2(0.5f, 1)}), 0);
    EXPECT_EQ(d.pdf(Vec2(0.9f, 0.2f), {Vec2(0, 0), Vec2(0.6f, 1)}), 0) << "outside";
    EXPECT_EQ(d.pdf(Vec2(0.9f, 0.2f), {}), 4);
    EXPECT_FALSE(WindowedDistribution2D().sample(Vec2(0.3f, 0.4f), {}));
}

// A sun does not spoil the precision of what lies beside it.
TEST(WindowedDistribution, DimCellsBesideASun) {
    std::vector<float> f(64 * 64, 1.f);
    f[20 * 64 + 20] = 1e9f;
    const WindowedDistribution2D d(f, 64, 64);
    const Window beside{Vec2(0.5f, 0.1f), Vec2(0.9f, 0.8f)};
    Pcg32 rng(1);
    Vec2 mean(0, 0);
    for (int i = 0; i < 4000; ++i) {
        const auto s = d.sample(rng.nextVec2(), beside);
        ASSERT_TRUE(s);
        EXPECT_NEAR(s->pdf, 1 / (0.4f * 0.7f), 1e-3f);
        mean += s->at * (1 / 4000.f);
    }
    EXPECT_LT((mean - Vec2(0.7f, 0.45f)).length(), 0.01f);
}

}  // namespace
}  // namespace drc
