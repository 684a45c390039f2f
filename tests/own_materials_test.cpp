// Parameters of materials that are DRC's own: "diffuseroughness" of "diffuse" and "principled", "reflectiontint" of the
// latter.
#include <gtest/gtest.h>

#include "pictures.h"

namespace drc {
namespace {

constexpr const char* kIntegrators[] = {"path", "bdpt", "drc"};
const std::string kEvenSky = "LightSource \"infinite\" \"rgb L\" [1 1 1]\n";
const std::string kSun = "LightSource \"distant\" \"rgb L\" [3 3 3] \"point3 from\" [2 -1 1.5]\n";
const std::string kBall = "Shape \"sphere\"\n";
const std::string kSheet = "Shape \"disk\" \"float radius\" 9\n";

// Seen along the normal of the sheet.
std::string scene(const std::string& light, const std::string& material, const std::string& shape) {
    return "Integrator \"path\" \"integer maxdepth\" 12\nLookAt 0 0 4  0 0 0  0 1 0\n"
           "Camera \"perspective\" \"float fov\" 12\n"
           "Film \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 8\nWorldBegin\n" +
           light + material + "\n" + shape;
}
test::Estimate seen(const std::string& text, const std::string& integrator) {
    return test::estimateOfMeans(test::pictures(text, integrator, 16, 32));
}

// All light that a white surface gets comes back, however rough it is.
TEST(OwnMaterials, RoughWhiteIsInvisibleInAnEvenSky) {
    for (const char* roughness : {".2", "1"})
        for (const std::string& material :
             {std::string("Material \"diffuse\" \"rgb reflectance\" [1 1 1] \"float diffuseroughness\" "),
              std::string("Material \"principled\" \"rgb basecolor\" [1 1 1] \"float specularlevel\" 0 "
                          "\"float diffuseroughness\" ")})
            for (const char* integrator : kIntegrators) {
                SCOPED_TRACE(integrator + material + roughness);
                const test::Estimate e = seen(scene(kEvenSky, material + roughness, kBall), integrator);
                for (int c = 0; c < 3; ++c) EXPECT_NEAR(e.mean[c], 1, 0.01);
            }
}

TEST(OwnMaterials, ARoughBaseIsTheRoughDiffuse) {
    const auto diffuse = [](const std::string& roughness) {
        return scene(
            kSun, "Material \"diffuse\" \"rgb reflectance\" [.8 .4 .2] \"float diffuseroughness\" " + roughness, kBall);
    };
    const std::string principled =
        scene(kSun,
              "Material \"principled\" \"rgb basecolor\" [.8 .4 .2] \"float specularlevel\" 0 "
              "\"float diffuseroughness\" .9",
              kBall);
    for (const char* integrator : kIntegrators) {
        SCOPED_TRACE(integrator);
        const test::Estimate rough = seen(diffuse(".9"), integrator), smooth = seen(diffuse("0"), integrator);
        test::expectSameMeans(rough, seen(principled, integrator));
        // From beside the sun, rough surfaces are darker.
        for (int c = 0; c < 3; ++c) EXPECT_LT(rough.mean[c], 0.97 * smooth.mean[c]);
    }
}

// Along the normal, glass of index 1.5 reflects 4 %.
TEST(OwnMaterials, ReflectionsOfGlassMayBeTinted) {
    for (const char* roughness : {"0", ".2"}) {
        const std::string glass =
            std::string("Material \"principled\" \"rgb basecolor\" [1 1 1] \"float transmission\" 1 ") +
            "\"rgb reflectiontint\" [0 .5 1] \"float roughness\" " + roughness;
        for (const char* integrator : kIntegrators) {
            SCOPED_TRACE(integrator + glass);
            const test::Estimate e = seen(scene(kEvenSky, glass, kSheet), integrator);
            // Radiance that comes out of the glass has been wider inside, by the square of the index.
            const double tints[] = {0, 0.5, 1};
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(e.mean[c], 0.04 * tints[c] + 0.96 / 2.25, 2e-3);
        }
    }
}

}  // namespace
}  // namespace drc
