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

}  // namespace
}  // namespace drc::pbrt
