#include "pbrt/glass_spectra.h"

#include <gtest/gtest.h>

namespace drc::pbrt {
namespace {

float at(const std::vector<SpectrumSample>& samples, float nm) {
    for (size_t i = 1; i < samples.size(); ++i)
        if (samples[i].wavelength >= nm) {
            const SpectrumSample &a = samples[i - 1], &b = samples[i];
            return a.value + (b.value - a.value) * (nm - a.wavelength) / (b.wavelength - a.wavelength);
        }
    return 0;
}

// Compares with the catalogue's index at the d line, 587.56 nm, and its Abbe number.
TEST(GlassSpectra, AreTheCataloguesGlasses) {
    const struct {
        const char* name;
        float nd, abbe;
    } kAll[] = {{"glass-BK7", 1.5168f, 64.17f},    {"glass-BAF10", 1.67003f, 47.11f}, {"glass-FK51A", 1.48656f, 84.47f},
                {"glass-LASF9", 1.85025f, 32.17f}, {"glass-F5", 1.67271f, 32.25f},    {"glass-F10", 1.72828f, 28.53f},
                {"glass-F11", 1.78472f, 25.68f}};
    for (const auto& [name, nd, abbe] : kAll) {
        const auto samples = glassSpectrum(name);
        ASSERT_TRUE(samples) << name;
        EXPECT_NEAR(at(*samples, 587.56f), nd, 5e-4f) << name;
        EXPECT_NEAR((at(*samples, 587.56f) - 1) / (at(*samples, 486.13f) - at(*samples, 656.27f)), abbe, 0.01f * abbe)
            << name;
    }
    EXPECT_TRUE(glassSpectrum("glass-SF11"));
    for (const char* name : {"BK7", "glass-", "glass-K7", "metal-Au-eta", "glass-BK", "glass-AF10"})
        EXPECT_FALSE(glassSpectrum(name)) << name;
}

}  // namespace
}  // namespace drc::pbrt
