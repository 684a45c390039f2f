#include "pbrt/equal_area_image.h"

#include <gtest/gtest.h>

#include <random>

namespace drc::pbrt {
namespace {

TEST(EqualAreaImage, AxesAreWherePbrtHasThem) {
    const auto at = [](const Vec3& d, float u, float v) {
        const Vec2 p = equalAreaSquareOf(d);
        EXPECT_NEAR(p.x, u, 1e-6f);
        EXPECT_NEAR(p.y, v, 1e-6f);
    };
    at(Vec3(0, 0, 1), 0.5f, 0.5f);
    at(Vec3(1, 0, 0), 1, 0.5f);
    at(Vec3(0, 2, 0), 0.5f, 1);
    at(Vec3(-1, 0, 0), 0, 0.5f);
    at(Vec3(1, 1, -1e-7f), 0.75f, 0.75f);
    EXPECT_NEAR(equalAreaSquareOf(Vec3(1e-4f, 1e-4f, -1)).x, 1, 1e-3f);
}

TEST(EqualAreaImage, SquareAndSphereAreInverse) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (int i = 0; i < 1000; ++i) {
        const Vec2 uv(uniform(random), uniform(random));
        const Vec3 d = equalAreaDirectionOf(uv);
        EXPECT_NEAR(length(d), 1, 1e-5f);
        const Vec2 back = equalAreaSquareOf(d);
        EXPECT_NEAR(back.x, uv.x, 2e-3f);
        EXPECT_NEAR(back.y, uv.y, 2e-3f);
    }
}

// A uniform square must give a uniform sphere: equal numbers of directions in each of 8 x 8 cells of equal solid angle.
TEST(EqualAreaImage, HasEqualAreas) {
    constexpr int kSide = 256;
    std::vector<int> counts(64, 0);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const Vec3 d = equalAreaDirectionOf(Vec2((float(x) + 0.37f) / kSide, (float(y) + 0.61f) / kSide));
            const int row = std::min(7, int((d.z + 1) * 4));
            const int column = std::min(7, int((std::atan2(d.y, d.x) / kPi + 1) * 4));
            ++counts[size_t(row * 8 + column)];
        }
    for (const int n : counts) EXPECT_NEAR(n, kSide * kSide / 64, 60);
}

TEST(EqualAreaImage, LatLongKeepsLightAndPlace) {
    LightImage square{64, 64, std::vector<Rgb>(64 * 64, Rgb(0.5f))};
    // A sun of a single pixel towards (1, 1, 1).
    const Vec2 sun = equalAreaSquareOf(Vec3(1, 1, 1));
    square.texels[size_t(sun.y * 64) * 64 + size_t(sun.x * 64)] = Rgb(1000, 500, 0.5f);
    const LightImage map = latLongFromEqualArea(square);
    ASSERT_EQ(map.width, 128);
    ASSERT_EQ(map.height, 64);
    double mean[3] = {};
    int brightest = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 128; ++x) {
            const double share = (std::cos(kPi * y / 64.0) - std::cos(kPi * (y + 1) / 64.0)) / 256;
            for (int k = 0; k < 3; ++k) mean[k] += share * map.at(x, y)[k];
            if (map.at(x, y).x > map.texels[size_t(brightest)].x) brightest = y * 128 + x;
        }
    EXPECT_NEAR(mean[0], 0.5 + 999.5 / 4096, 1e-4);
    EXPECT_NEAR(mean[1], 0.5 + 499.5 / 4096, 1e-4);
    EXPECT_NEAR(mean[2], 0.5, 1e-4);
    EXPECT_NEAR(brightest % 128, 16, 2);                                        // 45 degrees
    EXPECT_NEAR(brightest / 128, std::acos(1 / std::sqrt(3.0)) / kPi * 64, 2);  // from +z
    EXPECT_TRUE(latLongFromEqualArea({}).empty());
}

TEST(EqualAreaImage, Illuminance) {
    LightImage square{64, 64, std::vector<Rgb>(64 * 64, Rgb(2.f))};
    EXPECT_NEAR(horizontalIlluminance(square), 2 * kPi, 1e-2);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            if (equalAreaDirectionOf(Vec2((float(x) + 0.5f) / 64, (float(y) + 0.5f) / 64)).z > 0)
                square.texels[size_t(y) * 64 + size_t(x)] = Rgb(0.f);
    EXPECT_EQ(horizontalIlluminance(square), 0);
}

TEST(EqualAreaImage, Flip) {
    const LightImage flipped = flippedTopToBottom({1, 3, {Rgb(1.f), Rgb(2.f), Rgb(3.f)}});
    EXPECT_EQ(flipped.at(0, 0), Rgb(3.f));
    EXPECT_EQ(flipped.at(0, 1), Rgb(2.f));
    EXPECT_EQ(flipped.at(0, 2), Rgb(1.f));
}

}  // namespace
}  // namespace drc::pbrt
