#include "reconstruct/temporal_filter.h"

#include <gmock/gmock.h>

#include <cmath>

#include "base/folder_testing.h"
#include "image/image_layers.h"
#include "math/rng.h"

namespace drc {
namespace {

using testing::HasSubstr;

constexpr int kWidth = 64, kHeight = 48;

// A camera at (x, 0, 0) that looks along z at the plane z = 4; a pixel is 1/16 wide there. With kFocal pixels a unit at
// distance 1.
constexpr float kFocal = 64, kPlane = 4;

FrameGeometry cameraAt(float x) {
    FrameGeometry geometry;
    geometry.worldToCamera = Transform::translate(Vec3(-x, 0, 0));
    const double sx = kFocal / kWidth, sy = kFocal / kHeight;
    geometry.worldToNdc = Transform({sx, 0, .5, 0, 0, -sy, .5, 0, 0, 0, 1, 0, 0, 0, 1, 0}) * geometry.worldToCamera;
    return geometry;
}

// A wall with the light light(point), seen by a camera at x, with noise in each half. ball: place along x of an object
// of 1 x 1 before the wall, 1 unit nearer; its light is that of its own points. none: no ball.
template <class F>
TemporalFrame frameOf(float x, uint64_t seed, float noise, const F& light, std::optional<float> ball = {},
                      bool ballShines = false) {
    TemporalFrame frame;
    FrameSurfaces& s = frame.surfaces;
    s.name = "frame";
    s.albedo = Image(kWidth, kHeight);
    s.normal = Image(kWidth, kHeight, {"X", "Y", "Z"});
    s.position = Image(kWidth, kHeight, {"X", "Y", "Z"});
    s.depth = Image(kWidth, kHeight, {"Z"});
    s.object = Image(kWidth, kHeight, {"X"});
    s.geometry = cameraAt(x);
    if (ball) s.geometry.objects.add(2, Transform::translate(Vec3(*ball, 0, 0)));
    Pcg32 random(seed);
    for (size_t half = 0; half < 2; ++half)
        frame.direct[half] = Image(kWidth, kHeight), frame.indirect[half] = Image(kWidth, kHeight);
    for (int py = 0; py < kHeight; ++py)
        for (int px = 0; px < kWidth; ++px) {
            const Vec3 d((float(px) + .5f - kWidth / 2) / kFocal, -(float(py) + .5f - kHeight / 2) / kFocal, 1);
            Vec3 p = Vec3(x, 0, 0) + d * kPlane;
            bool isBall = false;
            if (ball) {
                const Vec3 nearer = Vec3(x, 0, 0) + d * (kPlane - 1);
                isBall = std::abs(nearer.x - *ball) < .5f && std::abs(nearer.y) < .5f;
                if (isBall) p = nearer;
            }
            s.position.setRgb(px, py, Rgb(p.x, p.y, p.z));
            s.normal.setRgb(px, py, Rgb(0, 0, -1));
            s.albedo.setRgb(px, py, Rgb(isBall && ballShines ? 0 : .5f));
            s.depth.at(px, py, 0) = p.z;
            s.object.at(px, py, 0) = isBall ? 2 : 1;
            const float is = isBall ? 3 : light(p);
            for (size_t half = 0; half < 2; ++half) {
                frame.direct[half].setRgb(px, py, Rgb(is + noise * (2 * random.nextFloat() - 1)));
                frame.indirect[half].setRgb(px, py, Rgb(1 + noise * (2 * random.nextFloat() - 1)));
            }
        }
    return frame;
}

float even(const Vec3&) { return 2; }
// Stripes on the wall that are a few pixels wide.
float stripes(const Vec3& p) { return 2 + std::sin(6 * p.x); }

// The root mean square difference of the beauty from the light that is there, over an area.
template <class F>
double lightError(const Image& beauty, const TemporalFrame& frame, const F& light, int x0 = 0, int x1 = kWidth) {
    double sum = 0;
    int count = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = x0; x < x1; ++x) {
            const float* p = frame.surfaces.position.pixel(x, y);
            const float should = 1 + (frame.surfaces.object.at(x, y, 0) == 2 ? 3 : light(Vec3(p[0], p[1], p[2])));
            sum += std::pow(double(beauty.at(x, y, 0) - should), 2);
            ++count;
        }
    return std::sqrt(sum / count);
}

template <class F>
std::vector<TemporalFrame> shot(const std::vector<float>& cameras, float noise, const F& light) {
    std::vector<TemporalFrame> frames;
    for (size_t i = 0; i < cameras.size(); ++i) frames.push_back(frameOf(cameras[i], i + 1, noise, light));
    return frames;
}

FilteredFrame middle(const std::vector<TemporalFrame>& frames) {
    std::vector<const TemporalFrame*> others;
    for (size_t i = 0; i < frames.size(); ++i)
        if (i != frames.size() / 2) others.push_back(&frames[i]);
    return filteredOverTime(frames[frames.size() / 2], others);
}

TEST(TemporalFilter, FiveFramesHaveAFifthOfTheVariance) {
    const auto frames = shot({0, 0, 0, 0, 0}, 1, even);
    const double alone = lightError(filteredOverTime(frames[2], {}).beauty(), frames[2], even),
                 together = lightError(middle(frames).beauty(), frames[2], even);
    EXPECT_NEAR(together / alone, std::sqrt(.2), .03);
}

TEST(TemporalFilter, FollowsAMovingCamera) {
    const auto frames = shot({-.13f, -.07f, 0, .06f, .15f}, .6f, stripes);
    const FilteredFrame filtered = middle(frames);
    const double alone = lightError(filteredOverTime(frames[2], {}).beauty(), frames[2], stripes, 8, kWidth - 8);
    EXPECT_LT(lightError(filtered.beauty(), frames[2], stripes, 8, kWidth - 8), .6 * alone);
    // Without noise, what is left is that points are followed to whole pixels.
    const auto clean = shot({-.13f, -.07f, 0, .06f, .15f}, 0, stripes);
    EXPECT_LT(lightError(middle(clean).beauty(), clean[2], stripes), .1);
    // What one of the frames does not show is averaged with the others.
    EXPECT_NEAR(filtered.frames.at(kWidth / 2, kHeight / 2, 0), 5, .3);
}

TEST(TemporalFilter, FollowsAMovingObject) {
    std::vector<TemporalFrame> frames;
    for (int i = -2; i <= 2; ++i) frames.push_back(frameOf(0, uint64_t(i + 9), .4f, stripes, float(i) * .2f));
    const FilteredFrame filtered = middle(frames);
    EXPECT_GT(filtered.frames.at(kWidth / 2, kHeight / 2, 0), 4.5f);  // on the object
    // No trail beside it, where other frames show the object.
    for (int x = 0; x < kWidth; ++x)
        EXPECT_NEAR(filtered.direct[0].at(x, kHeight / 2, 0),
                    frames[2].surfaces.object.at(x, kHeight / 2, 0) == 2
                        ? 3
                        : stripes(Vec3(frames[2].surfaces.position.at(x, kHeight / 2, 0), 0, 0)),
                    .45f)
            << x;
}

// The edge of a bright object keeps its own share of each pixel: neighbours, in which the edge cuts pixels elsewhere,
// would make it ragged.
TEST(TemporalFilter, BrightSilhouettesStayStraight) {
    std::vector<TemporalFrame> frames;
    for (int i = -2; i <= 2; ++i) {
        frames.push_back(frameOf(.013f * float(i), uint64_t(i + 5), .2f, even, 0.f, true));
        // The pixel that the object's right edge cuts is as bright as the object's share of it, and as noisy, as few
        // samples find it.
        TemporalFrame& frame = frames.back();
        Pcg32 random(uint64_t(i + 50));
        const float edge = kWidth / 2 + kFocal * (.5f - .013f * float(i)) / (kPlane - 1);
        const int x = int(std::floor(edge));
        for (int y = kHeight / 2 - 8; y < kHeight / 2 + 8; ++y)
            for (Image& half : frame.direct)
                half.setRgb(x, y, half.rgb(x, y) + Rgb(100 * (edge - float(x)) + 80 * (random.nextFloat() - .5f)));
    }
    const float edge = kWidth / 2 + kFocal * .5f / (kPlane - 1);
    const int x = int(std::floor(edge));
    const Image light = middle(frames).directLight();
    for (int y = kHeight / 2 - 8; y < kHeight / 2 + 8; ++y)
        EXPECT_NEAR(light.at(x, y, 0), (frames[2].direct[0].at(x, y, 0) + frames[2].direct[1].at(x, y, 0)) / 2, .1f)
            << y;
}

// Light that changes over time is not mixed, although the surfaces stay.
TEST(TemporalFilter, ChangedLightIsNotMixed) {
    std::vector<TemporalFrame> frames;
    const auto lamp = [](bool on) { return [on](const Vec3& p) { return p.x < 0 && on ? 4.f : 2.f; }; };
    for (int i = 0; i < 5; ++i) frames.push_back(frameOf(0, uint64_t(i + 1), .5f, lamp(i >= 2)));
    const FilteredFrame filtered = middle(frames);
    double mean = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth / 2 - 3; ++x) mean += double(filtered.directLight().at(x, y, 0));
    mean /= kHeight * (kWidth / 2 - 3);
    EXPECT_NEAR(mean, 4, .04);
    EXPECT_GT(filtered.frames.at(kWidth / 4, kHeight / 2, 0), 4.5f);  // indirect light has not changed
}

TEST(TemporalFilter, AFireflyIsNoChangeOfLight) {
    auto frames = shot({0, 0, 0}, .5f, even);
    frames[1].indirect[0].setRgb(32, 24, Rgb(500));
    EXPECT_GT(middle(frames).frames.at(32, 24, 0), 2.5f);
}

TEST(TemporalFilter, VarianceIsThatOfTheHalves) {
    const auto frames = shot({0, 0, 0}, 1, even);
    const FilteredFrame filtered = middle(frames);
    const Image variance = filtered.variance();
    double mean = 0;
    for (const float v : variance.data()) mean += double(v) / double(variance.data().size());
    const double error = lightError(filtered.beauty(), frames[1], even);
    EXPECT_NEAR(mean / (error * error), 1, .15);
}

TEST(TemporalFilter, FramesOfOtherShapeAreRefused) {
    const TemporalFrame one = frameOf(0, 1, 0, even);
    TemporalFrame whole = one, small = one;
    whole.surfaces.name = "whole.exr";
    whole.indirect = {};
    small.surfaces.name = "small.exr";
    small.surfaces.albedo = Image(8, 8);
    for (const TemporalFrame* other : {&whole, &small}) {
        const TemporalFrame* const list[] = {other};
        EXPECT_THAT(errorOf([&] { filteredOverTime(one, list); }), HasSubstr(other->surfaces.name));
    }
}

TEST(TemporalFrame, MissingLayersAreNamed) {
    PictureFile file{.path = "a.exr", .image = Image(4, 4)};
    EXPECT_THAT(errorOf([&] { temporalFrameOf(file); }), testing::AllOf(HasSubstr("a.exr"), HasSubstr("--aovs")));
}

}  // namespace
}  // namespace drc
