// Surfaces with holes for shadows alone (pbrt's shadowalpha): light samples pass through them, paths do not.
#include <gtest/gtest.h>

#include "pictures.h"

namespace drc {
namespace {

constexpr const char* kIntegrators[] = {"path", "direct", "bdpt", "drc"};

std::string scene(const std::string& lamp, const std::string& sheet, int maxDepth) {
    return "Integrator \"path\" \"integer maxdepth\" " + std::to_string(maxDepth) +
           "\nLookAt 0 -4 .4  0 0 0  0 0 1\nCamera \"perspective\" \"float fov\" 40\n"
           "Film \"image\" \"integer xresolution\" 16 \"integer yresolution\" 8\nWorldBegin\nAttributeBegin\n" +
           lamp + "AttributeEnd\nMaterial \"matte\" \"rgb Kd\" [.5 .5 .5]\nShape \"disk\" \"float radius\" 3\n" +
           "Translate 0 0 1.5\nMaterial \"matte\" \"rgb Kd\" [0 0 0]\n" + sheet + "WorldEnd\n";
}
const std::string kWide =
    "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\nTranslate 0 0 2\nRotate 180 1 0 0\n"
    "Shape \"disk\" \"float radius\" 2\n";
const std::string kSky = "LightSource \"infinite\" \"rgb L\" [1 1 1]\n";
const std::string kPoint = "LightSource \"point\" \"point from\" [0 0 2]\n";
const std::string kSheet = "Shape \"disk\" \"float radius\" 3 \"float shadowalpha\" 0\n";

test::Estimate seen(const std::string& text, const std::string& integrator) {
    return test::estimateOfMeans(test::pictures(text, integrator, 12, 32));
}

// A lamp so wide that BSDF sampling would find most of its light, which the sheet keeps from it.
TEST(ShadowMasks, LetAllOfALampsLightThrough) {
    for (const std::string& lamp : {kWide, kPoint})
        for (const char* integrator : kIntegrators) {
            SCOPED_TRACE(std::string(integrator) + lamp);
            test::expectSameMeans(seen(scene(lamp, "", 1), integrator), seen(scene(lamp, kSheet, 1), integrator));
        }
}

TEST(ShadowMasks, AreTheSameToEveryIntegrator) {
    for (const std::string& lamp : {kWide, kSky, kPoint}) {
        const std::string text = scene(lamp, "Material \"matte\" \"rgb Kd\" [.7 .7 .7]\n" + kSheet, 6);
        const test::Estimate expected = seen(text, "path");
        for (const char* integrator : {"bdpt", "drc"}) {
            SCOPED_TRACE(std::string(integrator) + lamp);
            test::expectSameMeans(expected, seen(text, integrator));
        }
    }
}

}  // namespace
}  // namespace drc
