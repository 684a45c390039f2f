#include "pbrt/named_spectra.h"

#include <gtest/gtest.h>

namespace drc::pbrt {
namespace {

float at(const std::vector<SpectrumSample>& samples, float nm) {
    for (size_t i = 1; i < samples.size(); ++i)
        if (samples[i].wavelength >= nm) {
            const SpectrumSample &a = samples[i - 1], &b = samples[i];
            return a.value + (b.value - a.value) * (nm - a.wavelength) / (b.wavelength - a.wavelength);
        }
    return samples.back().value;
}

TEST(NamedSpectra, AllThatPbrtHasBuiltIn) {
    for (const std::string metal : {"Ag", "Al", "Au", "Cu", "CuZn", "MgO", "TiO2"})
        for (const std::string part : {"eta", "k"}) EXPECT_TRUE(namedIndex("metal-" + metal + "-" + part)) << metal;
    for (const std::string glass : {"BK7", "BAF10", "FK51A", "LASF9", "F5", "F10", "F11"})
        EXPECT_TRUE(namedIndex("glass-" + glass)) << glass;
    for (const char* name : {"metal-MgO", "metal-MgO-n", "metal-Zn-k", "MgO-eta", "glass-K7", ""})
        EXPECT_FALSE(namedIndex(name)) << name;
}

// The index at the d line, and the Abbe number, of the database of refractiveindex.info.
TEST(NamedSpectra, OxidesHaveTheirDispersion) {
    const struct {
        const char* name;
        float nd, abbe;
    } kAll[] = {{"MgO", 1.7375f, 53.5f}, {"TiO2", 2.6142f, 9.87f}};
    for (const auto& [name, nd, abbe] : kAll) {
        const std::string metal = std::string("metal-") + name;
        const auto samples = namedIndex(metal + "-eta").value();
        EXPECT_NEAR(at(samples, 587.56f), nd, 1e-3f) << name;
        EXPECT_NEAR((at(samples, 587.56f) - 1) / (at(samples, 486.13f) - at(samples, 656.27f)), abbe, 0.01f * abbe)
            << name;
        EXPECT_EQ(at(namedIndex(metal + "-k").value(), 500), 0);
    }
}

}  // namespace
}  // namespace drc::pbrt
