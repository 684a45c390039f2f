#include "image/exr_primaries.h"

#include <gmock/gmock.h>

#include <array>

#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::HasSubstr;

ExrAttribute chromaticities(const std::array<float, 8>& xy) {
    return {"chromaticities", std::string(reinterpret_cast<const char*>(xy.data()), sizeof(xy))};
}

void expectMatrix(const std::array<float, 8>& xy, const std::array<float, 9>& expected) {
    const auto map = rec709From(chromaticities(xy));
    ASSERT_TRUE(map);
    for (int i = 0; i < 9; ++i) EXPECT_NEAR(map->rows[size_t(i / 3)][i % 3], expected[size_t(i)], 2e-4) << i;
}

TEST(ExrPrimaries, OfRec709AreLeft) {
    EXPECT_FALSE(rec709From(chromaticities({.64f, .33f, .3f, .6f, .15f, .06f, .3127f, .329f})));
    EXPECT_FALSE(rec709From(chromaticities({.64f, .33f, .3f, .6f, .15f, .06f, .31271f, .32902f})));
}

TEST(ExrPrimaries, AreMappedToRec709) {
    // ITU-R BT.2087 has the inverse of the first.
    expectMatrix({.708f, .292f, .17f, .797f, .131f, .046f, .3127f, .329f},
                 {1.6605f, -.5876f, -.0728f, -.1246f, 1.1329f, -.0083f, -.0182f, -.1006f, 1.1187f});
    // ACES' AP0 and AP1, of another white: the Academy's matrices, with Bradford's adaptation.
    expectMatrix({.7347f, .2653f, 0, 1, .0001f, -.077f, .32168f, .33767f},
                 {2.52169f, -1.13413f, -.38756f, -.27648f, 1.37272f, -.09624f, -.01538f, -.15298f, 1.16835f});
    expectMatrix({.713f, .293f, .165f, .83f, .128f, .044f, .32168f, .33767f},
                 {1.70505f, -.62179f, -.08326f, -.13026f, 1.14080f, -.01055f, -.02400f, -.12897f, 1.15297f});
    // XYZ: blue has no luminance. White stays white.
    const auto xyz = rec709From(chromaticities({1, 0, 0, 1, 0, 0, 1 / 3.f, 1 / 3.f}));
    ASSERT_TRUE(xyz);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR((*xyz * Rgb(1, 1, 1))[c], 1, 1e-5);
}

TEST(ExrPrimaries, ThatAreNoneAreRefused) {
    const auto fault = [](const std::array<float, 8>& xy) {
        return errorOf([&] { (void)rec709From(chromaticities(xy)); });
    };
    EXPECT_EQ(fault({}), "its chromaticities (0 0, 0 0, 0 0, white 0 0) are no primaries");
    EXPECT_THAT(fault({.64f, .33f, .3f, .6f, .47f, .465f, .3127f, .329f}), HasSubstr("no primaries"));
    EXPECT_THAT(fault({.64f, .33f, .3f, .6f, .15f, .06f, .3f, 0}), HasSubstr("white 0.3 0"));
    EXPECT_THAT(fault({.64f, .33f, std::numeric_limits<float>::quiet_NaN(), .6f, .15f, .06f, .3f, .3f}),
                HasSubstr("no primaries"));
    EXPECT_THAT(errorOf([] { (void)rec709From({"chromaticities", "abc"}); }), HasSubstr("cut short"));
}

TEST(ExrPrimaries, DataAreNoColours) {
    for (const char* layer : {"N", "P", "left.N", "Denoising Normal", "ViewLayer.Vector", "CryptoObject00", "uv"})
        EXPECT_TRUE(isDataLayer(layer)) << layer;
    for (const char* layer : {"", "direct", "Denoising Albedo", "left", "Night"})
        EXPECT_FALSE(isDataLayer(layer)) << layer;
    Image image(1, 1, {"R", "G", "B", "d.R", "d.G"});
    image.data() = {1, 2, 3, 4, 5};
    const RgbMatrix swapped{{Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(0, 0, 2)}};
    mapColours(image, "", swapped);
    mapColours(image, "d", swapped);
    EXPECT_THAT(image.data(), testing::ElementsAre(2, 1, 6, 4, 5));
}

}  // namespace
}  // namespace drc
