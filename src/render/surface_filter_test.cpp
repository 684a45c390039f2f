#include "render/surface_filter.h"

#include <gtest/gtest.h>

#include "math/rng.h"

namespace drc {
namespace {

constexpr int kWidth = 40, kHeight = 30;
constexpr size_t kPixels = size_t(kWidth) * kHeight;

// A wall to the left of the column kEdge and a floor to the right, both tilted against the view: pixels are not as far
// apart on them in x as in y.
constexpr int kEdge = 17;
SurfaceFilter corner() {
    SurfaceFilter filter(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const float along = 0.1f * float(x - kEdge);
            if (x < kEdge)
                filter.show(size_t(y * kWidth + x), Vec3(5, 0.05f * float(y), -along), Vec3(-1, 0, 0), 0.1f);
            else
                filter.show(size_t(y * kWidth + x), Vec3(5 - along, 0.05f * float(y), 0), Vec3(0, 0, 1), 0.1f);
        }
    return filter;
}

TEST(SurfaceFilter, KeepsWhatIsTheSameAlongASurface) {
    const SurfaceFilter filter = corner();
    Planes in(kPixels, 2), out(kPixels, 2);
    for (size_t i = 0; i < kPixels; ++i) {
        in.plane(0)[i] = int(i % kWidth) < kEdge ? 2.f : -3.f;
        in.plane(1)[i] = 7;
    }
    for (const int dilation : {1, 4, 32}) {
        filter.average(dilation, in, out);
        for (size_t i = 0; i < kPixels; ++i) {
            EXPECT_NEAR(out.plane(0)[i], in.plane(0)[i], 1e-5f) << i;
            EXPECT_NEAR(out.plane(1)[i], 7, 1e-5f);
        }
    }
}

TEST(SurfaceFilter, WeighsByTheSplineOnOneSurface) {
    const SurfaceFilter filter = corner();
    Planes in(kPixels, 1), out(kPixels, 1);
    const int x0 = 28, y0 = 14;
    in.plane(0)[y0 * kWidth + x0] = 1;
    filter.average(2, in, out);
    constexpr float kSpline[3] = {6.f / 16, 4.f / 16, 1.f / 16};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const int dx = std::abs(x - x0), dy = std::abs(y - y0);
            const bool near = dx % 2 == 0 && dy % 2 == 0 && dx <= 4 && dy <= 4;
            EXPECT_NEAR(out.plane(0)[y * kWidth + x], near ? kSpline[dx / 2] * kSpline[dy / 2] : 0, 1e-5f);
        }
    const std::vector<float> weights = filter.weights(2);
    EXPECT_NEAR(weights[y0 * kWidth + x0], 1, 1e-5f);
    // In the corner of the picture three columns and rows of five remain.
    EXPECT_NEAR(weights[(kHeight - 1) * kWidth + kWidth - 1], 121.f / 256, 1e-5f);
}

TEST(SurfaceFilter, NothingIsMixedAcrossDepthsOrWithNothing) {
    SurfaceFilter filter(kWidth, kHeight);
    Pcg32 rng(2);
    Planes in(kPixels, 1), out(kPixels, 1);
    // Two planes one behind the other, pixel by pixel at random, and pixels that show none, or no numbers.
    std::vector<int> shows(kPixels);
    for (size_t i = 0; i < kPixels; ++i) {
        const float x = float(i % kWidth), y = float(i / kWidth);
        shows[i] = int(rng.nextUint(5));
        in.plane(0)[i] = shows[i] == 0 ? 1 : shows[i] == 1 ? -1 : 1e6f;
        const float depth = shows[i] == 0 ? 0.f : 30.f;
        const Vec3 p = shows[i] == 3 ? Vec3(kInfinity, 0, 0) : Vec3(x, y, depth);
        const Vec3 n = shows[i] == 4 ? Vec3(std::nanf(""), 0, 1) : Vec3(0, 0, 1);
        filter.show(i, p, n, shows[i] == 2 ? 0.f : 1.f);
    }
    filter.average(1, in, out);
    for (size_t i = 0; i < kPixels; ++i) {
        EXPECT_EQ(filter.covers(i), shows[i] < 2);
        EXPECT_EQ(out.plane(0)[i], shows[i] == 0 ? 1 : shows[i] == 1 ? -1 : 0) << i << " shows " << shows[i];
    }
}

// A floor with a step of one in its values.
TEST(SurfaceFilter, GuidedByValuesItMixesOnlyWhatNoiseMayMakeDiffer) {
    SurfaceFilter plain(kWidth, kHeight);
    Planes values(kPixels, 3);
    for (size_t i = 0; i < kPixels; ++i) {
        plain.show(i, Vec3(float(i % kWidth), float(i / kWidth), 0), Vec3(0, 0, 1), 1);
        values.plane(1)[i] = int(i % kWidth) < kEdge ? 0 : 1;
    }
    const auto stepAt = [&](float noise, size_t i) {
        SurfaceFilter filter = plain;
        Planes noises(kPixels, 1);
        std::fill_n(noises.plane(0), kPixels, noise);
        filter.guideBy(values, std::move(noises));
        Planes out(kPixels, 3);
        filter.average(1, values, out);
        return out.plane(1)[i];
    };
    const size_t left = 15 * kWidth + kEdge - 1, right = left + 1;
    Planes unguided(kPixels, 3);
    plain.average(1, values, unguided);
    EXPECT_NEAR(unguided.plane(1)[left], 5.f / 16, 1e-5f);
    for (const float noise : {0.f, 0.01f}) {
        EXPECT_EQ(stepAt(noise, left), 0);
        EXPECT_FLOAT_EQ(stepAt(noise, right), 1);
    }
    EXPECT_NEAR(stepAt(1e6f, left), 5.f / 16, 1e-5f);
    // Of two pixels with a noise of one each, exp(-1/2) of a neighbour's weight.
    const float across = 5.f / 16 * std::exp(-0.5f);
    EXPECT_NEAR(stepAt(1, left), across / (11.f / 16 + across), 0.005f);
}

}  // namespace
}  // namespace drc
