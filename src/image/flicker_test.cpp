#include "image/flicker.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/rng.h"

namespace drc {
namespace {

constexpr int kSize = 96;

// A wall of one plane, whose camera moves by whole pixels: pixel x of frame t shows the point x + shift * t.
FrameSurfaces surfacesAt(int shift) {
    FrameSurfaces s;
    s.albedo = Image(kSize, kSize);
    s.normal = Image(kSize, kSize, {"X", "Y", "Z"});
    s.position = Image(kSize, kSize, {"X", "Y", "Z"});
    s.depth = Image(kSize, kSize, {"Z"});
    s.object = Image(kSize, kSize, {"X"});
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            s.position.setRgb(x, y, Rgb(float(x + shift) + .5f, float(y) + .5f, 1));
            s.normal.setRgb(x, y, Rgb(0, 0, -1));
            s.depth.at(x, y, 0) = 1;
            s.object.at(x, y, 0) = 1;
        }
    s.geometry.worldToCamera = Transform();
    s.geometry.worldToNdc =
        Transform({1. / kSize, 0, 0, -double(shift) / kSize, 0, 1. / kSize, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    return s;
}

// What the wall shows, times `light`, with noise of its own.
Image wall(int shift, float noise, uint64_t seed, float light = 1) {
    Image image(kSize, kSize);
    Pcg32 random(seed);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const float is = light * (1 + .5f * std::sin(.3f * float(x + shift)));
            image.setRgb(x, y, Rgb(is + noise * (2 * random.nextFloat() - 1)));
        }
    return image;
}

struct Shot {
    FrameSurfaces now = surfacesAt(0), next = surfacesAt(3);
    Image r1 = wall(0, .5f, 1), nextR1 = wall(3, .5f, 2), r2 = wall(0, .5f, 3), nextR2 = wall(3, .5f, 4);
    Flicker of(const Image& test, const Image& nextTest) const {
        // Two stops darker, so that an sRGB display does not clip.
        return flickerBetween({now, next, r1, nextR1, r2, nextR2}, test, nextTest, -2);
    }
};

TEST(Flicker, PerfectFramesDoNotFlickerHoweverNoisyTheReferencesAre) {
    const Flicker f = Shot().of(wall(0, 0, 0), wall(3, 0, 0));
    EXPECT_NEAR(f.pixels.mean, 0, .02);
    EXPECT_NEAR(f.blocks.mean, 0, .002);
    EXPECT_NEAR(f.compared, double(kSize - 3) / kSize, 1e-6);
    EXPECT_LT(f.medianStep, .01);
}

// Twice the variance of a frame's noise, divided by the mean of D^2 + .01 as relative errors are.
TEST(Flicker, IsTheVarianceOfWhatChanges) {
    const float noise = .3f;
    const Flicker f = Shot().of(wall(0, noise, 11), wall(3, noise, 12));
    double inverse = 0;
    for (int i = 0; i < 628; ++i) inverse += 1 / (std::pow(1 + .5 * std::sin(.01 * i), 2) + .01) / 628;
    const double expected = 2 * noise * noise / 3 * inverse;
    EXPECT_NEAR(f.pixels.mean / expected, 1, .15);
    EXPECT_LT(f.blocks.mean, .05 * expected);
    EXPECT_GT(f.medianStep, 5);
    EXPECT_GT(f.percentile99, 2 * f.medianStep);
}

// Frames that are all wrong in the same way do not flicker, and blur gains nothing.
TEST(Flicker, ConstantErrorsAreNoFlicker) {
    const Flicker f = Shot().of(wall(0, 0, 0, .8f), wall(3, 0, 0, .8f));
    EXPECT_NEAR(f.pixels.mean, 0, .02);
}

TEST(Flicker, ChangesOfBrightnessAreFlicker) {
    const Flicker f = Shot().of(wall(0, 0, 0), wall(3, 0, 0, 1.2f));
    EXPECT_NEAR(f.pixels.mean, .04, .02);
    EXPECT_NEAR(f.blocks.mean, .04, .01);
}

// Light that truly changes is not flicker of frames that show it.
TEST(Flicker, TrueChangesAreNoFlicker) {
    Shot shot;
    shot.nextR1 = wall(3, .5f, 2, 1.5f), shot.nextR2 = wall(3, .5f, 4, 1.5f);
    EXPECT_NEAR(shot.of(wall(0, 0, 0), wall(3, 0, 0, 1.5f)).blocks.mean, 0, .003);
    EXPECT_GT(shot.of(wall(0, 0, 0), wall(3, 0, 0)).blocks.mean, .1);
}

}  // namespace
}  // namespace drc
