#include "render/correction.h"

#include <gtest/gtest.h>

#include <random>

namespace drc {
namespace {

constexpr PixelRegion kRegion{10, 20, 50, 50};

// A wall (x below 30) and a floor (the rest), lit by `light`, of a chequered albedo; noisy samples of it.
struct Scene {
    static bool wall(int x) { return x < 30; }
    static Rgb albedo(int x, int y) { return (x / 2 + y / 2) % 2 ? Rgb(0.8f, 0.6f, 0.4f) : Rgb(0.1f, 0.2f, 0.3f); }
    static Rgb light(int x) { return wall(x) ? Rgb(1, 2, 3) : Rgb(5, 4, 3); }
};

IndirectCorrection traced(int samples, float outlier = 0) {
    IndirectCorrection correction(kRegion);
    std::mt19937 rng(1);
    std::exponential_distribution<float> noise(1);
    for (int i = 0; i < samples; ++i)
        for (int y = kRegion.y0; y < kRegion.y1; ++y)
            for (int x = kRegion.x0; x < kRegion.x1; ++x) {
                IndirectAlong s;
                s.albedo = Scene::albedo(x, y);
                s.wide = s.albedo * Scene::light(x) * noise(rng);
                if (outlier > 0 && x == 20 && y == 35 && i == 3) s.wide = Rgb(outlier);
                s.normal = Scene::wall(x) ? Vec3(1, 0, 0) : Vec3(0, 0, 1);
                s.position = Scene::wall(x) ? Vec3(0, float(y), float(30 - x)) : Vec3(float(x - 30), float(y), 0);
                s.pixelSize = 1;
                correction.add(x, y, i % IndirectCorrection::kGroups, s, 1);
            }
    return correction;
}

Image layer(float scale) {
    Image image(kRegion.width(), kRegion.height());
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            image.setRgb(x, y, Scene::albedo(x + 10, y + 20) * Scene::light(x + 10) * scale);
    return image;
}

double relativeError(const Image& image) {
    const Image truth = layer(1);
    double sum = 0;
    for (size_t i = 0; i < truth.data().size(); ++i) sum += std::abs(image.data()[i] / truth.data()[i] - 1);
    return sum / double(truth.data().size());
}

TEST(Correction, RemovesASmoothErrorWithoutNoiseOrLeaks) {
    Image image = layer(0.7f);
    EXPECT_NEAR(relativeError(image), 0.3, 1e-5);
    traced(64).apply(image);
    // The samples themselves have a relative error of 1/8 a pixel; and a filter across the edge would mix light that
    // differs fivefold.
    EXPECT_LT(relativeError(image), 0.03);
}

TEST(Correction, LeavesARightLayerNearlyAsItIs) {
    Image image = layer(1);
    traced(16).apply(image);
    EXPECT_LT(relativeError(image), 0.02);
}

TEST(Correction, OneBrightPathMakesNoBlotch) {
    Image image = layer(1);
    traced(16, 1e5f).apply(image);
    EXPECT_LT(relativeError(image), 0.03);
}

// Nothing is near this pixel, and of its light only one path in many is bright: those that are not prove nothing.
TEST(Correction, APixelAloneKeepsWhatItHas) {
    IndirectCorrection correction = traced(0);
    for (int i = 0; i < 64; ++i)
        for (int y = kRegion.y0; y < kRegion.y1; ++y)
            for (int x = kRegion.x0; x < kRegion.x1; ++x) {
                const bool alone = x == 35 && y == 40;
                IndirectAlong s;
                s.albedo = Scene::albedo(x, y);
                s.wide = s.albedo * Scene::light(x) * (alone ? 0.1f + 0.01f * float(i % 7) : 1.f);
                s.normal = Vec3(0, 0, 1);
                s.position = Vec3(float(x), float(y), alone ? 100.f : 0.f);
                s.pixelSize = 1;
                correction.add(x, y, i % IndirectCorrection::kGroups, s, 1);
            }
    Image image = layer(1);
    correction.apply(image);
    EXPECT_LT(relativeError(image), 1e-4);
}

TEST(Correction, TooFewSamplesChangeNothing) {
    Image image = layer(0.7f);
    traced(3).apply(image);
    EXPECT_EQ(image.data(), layer(0.7f).data());
}

}  // namespace
}  // namespace drc
