// Normal maps and stochastic alpha of pbrt-v4 in whole pictures.
#include <gtest/gtest.h>

#include "base/folder_testing.h"
#include "image/image_io.h"
#include "pictures.h"

namespace drc {
namespace {

constexpr const char* kIntegrators[] = {"path", "direct", "bdpt", "drc"};

std::string scene(const std::string& world) {
    return "LookAt 0 0 3  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 10\nPixelFilter \"box\"\n"
           "Film \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 8\nWorldBegin\n" +
           world;
}
std::string square(const std::string& uv, const std::string& more) {
    return "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] \"point3 P\" [-1 -1 0 1 -1 0 1 1 0 -1 1 0] "
           "\"point2 uv\" [" +
           uv + "] " + more + "\n";
}

// A map whose normals all lean by .48 towards increasing u and .36 towards increasing v, on a floor under a light from
// that side: as bright as a floor that leans. Also where u is mirrored, and where u and v are exchanged.
TEST(NormalMaps, LightALeaningFloor) {
    const TemporaryFolder folder;
    Image image(2, 2);
    for (int i = 0; i < 4; ++i) image.setRgb(i % 2, i / 2, Rgb(0.74f, 0.68f, 0.9f));
    writeExr(folder.path() + "/map.exr", image);
    const struct {
        const char *uv, *light;
    } cases[] = {
        {"0 0 1 0 1 1 0 1", "[48 36 80]"}, {"1 0 0 0 0 1 1 1", "[-48 36 80]"}, {"0 0 0 1 1 1 1 0", "[36 48 80]"}};
    for (const auto& c : cases)
        for (const char* integrator : kIntegrators) {
            const auto loaded = pbrt::loadPbrtString(
                scene(std::string("LightSource \"distant\" \"rgb L\" [1 1 1] \"point3 from\" ") + c.light +
                      "\nMaterial \"diffuse\" \"rgb reflectance\" [.5 .5 .5] \"string normalmap\" \"map.exr\"\n" +
                      square(c.uv, "")),
                folder.path());
            const auto seen = test::pictures(*loaded, {.integrator = integrator, .count = 1, .spp = 16});
            // The light falls perpendicularly on the normals of the map.
            for (const Rgb& block : seen[0]) EXPECT_NEAR(block.x, 0.5f / kPi, 0.002f) << integrator << c.uv;
        }
}

// A share of the rays passes, for the camera as for shadows.
TEST(Alpha, IsTheShareOfRaysThatHit) {
    const std::string veil = "AttributeBegin\nMaterial \"diffuse\" \"rgb reflectance\" [0 0 0]\nTranslate 0 0 1\n" +
                             square("0 0 1 0 1 1 0 1", "\"float alpha\" .3") + "AttributeEnd\n";
    const std::string floor = "Material \"diffuse\" \"rgb reflectance\" [.5 .5 .5]\n" + square("0 0 1 0 1 1 0 1", "");
    const auto expectMean = [&](const std::string& world, double expected) {
        for (const char* integrator : kIntegrators) {
            const auto estimate = test::estimateOfMeans(test::pictures(scene(world), integrator, 8, 64));
            const double sigma = std::sqrt(estimate.variance[0]);
            EXPECT_NEAR(estimate.mean[0], expected, 5 * sigma + 1e-4) << integrator;
            EXPECT_LT(sigma, 0.02 * expected);
        }
    };
    expectMean("LightSource \"infinite\" \"rgb L\" [1 1 1]\n" + veil, 0.7);
    // Through the veil from above, and again on the way to the camera.
    expectMean("LightSource \"distant\" \"rgb L\" [1 1 1] \"point3 from\" [0 0 2]\n" + veil + floor,
               0.7 * 0.7 * 0.5 / std::numbers::pi);
    // Two veils, one behind the other, let their product through.
    expectMean("LightSource \"infinite\" \"rgb L\" [1 1 1]\n" + veil + "Translate 0 0 .5\n" + veil, 0.49);
}

}  // namespace
}  // namespace drc
