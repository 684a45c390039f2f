#include "reconstruct/surface_filter.h"

#include <gtest/gtest.h>

#include "math/rng.h"

namespace drc {
namespace {

constexpr int kWidth = 40, kHeight = 30;
constexpr size_t kPixels = size_t(kWidth) * kHeight;

// A wall to the left of the column kEdge and a floor to the right, both tilted against the view: on them the distance
// of pixels in x differs from that in y.
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
    // In the corner of the picture three of five columns and rows remain.
    EXPECT_NEAR(weights[(kHeight - 1) * kWidth + kWidth - 1], 121.f / 256, 1e-5f);
}

TEST(SurfaceFilter, NothingIsMixedAcrossDepthsOrWithNothing) {
    SurfaceFilter filter(kWidth, kHeight);
    Pcg32 rng(2);
    Planes in(kPixels, 1), out(kPixels, 1);
    // Two planes one behind the other, pixel by pixel at random, and pixels without a surface or with values that are
    // not finite.
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
    // For two pixels with a noise of one each, a neighbour's weight is multiplied by exp(-1/2).
    const float across = 5.f / 16 * std::exp(-0.5f);
    EXPECT_NEAR(stepAt(1, left), across / (11.f / 16 + across), 0.005f);
}

// Groups of adjacent pixels are processed together; rows may be shorter than a group, or no multiple of it.
TEST(SurfaceFilter, FollowsItsFormulaAtAnyWidth) {
    constexpr int kRows = 6, kPlanes = 5, kDilation = 2;
    for (const int width : {1, 3, 8, 21, 40}) {
        const size_t pixels = size_t(width * kRows);
        Pcg32 rng(uint64_t(width), 7);
        SurfaceFilter filter(width, kRows);
        std::vector<Vec3> p(pixels), n(pixels);
        Planes in(pixels, kPlanes), out(pixels, kPlanes), values(pixels, 3), noise(pixels, 1);
        for (size_t i = 0; i < pixels; ++i) {
            p[i] = Vec3(float(int(i) % width), float(int(i) / width), rng.nextFloat());
            n[i] = normalize(Vec3(0.5f * rng.nextFloat(), 0.5f * rng.nextFloat(), 1));
            filter.show(i, p[i], n[i], 1);
            for (int c = 0; c < kPlanes; ++c) in.plane(c)[i] = rng.nextFloat();
            for (int c = 0; c < 3; ++c) values.plane(c)[i] = rng.nextFloat();
            noise.plane(0)[i] = rng.nextFloat();
        }
        filter.guideBy(values, noise);
        filter.average(kDilation, in, out);
        const std::vector<float> totals = filter.weights(kDilation);

        const auto falloff = [](float x) { return std::pow(std::max(0.f, 1 - x / 8), 8.f); };
        constexpr float kSpline[3] = {6.f / 16, 4.f / 16, 1.f / 16};
        for (int y = 0; y < kRows; ++y)
            for (int x = 0; x < width; ++x) {
                const auto i = size_t(y * width + x);
                float total = 0, sums[kPlanes] = {};
                for (int dy = -2; dy <= 2; ++dy)
                    for (int dx = -2; dx <= 2; ++dx) {
                        const int otherX = x + dx * kDilation, otherY = y + dy * kDilation;
                        if (otherX < 0 || otherX >= width || otherY < 0 || otherY >= kRows) continue;
                        const auto j = size_t(otherY * width + otherX);
                        const float apart = kDilation * std::hypot(float(dx), float(dy));
                        const float off = dot(n[i], p[j] - p[i]) / (0.5f * apart + 0.5f);
                        float difference = 0;
                        for (int c = 0; c < 3; ++c) difference += sqr(values.plane(c)[i] - values.plane(c)[j]);
                        const float w = kSpline[std::abs(dx)] * kSpline[std::abs(dy)] * falloff(off * off) *
                                        std::pow(dot(n[i], n[j]), 16.f) *
                                        falloff(difference / (noise.plane(0)[i] + noise.plane(0)[j]));
                        total += w;
                        for (int c = 0; c < kPlanes; ++c) sums[c] += w * in.plane(c)[j];
                    }
                EXPECT_NEAR(totals[i], total, 1e-5f) << width << ": " << x << ", " << y;
                for (int c = 0; c < kPlanes; ++c)
                    EXPECT_NEAR(out.plane(c)[i], sums[c] / total, 2e-5f) << width << ": " << x << ", " << y;
            }
    }
}

}  // namespace
}  // namespace drc
