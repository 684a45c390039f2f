#include "pbrt/spectrum.h"

#include <gmock/gmock.h>

#include <tuple>

#include "image/color.h"
#include "pbrt/cie.h"
#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

void expectNear(const Rgb& a, const Rgb& b, float tolerance) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "channel " << i;
}

TEST(Cie, IntegralsAreEqual) {
    double x = 0, y = 0, z = 0;
    for (const CieEntry& entry : kCie) x += entry.x, y += entry.y, z += entry.z;
    EXPECT_NEAR(y * kCieStep, 106.857, 1e-3);
    EXPECT_NEAR(x / y, 1, 1e-4);
    EXPECT_NEAR(z / y, 1, 1e-4);
}

// Equal energy has x = y = 1/3, which in Rec. 709 is a warm white.
TEST(Spectrum, EqualEnergyWhite) { expectNear(spectrumToRgb({{500, 1}}), Rgb(1.205f, 0.948f, 0.909f), 2e-3f); }

TEST(Spectrum, OrderDoesNotMatter) {
    EXPECT_EQ(spectrumToRgb({{700, 1}, {400, 0}, {550, .3f}}), spectrumToRgb({{400, 0}, {550, .3f}, {700, 1}}));
}

TEST(Spectrum, LongWavesAreRed) {
    const Rgb c = spectrumToRgb({{600, 0}, {620, 1}, {700, 1}});
    EXPECT_GT(c.x, 3 * std::max(c.y, c.z));
}

TEST(Spectrum, BlackbodyOfDaylightIsNearlyWhiteAndOfALampWarm) {
    const Rgb day = blackbodyToRgb(6500);
    EXPECT_NEAR(day.x / day.y, 1, 0.07);
    EXPECT_NEAR(day.z / day.y, 1, 0.07);
    const Rgb lamp = blackbodyToRgb(2700);
    EXPECT_GT(lamp.x, 1.5f * lamp.y);
    EXPECT_GT(lamp.y, 1.5f * lamp.z);
    EXPECT_EQ(blackbodyToRgb(0), Rgb(0.f));
}

// Compares with the CIE's chromaticities; illuminant A is a black body of 2856 K.
TEST(Spectrum, BlackbodyHasTheChromaticityOfPlancksLaw) {
    for (const auto& [kelvin, x, y] : {std::tuple(2856.f, 0.4476f, 0.4074f), std::tuple(6500.f, 0.3135f, 0.3237f),
                                       std::tuple(10000.f, 0.2807f, 0.2884f)}) {
        const Vec3 xyz = rgbToXyz(blackbodyToRgb(kelvin));
        const float sum = xyz.x + xyz.y + xyz.z;
        EXPECT_NEAR(xyz.x / sum, x, 1e-3f) << kelvin;
        EXPECT_NEAR(xyz.y / sum, y, 1e-3f) << kelvin;
    }
    // With the maximum scaled to one, luminance is highest where the spectrum peaks near the eye's sensitivity, at
    // about 5200 K.
    EXPECT_NEAR(luminance(blackbodyToRgb(5200)), 0.986f, 0.003f);
    EXPECT_LT(luminance(blackbodyToRgb(1500)), 0.1f);
}

TEST(Spectrum, IsLinearAndNarrowBandsAreThoseOfTheObserver) {
    const Rgb one = spectrumToRgb({{500, 1}, {501, 0}, {499, 0}}), two = spectrumToRgb({{499, 0}, {500, 2}, {501, 0}});
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(two[i], 2 * one[i], 1e-6f);
    const CieEntry at500 = cieAt(500);
    const Vec3 xyz = rgbToXyz(one);
    EXPECT_NEAR(xyz.x / xyz.y, at500.x / at500.y, 1e-3f);
    EXPECT_NEAR(xyz.y, at500.y / 106.857f, 1e-5f);
}

TEST(SpdFile, SaysWhereItIsMalformed) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.spd", "400 1\n500 x\n");
    EXPECT_THAT(errorOf([&] { readSpdFile(path); }), testing::StartsWith(path + ":2:5: expected a number, found 'x'"));
    EXPECT_THAT(errorOf([&] { readSpdFile(folder.write("b.spd", "400 1 500")); }), testing::HasSubstr("has no value"));
}

TEST(Spectrum, ReflectancesAreSeenInDaylight) {
    EXPECT_LT(length(reflectanceToRgb({{400, 0.5f}, {700, 0.5f}}) - Rgb(0.5f)), 1e-5f);
    const Rgb red = reflectanceToRgb({{580, 0}, {620, 1}});
    EXPECT_GT(red.x, 0.8f);
    EXPECT_LT(red.z, 0.05f);
    EXPECT_EQ(reflectanceToRgb({}), Rgb(0.f));
}

TEST(Spectrum, WeightsOfReflectances) {
    for (const std::vector<float>& wavelengths :
         {std::vector<float>{360, 433, 480.5f, 520, 521, 600, 700, 1000}, std::vector<float>{550},
          std::vector<float>{100, 200}, std::vector<float>{400, 500, 600}}) {
        std::vector<SpectrumSample> samples;
        const std::vector<Rgb> weights = reflectanceWeights(wavelengths);
        ASSERT_EQ(weights.size(), wavelengths.size());
        Rgb sum(0.f);
        for (size_t i = 0; i < wavelengths.size(); ++i) {
            samples.push_back({wavelengths[i], 0.2f + 0.1f * float(i * i % 7)});
            sum += weights[i] * samples.back().value;
        }
        expectNear(sum, reflectanceToRgb(samples), 1e-5f);
    }
}

TEST(Spectrum, MayBeZeroBeyondItsEnds) {
    // What is left of a constant spectrum in two parts adds up to it.
    const Rgb whole = spectrumToRgb({{380, 2}, {780, 2}}, Beyond::Zero);
    const Rgb low = spectrumToRgb({{380, 2}, {539.5f, 2}}, Beyond::Zero),
              high = spectrumToRgb({{539.6f, 2}, {780, 2}}, Beyond::Zero);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(low[i] + high[i], whole[i], 1e-5f);
    EXPECT_EQ(whole, spectrumToRgb({{500, 2}, {600, 2}}, Beyond::Constant));
    EXPECT_EQ(spectrumToRgb({{800, 1}, {900, 1}}, Beyond::Zero), Rgb(0.f));
    EXPECT_EQ(spectrumToRgb({{200, 1}, {300, 1}}, Beyond::Zero), Rgb(0.f));
    // A single sample is a narrow band.
    EXPECT_EQ(spectrumToRgb({{500, 3}}, Beyond::Zero), spectrumToRgb({{499, 0}, {500, 3}, {501, 0}}));
    // A reflectance is zero there too, and never negative.
    const Rgb green = reflectanceToRgb({{500, 1}, {560, 1}}, Beyond::Zero);
    EXPECT_GT(green.y, 0.5f);
    EXPECT_EQ(green.x, 0);
    EXPECT_EQ(reflectanceToRgb({{380, 0.5f}, {780, 0.5f}}, Beyond::Zero), reflectanceToRgb({{500, 0.5f}}));
}

TEST(Spectrum, UnitLuminanceStaysInGamut) {
    const Rgb laser = atUnitLuminance(spectrumToRgb({{519, 0}, {520, 1}, {521, 0}}));
    EXPECT_NEAR(luminance(laser), 1, 1e-5f);
    EXPECT_EQ(laser.x, 0);
}

TEST(Spectrum, UnitLuminanceKeepsTheColor) {
    const Rgb c = atUnitLuminance(Rgb(2, 4, 1));
    EXPECT_NEAR(luminance(c), 1, 1e-6f);
    EXPECT_NEAR(c.y / c.x, 2, 1e-5f);
    EXPECT_EQ(atUnitLuminance(Rgb(0.f)), Rgb(0.f));
}

}  // namespace
}  // namespace drc::pbrt
