// The material "principled" in whole scenes: what it does besides scattering light.
#include <gtest/gtest.h>

#include "pictures.h"

namespace drc {
namespace {

// A ball on a floor under a lamp, seen from the front.
std::string scene(const std::string& ball, bool lit = true) {
    const std::string lamp =
        lit ? "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [6 6 6]\nTranslate 0.5 -1 2.5\n"
              "Shape \"sphere\" \"float radius\" 0.3\nAttributeEnd\n"
            : "";
    return "Integrator \"path\" \"integer maxdepth\" 8\nLookAt 0 -4 1  0 0 .4  0 0 1\nCamera \"perspective\" "
           "\"float fov\" 35\nFilm \"image\" \"integer xresolution\" 16 \"integer yresolution\" 8\nWorldBegin\n" +
           lamp + "Material \"matte\" \"rgb Kd\" [.5 .5 .5]\nShape \"disk\" \"float radius\" 3\nTranslate 0 0 .6\n" +
           ball + "WorldEnd\n";
}
const std::string kBall = "\nShape \"sphere\" \"float radius\" .5\n";

void expectSame(const std::string& a, const std::string& b, const char* integrator) {
    SCOPED_TRACE(integrator);
    const test::Estimate x = test::estimateOfMeans(test::pictures(a, integrator, 12, 32));
    const test::Estimate y = test::estimateOfMeans(test::pictures(b, integrator, 12, 32));
    for (size_t c = 0; c < 3; ++c) {
        const double sigma = std::sqrt(x.variance[c] + y.variance[c]);
        EXPECT_NEAR(x.mean[c], y.mean[c], 5 * sigma + 1e-6);
        EXPECT_LT(sigma, 0.02 * x.mean[c]);
    }
}

TEST(PrincipledInScenes, EmissionIsThatOfATwoSidedAreaLight) {
    const std::string grey = "Material \"principled\" \"rgb basecolor\" [.5 .5 .5] \"float specularlevel\" 0 ";
    for (const char* integrator : {"path", "bdpt", "drc"})
        expectSame(
            scene(grey + "\"rgb emission\" [1 .5 .25] \"float emissionstrength\" 4" + kBall, false),
            scene("AreaLightSource \"diffuse\" \"rgb L\" [4 2 1] \"bool twosided\" \"true\"\n" + grey + kBall, false),
            integrator);
    // An area light that the file gives to the shape counts in its place.
    expectSame(scene("AreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\n" + grey + "\"float emissionstrength\" 9" + kBall),
               scene("AreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\n" + grey + kBall), "path");
}

// Emission by a texture is sampled where it is: half of the ball, divided by u.
TEST(PrincipledInScenes, EmissionByATexture) {
    const std::string texture =
        "Texture \"half\" \"color\" \"checkerboard\" \"float uscale\" 2 \"float vscale\" 1 \"rgb tex1\" [0 0 0] "
        "\"rgb tex2\" [4 3 2] \"string aamode\" \"none\"\n";
    const std::string black = "Material \"principled\" \"rgb basecolor\" [0 0 0] \"float specularlevel\" 0 ";
    const std::string half =
        "Rotate 180 0 0 1\n"
        "AreaLightSource \"diffuse\" \"rgb L\" [4 3 2] \"bool twosided\" \"true\"\n"
        "Material \"matte\" \"rgb Kd\" [0 0 0]\n"
        "Shape \"sphere\" \"float radius\" .5 \"float phimax\" 180\n"
        "AreaLightSource \"diffuse\" \"rgb L\" [0 0 0]\nRotate 180 0 0 1\n"
        "Shape \"sphere\" \"float radius\" .5 \"float phimax\" 180\n";
    for (const char* integrator : {"path", "bdpt", "drc"})
        expectSame(scene(texture + black + "\"texture emission\" \"half\" \"float emissionstrength\" 1" + kBall, false),
                   scene(half, false), integrator);
}

TEST(PrincipledInScenes, AlphaIsTheShareOfTheSurface) {
    // A ball of which rays meet nothing, and one of which they meet all.
    const std::string red = "Material \"principled\" \"rgb basecolor\" [.8 .1 .1] ";
    for (const char* integrator : {"path", "bdpt", "drc"}) {
        expectSame(scene(red + "\"float alpha\" 0" + kBall), scene(""), integrator);
        expectSame(scene(red + "\"float alpha\" 1" + kBall), scene(red + kBall), integrator);
        // Two sheets of alpha .5, one behind the other, hide as much as one of .75.
        const std::string sheet = "\"float specularlevel\" 0 \"float alpha\" ";
        const std::string disk = "\nRotate 90 1 0 0\nShape \"disk\" \"float radius\" .5\n";
        const std::string black = "Material \"principled\" \"rgb basecolor\" [0 0 0] ";
        expectSame(scene(black + sheet + ".5" + disk + "Translate 0 0 .0001\nShape \"disk\" \"float radius\" .5\n"),
                   scene(black + sheet + ".75" + disk), integrator);
    }
    // The shape's own mask counts, too.
    expectSame(scene(red + "\"float alpha\" .5\nShape \"sphere\" \"float radius\" .5 \"float alpha\" 0\n"), scene(""),
               "path");
}

}  // namespace
}  // namespace drc
