#include "pbrt/color_space.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "image/color.h"

namespace drc::pbrt {
namespace {

void expectNear(const Rgb& a, const Rgb& b, float tolerance) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << i;
}

TEST(ColorSpace, SrgbIsOurOwn) {
    expectNear(ColorSpace::srgb().light(Rgb(0.2f, 0.5f, 0.7f)), Rgb(0.2f, 0.5f, 0.7f), 3e-4f);
    expectNear(ColorSpace::srgb().reflectance(Rgb(0.2f, 0.5f, 0.7f)), Rgb(0.2f, 0.5f, 0.7f), 3e-4f);
}

TEST(ColorSpace, WhiteReflectanceIsWhiteInEverySpace) {
    for (const std::string_view name : ColorSpace::names()) {
        const ColorSpace* space = ColorSpace::named(name);
        ASSERT_NE(space, nullptr) << name;
        expectNear(space->reflectance(Rgb(1.f)), Rgb(1.f), 3e-4f);
        EXPECT_NEAR(luminance(space->light(Rgb(1.f))), 1, 1e-3f) << name;
    }
    EXPECT_EQ(ColorSpace::named("rec709"), nullptr);
}

// Saturated colours of a wide gamut have no plain counterpart from 0 to 1. Walls must not reflect more than they
// receive.
TEST(ColorSpace, ReflectancesNeverExceedOne) {
    for (const std::string_view name : ColorSpace::names())
        for (int i = 0; i < 11 * 11 * 11; ++i) {
            const Rgb c(float(i % 11) / 10, float(i / 11 % 11) / 10, float(i / 121) / 10);
            const Rgb albedo = ColorSpace::named(name)->reflectance(c);
            for (int k = 0; k < 3; ++k) {
                EXPECT_GE(albedo[k], 0) << name;
                EXPECT_LE(albedo[k], 1) << name;
            }
            // What absorbs in its own space does so in Rec. 709.
            const float own = std::max({c.x, c.y, c.z});
            if (own <= 0.6f) {
                EXPECT_LT(std::max({albedo.x, albedo.y, albedo.z}), 0.9f) << name << i;
            }
        }
    // Greys are what they are, and no colour is near another that is mapped far away.
    const ColorSpace* aces = ColorSpace::named("aces2065-1");
    expectNear(aces->reflectance(Rgb(0.9f)), Rgb(0.9f), 1e-3f);
    Rgb last = aces->reflectance(Rgb(0.f, 0.3f, 0.2f));
    for (float red = 0; red <= 1; red += 0.01f) {
        const Rgb next = aces->reflectance(Rgb(red, 0.3f, 0.2f));
        expectNear(next, last, 0.03f);
        last = next;
    }
}

TEST(ColorSpace, PublishedMatrices) {
    // The inverse of the conversion in ITU-R BT.2087, from BT.2020 to BT.709.
    const Rgb c = ColorSpace::named("rec2020")->light(Rgb(0.5f, 0.4f, 0.3f));
    expectNear(c,
               Rgb(1.6605f * .5f - .5876f * .4f - .0728f * .3f, -.1246f * .5f + 1.1329f * .4f - .0083f * .3f,
                   -.0182f * .5f - .1006f * .4f + 1.1187f * .3f),
               1e-3f);
    // Pure green of a wider space has negative red, which is clamped.
    EXPECT_EQ(ColorSpace::named("rec2020")->light(Rgb(0, 1, 0)).x, 0);
    // ACES has a white point of about 6000 K, warmer than D65. Reflectances are adapted to it.
    const Rgb white = ColorSpace::named("aces2065-1")->light(Rgb(1.f));
    EXPECT_GT(white.x, 1.02f);
    EXPECT_LT(white.z, 0.95f);
}

}  // namespace
}  // namespace drc::pbrt
