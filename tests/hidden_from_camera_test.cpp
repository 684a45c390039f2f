// What the camera does not see: surfaces ("bool visibletocamera"), lamps that block no light ("bool blockslight"),
// lights with a radius, the sky; and a sky that it alone sees ("bool illuminates").
#include <gtest/gtest.h>

#include "hidden_scenes.h"
#include "pictures.h"

namespace drc {
namespace {

constexpr const char* kIntegrators[] = {"path", "direct", "bdpt", "drc"};
const std::string kHidden = R"( "bool visibletocamera" "false")";

// A floor and, to the left, a wall that is a mirror.
std::string scene(const std::string& lights, const std::string& objects, int maxDepth) {
    return test::floorScene("LookAt 0 -4 1.4  0 0 .6  0 0 1", lights, objects, maxDepth);
}
using test::kLampAbove;
using test::kSkyAround;
const std::string kHiddenSky = "LightSource \"infinite\" \"rgb L\" [1 1 1]" + kHidden + "\n";
const std::string kMirror =
    "Material \"metal\" \"float roughness\" .1\n"
    "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] \"point P\" [-1.5 -1 0 -1.5 1.5 0 -1.5 1.5 2 -1.5 -1 "
    "2]\n";
std::string ball(const std::string& parameters) {
    return "AttributeBegin\nMaterial \"matte\" \"rgb Kd\" [.8 .1 .1]\nTranslate -.3 -.3 .7\n"
           "Shape \"sphere\" \"float radius\" .6" +
           parameters + "\nAttributeEnd\n";
}

test::Estimate seen(const std::string& text, const std::string& integrator) {
    return test::estimateOfMeans(test::pictures(text, integrator, 16, 64));
}

// Direct light alone, and without a shadow.
TEST(HiddenFromCamera, SurfacesLeaveWhatIsBehindThem) {
    for (const std::string& light : {kLampAbove, kSkyAround})
        for (const char* integrator : kIntegrators) {
            SCOPED_TRACE(integrator + light);
            // The camera looks through a surface without a material, too.
            const std::string open =
                "AttributeBegin\nMaterial \"\"\nTranslate 0 -2 1\nShape \"sphere\" \"float radius\" .8\nAttributeEnd\n";
            const std::string shadowless = open + ball(kHidden + " \"float shadowalpha\" 0");
            // The sky is behind the ball, so that paths from the floor must not meet it either.
            const std::string floor = light == kSkyAround ? "" : shadowless;
            test::expectSameMeans(seen(scene(light, "", 1), integrator), seen(scene(light, floor, 1), integrator));
        }
}

TEST(HiddenFromCamera, SurfacesAreTheSameToEveryIntegrator) {
    for (const std::string& light : {kLampAbove, kSkyAround, kHiddenSky}) {
        const std::string text = scene(light, kMirror + ball(kHidden), 6);
        const test::Estimate expected = seen(text, "path");
        for (const char* integrator : {"bdpt", "drc"}) {
            SCOPED_TRACE(integrator + light);
            test::expectSameMeans(expected, seen(text, integrator));
        }
        // It is not as if it were not there, or as if it were seen.
        for (const std::string& other : {std::string(), ball("")}) {
            const test::Estimate e = seen(scene(light, kMirror + other, 6), "path");
            EXPECT_GT(std::abs(e.mean[0] - expected.mean[0]), 8 * std::sqrt(e.variance[0] + expected.variance[0]));
        }
    }
}

// A hidden lamp that blocks no light is what a light with a radius is, sample by sample.
TEST(HiddenFromCamera, LightsWithARadiusAreLampsThatBlockNoLight) {
    const std::string light = "LightSource \"point\" \"rgb I\" [3 2 1] \"point from\" [.2 .1 2] \"float radius\" .5\n";
    // I = L pi r^2.
    const std::string lamp =
        "AttributeBegin\nTranslate .2 .1 2\nAreaLightSource \"diffuse\" \"rgb L\" [3.8197186 2.5464791 1.2732395]\n"
        "Shape \"sphere\" \"float radius\" .5 \"bool blockslight\" \"false\"" +
        kHidden + "\nAttributeEnd\n";
    // So small that it is a point.
    const std::string small =
        "LightSource \"point\" \"rgb I\" [3 2 1] \"point from\" [.2 .1 2] \"float radius\" .001\n";
    const std::string point = "LightSource \"point\" \"rgb I\" [3 2 1] \"point from\" [.2 .1 2]\n";
    for (const char* integrator : kIntegrators) {
        SCOPED_TRACE(integrator);
        test::expectSameMeans(seen(scene(light, ball(""), 3), integrator), seen(scene(lamp, ball(""), 3), integrator));
        test::expectSameMeans(seen(scene(point, ball(""), 3), integrator), seen(scene(small, ball(""), 3), integrator));
    }
}

// Behind it the light of the others goes on.
TEST(HiddenFromCamera, LampsThatBlockNoLightCastNoShadow) {
    const std::string dark =
        "AttributeBegin\nTranslate 0 0 1\nAreaLightSource \"diffuse\" \"rgb L\" [1e-6 0 0]\n"
        "Shape \"sphere\" \"float radius\" .8 \"bool blockslight\" \"false\"" +
        kHidden + "\nAttributeEnd\n";
    for (const char* integrator : kIntegrators) {
        SCOPED_TRACE(integrator);
        test::expectSameMeans(seen(scene(kLampAbove + kSkyAround, "", 3), integrator),
                              seen(scene(kLampAbove + kSkyAround + dark, "", 3), integrator));
    }
}

// The camera looks past the floor into black, and the floor is as bright as ever.
TEST(HiddenFromCamera, TheSkyLightsTheFloorAlone) {
    const auto picture = [](const std::string& sky, const std::string& integrator) {
        auto scene = pbrt::loadPbrtString(drc::scene(sky, "", 3), ".", {}, "sky.pbrt");
        RenderParams params;
        params.integrator = integrator;
        params.spp = 16;
        Session session(*scene, params);
        while (session.step()) {
        }
        return session.picture().beauty;
    };
    const std::string sun = "LightSource \"distant\" \"rgb L\" [.5 .5 .5] \"point from\" [0 4 .3] \"float angle\" 30";
    for (const char* integrator : kIntegrators) {
        SCOPED_TRACE(integrator);
        const Image seen = picture(kSkyAround + sun + "\n", integrator),
                    hidden = picture(kHiddenSky + sun + kHidden + "\n", integrator);
        int black = 0, lit = 0;
        for (int y = 0; y < seen.height(); ++y)
            for (int x = 0; x < seen.width(); ++x) {
                if (y == 0) {
                    EXPECT_GE(seen.rgb(x, y).x, 1);
                    EXPECT_TRUE(isBlack(hidden.rgb(x, y))) << x;
                    ++black;
                } else if (y >= 5 && x >= 3 && x < 13) {
                    EXPECT_NEAR(hidden.rgb(x, y).x, seen.rgb(x, y).x, 0.1);
                    lit += hidden.rgb(x, y).x > 0.3f;
                }
            }
        EXPECT_EQ(black, 16);
        EXPECT_EQ(lit, 30);
    }
}

// One sky and one sun light the scene, and the camera sees two others, also through a surface without a material: where
// it sees them alone, with a black floor, the picture is theirs, and where they are hidden, it is that of the others.
TEST(HiddenFromCamera, SkiesThatLightNothingAreSeenByTheCameraAlone) {
    const std::string sun = "LightSource \"distant\" \"point from\" [0 3 1] \"float angle\" 60 \"rgb L\" ";
    const std::string backdrop = "LightSource \"infinite\" \"rgb L\" [3 1 2] \"bool illuminates\" \"false\"\n" + sun +
                                 "[1 .5 .2] \"bool illuminates\" \"false\"\n";
    const std::string lit = kHiddenSky + sun + "[.4 .4 .2]" + kHidden + "\n";
    const std::string open =
        "AttributeBegin\nMaterial \"\"\nTranslate 0 -2 1\nShape \"sphere\" \"float radius\" .8\nAttributeEnd\n";
    const std::string objects = open + kMirror + ball("");
    const std::string black =
        "Material \"matte\" \"rgb Kd\" [0 0 0]\nShape \"disk\" \"float radius\" 3\nTranslate -.3 "
        "-.3 .7\nShape \"sphere\" \"float radius\" .6\n";
    const auto alone =
        "LookAt 0 -4 1.4  0 0 .6  0 0 1\nCamera \"perspective\" \"float fov\" 50\n"
        "Film \"image\" \"integer xresolution\" 16 \"integer yresolution\" 8\nWorldBegin\n";
    const std::string mirror = "AttributeBegin\n" + kMirror + "AttributeEnd\n";
    // What the camera sees of the skies past black surfaces.
    const std::string seenSky = "LightSource \"infinite\" \"rgb L\" [3 1 2]\n" + sun + "[1 .5 .2]\n";
    const std::string dark =
        "AttributeBegin\nMaterial \"matte\" \"rgb Kd\" [0 0 0]\n" + mirror.substr(mirror.find("Shape"));
    const test::Estimate background = seen(alone + seenSky + dark + black + "WorldEnd\n", "path");
    for (const char* integrator : kIntegrators) {
        SCOPED_TRACE(integrator);
        const test::Estimate both = seen(scene(backdrop + lit, objects, 4), integrator);
        test::Estimate sum = seen(scene(lit, objects, 4), integrator);
        for (int c = 0; c < 3; ++c) {
            sum.mean[c] += background.mean[c];
            sum.variance[c] += background.variance[c];
        }
        test::expectSameMeans(sum, both);
        EXPECT_GT(background.mean[0], 20 * std::sqrt(both.variance[0]));
    }
}

}  // namespace
}  // namespace drc
