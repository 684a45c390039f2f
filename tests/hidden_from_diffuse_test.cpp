// Surfaces that only the camera, mirrors and smooth glass see ("bool visibletodiffuse" false), such as panes of
// windows.
#include <gtest/gtest.h>

#include "hidden_scenes.h"
#include "pictures.h"

namespace drc {
namespace {

const std::string kHidden = R"( "bool visibletodiffuse" "false")";

// A floor, a mirror to its left, and what stands on it.
std::string scene(const std::string& lights, const std::string& objects, int maxDepth) {
    return test::floorScene("LookAt 0 -4 2.4  0 0 .4  0 0 1", lights, objects, maxDepth);
}
using test::kLampAbove;
using test::kSkyAround;
const std::string kPoint = "LightSource \"point\" \"rgb I\" [4 4 4] \"point from\" [0.3 0 2.6]\n";
const std::string kMirror =
    "Material \"mirror\" \"rgb Kr\" [.9 .9 .9]\nShape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] "
    "\"point P\" [-1.6 -1 0 -1.6 1.5 0 -1.6 1.5 2 -1.6 -1 2]\n";
const std::string kGlass = "Material \"glass\"\n";
const std::string kFrosted = "Material \"glass\" \"float uroughness\" .3 \"float vroughness\" .3\n";
const std::string kRed = "Material \"matte\" \"rgb Kd\" [.8 .1 .1]\n";

// A sphere, whose own code finds it, or a sheet that Embree finds.
std::string ball(const std::string& material, const std::string& parameters) {
    return "AttributeBegin\n" + material + "Translate .2 -.2 .8\nShape \"sphere\" \"float radius\" .6" + parameters +
           "\nAttributeEnd\n";
}
std::string sheet(const std::string& material, const std::string& parameters) {
    return "AttributeBegin\n" + material +
           "Translate 0 0 1\nShape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] "
           "\"point P\" [-1.2 -1 0  1.2 -1 0  1.2 1 .2  -1.2 1 .2]" +
           parameters + "\nAttributeEnd\n";
}

test::Estimate seen(const std::string& text, const std::string& integrator, int spp = 64) {
    return test::estimateOfMeans(test::pictures(text, integrator, 16, spp));
}

// A surface that the camera does not see either is not there.
TEST(HiddenFromDiffuse, SurfacesCastNoShadowAndReflectNothing) {
    for (const std::string& light : {kLampAbove, kSkyAround, kPoint})
        for (const char* integrator : {"path", "direct", "bdpt", "drc"}) {
            SCOPED_TRACE(integrator + light);
            const std::string gone = kHidden + " \"bool visibletocamera\" \"false\"";
            test::expectSameMeans(seen(scene(light, "", 4), integrator),
                                  seen(scene(light, ball(kRed, gone) + sheet(kRed, gone), 4), integrator));
        }
}

// The pane's reflections come and go, and what it would do to the light of the floor does not: no caustics are added to
// the light that the shadow rays find.
TEST(HiddenFromDiffuse, SurfacesAreTheSameToEveryIntegrator) {
    for (const std::string& light : {kLampAbove, kSkyAround, kPoint})
        for (const std::string& material : {kGlass, kFrosted, kRed}) {
            const std::string text = scene(light, kMirror + ball(material, kHidden) + sheet(material, kHidden), 6);
            const test::Estimate expected = seen(text, "path");
            for (const char* integrator : {"bdpt", "drc"}) {
                SCOPED_TRACE(integrator + light + material);
                test::expectSameMeans(expected, seen(text, integrator));
            }
        }
}

TEST(HiddenFromDiffuse, MirrorsAndTheCameraSeeThem) {
    const std::string black = "Material \"matte\" \"rgb Kd\" [0 0 0]\n";
    const std::string open = kHidden + " \"bool visibletocamera\" \"false\"";
    const auto mean = [&](const std::string& objects) { return seen(scene(kSkyAround, objects, 4), "path", 512); };
    const test::Estimate none = mean(kMirror), mirrored = mean(kMirror + ball(black, open)),
                         both = mean(kMirror + ball(black, kHidden));
    const auto apart = [](const test::Estimate& a, const test::Estimate& b) {
        return (a.mean[0] - b.mean[0]) / std::sqrt(a.variance[0] + b.variance[0]);
    };
    EXPECT_GT(apart(none, both), 20);
    EXPECT_GT(apart(mirrored, both), 20);
    // Not the camera, but the mirror, if only the camera's view is open.
    EXPECT_GT(apart(none, mirrored), 8);
}

}  // namespace
}  // namespace drc
