#include "pbrt/illuminants.h"

#include <gtest/gtest.h>

#include "image/color.h"
#include "pbrt/cie.h"
#include "pbrt/spectrum.h"

namespace drc::pbrt {
namespace {

TEST(Illuminants, TheTableOfD65HasItsChromaticity) {
    double x = 0, y = 0, z = 0;
    for (int nm = kCieFirst; nm <= kCieLast; ++nm) {
        const CieEntry cie = cieAt(float(nm));
        const double power = d65At(float(nm));
        x += power * cie.x;
        y += power * cie.y;
        z += power * cie.z;
    }
    EXPECT_NEAR(x / (x + y + z), 0.3127, 2e-4);
    EXPECT_NEAR(y / (x + y + z), 0.3290, 2e-4);
    EXPECT_EQ(d65At(560), 100);
    EXPECT_NEAR(d65At(435), 95.7736, 1e-3);  // the standard's own value at 5 nm
}

TEST(Illuminants, HaveUnitLuminanceAndTheirColor) {
    for (const char* name : {"stdillum-A", "stdillum-D50", "stdillum-F1", "stdillum-F12", "illum-acesD60"}) {
        ASSERT_TRUE(illuminantNamed(name)) << name;
        EXPECT_NEAR(luminance(*illuminantNamed(name)), 1, 1e-3f) << name;
    }
    EXPECT_LT(length(*illuminantNamed("stdillum-D65") - Rgb(1.f)), 1e-3f);
    // Illuminant A is a black body of 2856 K.
    EXPECT_LT(length(*illuminantNamed("stdillum-A") - atUnitLuminance(blackbodyToRgb(2856))), 5e-3f);
    EXPECT_FALSE(illuminantNamed("stdillum-D66"));
}

// The correlated colour temperatures of CIE 15, by McCamy's approximation ("Correlated Color Temperature as an Explicit
// Function of Chromaticity Coordinates", Color Res. Appl. 17, 1992).
TEST(Illuminants, HaveTheirTemperature) {
    const std::pair<const char*, double> kAll[] = {
        {"stdillum-A", 2856},   {"stdillum-D50", 5003}, {"stdillum-D65", 6504}, {"stdillum-F1", 6430},
        {"stdillum-F2", 4230},  {"stdillum-F3", 3450},  {"stdillum-F4", 2940},  {"stdillum-F5", 6350},
        {"stdillum-F6", 4150},  {"stdillum-F7", 6500},  {"stdillum-F8", 5000},  {"stdillum-F9", 4150},
        {"stdillum-F10", 5000}, {"stdillum-F11", 4000}, {"stdillum-F12", 3000}, {"illum-acesD60", 6000}};
    for (const auto& [name, kelvin] : kAll) {
        const Vec3 xyz = rgbToXyz(illuminantNamed(name).value());
        const double sum = double(xyz.x + xyz.y + xyz.z), x = double(xyz.x) / sum, y = double(xyz.y) / sum;
        const double n = (x - 0.3320) / (0.1858 - y);
        EXPECT_NEAR(449 * n * n * n + 3525 * n * n + 6823.3 * n + 5520.33, kelvin, 0.01 * kelvin) << name;
    }
}

}  // namespace
}  // namespace drc::pbrt
