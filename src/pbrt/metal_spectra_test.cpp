#include "pbrt/metal_spectra.h"

#include <gmock/gmock.h>

#include "base/log.h"
#include "pbrt/test_scenes.h"
#include "scene/materials/conductor_textures.h"

namespace drc::pbrt {
namespace {

Rgb colorOf(const std::string& symbol, const std::string& what) {
    return spectrumToRgb(metalSpectrum(symbol + "." + what + ".spd").value());
}
Rgb reflectanceOf(const std::string& symbol) {
    return fresnelConductor(1, colorOf(symbol, "eta"), colorOf(symbol, "k"));
}

TEST(MetalSpectra, Names) {
    for (const std::string name : {"Au.k.spd", "spds/metals/Au.k.spd", "metal-Au-k"}) {
        const auto spectrum = metalSpectrum(name);
        ASSERT_TRUE(spectrum) << name;
        EXPECT_EQ(spectrum->at(12).value, 3.697f);
    }
    EXPECT_EQ(metalSpectrum("metal-Au-eta")->at(12).value, 0.14f);
    for (const std::string name : {"Au.spd", "Au", "xAu.k.spd", "metal-Xx-k", "spds/metal-Au-k", "Au.k.spd/", ""})
        EXPECT_FALSE(metalSpectrum(name)) << name;
}

TEST(MetalSpectra, CoverTheVisibleInOrder) {
    for (const std::string symbol : {"Ag", "Al", "Au", "Co", "Cr", "Cu", "CuZn", "Fe", "Ni", "Ti"}) {
        const auto eta = metalSpectrum(symbol + ".eta.spd").value();
        EXPECT_LE(eta.front().wavelength, 380);
        EXPECT_GE(eta.back().wavelength, 780);
        for (size_t i = 1; i < eta.size(); ++i) EXPECT_GT(eta[i].wavelength, eta[i - 1].wavelength);
    }
}

// The metal material's default is pbrt's copper, from other measurements.
TEST(MetalSpectra, CopperIsTheMaterialsDefault) {
    const Rgb eta = colorOf("Cu", "eta"), k = colorOf("Cu", "k"), here = reflectanceOf("Cu");
    const Rgb there = fresnelConductor(1, kCopperEta, kCopperK);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(eta[c], kCopperEta[c], 0.2f) << c;
        EXPECT_NEAR(k[c], kCopperK[c], 0.3f) << c;
        EXPECT_NEAR(here[c], there[c], 0.05f) << c;
    }
}

TEST(MetalSpectra, HaveTheirColours) {
    const Rgb gold = reflectanceOf("Au"), silver = reflectanceOf("Ag"), aluminium = reflectanceOf("Al");
    EXPECT_GT(gold.x, 0.9f);
    EXPECT_LT(gold.z, 0.55f);
    for (int c = 0; c < 3; ++c) {
        EXPECT_GT(silver[c], 0.9f);
        EXPECT_NEAR(aluminium[c], 0.91f, 0.03f);
    }
    // Brass is yellow.
    const Rgb brass = reflectanceOf("CuZn");
    EXPECT_GT(brass.x, 0.85f);
    EXPECT_GT(brass.y, 0.65f);
    EXPECT_LT(brass.z, 0.6f);
    for (const std::string symbol : {"Co", "Cr", "Fe", "Ni", "Ti"}) {
        EXPECT_GT(reflectanceOf(symbol).y, 0.4f) << symbol;
        EXPECT_LT(reflectanceOf(symbol).y, 0.75f) << symbol;
    }
}

TEST(MetalSpectra, StandInForFilesThatAreMissing) {
    const TemporaryFolder folder;
    folder.write("Cu.eta.spd", "400 1\n700 1\n");
    const auto warningsOf = [&](const std::string& names) {
        forgetWarnings();
        loadWorld("Material \"metal\" " + names, folder.path());
        return warningCount();
    };
    EXPECT_EQ(warningsOf(R"("spectrum eta" "Cu.eta.spd" "spectrum k" "metal-Cu-k")"), 0);
    EXPECT_EQ(warningsOf(R"("spectrum eta" "spds/Au.eta.spd" "spectrum k" "spds/Au.k.spd")"), 2);
    EXPECT_THAT(errorOfWorld("Material \"metal\" \"spectrum eta\" \"Xx.eta.spd\"", folder.path()),
                testing::HasSubstr("cannot find the spectrum file 'Xx.eta.spd'"));
}

}  // namespace
}  // namespace drc::pbrt
