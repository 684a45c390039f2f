// Lights in scene files.
#include <gmock/gmock.h>

#include "image/color.h"
#include "image/image_io.h"
#include "math/sampler.h"
#include "pbrt/dialect.h"
#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

// Light arriving at p from the only light of the scene; black if there is none.
Rgb arriving(const std::string& text, const Vec3& p, const std::string& directory = ".") {
    const auto scene = loadWorld(text, directory);
    const auto s = scene->lights.at(0)->sample(p, Vec2(0.5f, 0.5f));
    return s ? s->radiance : Rgb(0.f);
}

TEST(LightFactory, SpotsAimAndHavePbrtsDefaults) {
    const std::string spot = "LightSource \"spot\" \"rgb I\" [8 4 2] \"rgb scale\" [2 2 2] \"point from\" [1 0 0] ";
    EXPECT_EQ(arriving(spot + "\"point to\" [1 5 0]", Vec3(1, 2, 0)), Rgb(4, 2, 1));
    // 30 degrees with a soft edge of five. With the default of `to`, the light shines towards z = 1.
    const std::string plain = "LightSource \"spot\"";
    const auto at = [&](float degrees) {
        return arriving(plain, Vec3(std::sin(degrees * kPi / 180), 0, std::cos(degrees * kPi / 180))).x;
    };
    EXPECT_NEAR(at(24.9f), 1, 1e-5);
    EXPECT_GT(at(29), 0);
    EXPECT_LT(at(27), 0.9f);
    EXPECT_EQ(at(30.1f), 0);
    // The transformation moves both points.
    EXPECT_EQ(arriving("Translate 0 0 7 Rotate 90 1 0 0 " + spot + "\"point to\" [1 5 0]", Vec3(1, 0, 9)),
              Rgb(4, 2, 1));
    EXPECT_EQ(arriving(plain + " \"float coneangle\" 10 \"float conedeltaangle\" 0", Vec3(0, 0, 1)), Rgb(1, 1, 1));
    EXPECT_THAT(errorOfWorld(plain + " \"point to\" [0 0 0]"),
                AllOf(StartsWith("s.pbrt:2:13"), HasSubstr("has no direction: 'from' equals 'to'")));
    EXPECT_THAT(errorOfWorld(plain + " \"float coneangle\" 200"),
                AllOf(StartsWith("s.pbrt:2:20"), HasSubstr("must be above 0 and at most 180 degrees, not 200")));
    // All directions, but for a soft edge behind.
    EXPECT_NEAR(arriving(plain + " \"float coneangle\" 180", Vec3(1, 0, -1)).x, 0.5f, 1e-6f);
    EXPECT_THAT(errorOfWorld(plain + " \"float conedeltaangle\" -1"), HasSubstr("must not be negative"));
}

TEST(LightFactory, PicturesOfProjectorsAndGoniometricLights) {
    const TemporaryFolder folder;
    Image image(2, 1);
    image.setRgb(0, 0, Rgb(1, 0, 0));
    image.setRgb(1, 0, Rgb(0, 0.5f, 0));
    writeExr(folder.path() + "/map.exr", {{"", &image}});
    const std::string map = " \"string mapname\" \"map.exr\" ";
    // The left half of the projector's image is red: x < 0 in its space.
    const std::string projector = "LightSource \"projection\" \"rgb I\" [2 2 2] \"float fov\" 60" + map;
    const float centre = -std::tan(kPi / 6);  // of the left pixel
    EXPECT_NEAR(arriving(projector, Vec3(centre, 0, 1), folder.path()).y, 0, 1e-5f);
    EXPECT_GT(arriving(projector, Vec3(centre, 0, 1), folder.path()).x, 1);
    EXPECT_GT(arriving(projector, Vec3(0.9f, 0, 1), folder.path()).y, 0);
    EXPECT_TRUE(isBlack(arriving(projector, Vec3(0, 0.7f, 1), folder.path())));
    EXPECT_GT(arriving("LightSource \"projection\"", Vec3(0.41f, 0, 1)).x, 0) << "45 degrees";
    EXPECT_EQ(arriving("LightSource \"projection\"", Vec3(0.42f, 0, 1)).x, 0);
    // In the first half turn, z > 0, the goniometric light is red.
    const std::string lamp = "Translate 0 0 1 LightSource \"goniometric\" \"rgb scale\" [3 3 3]" + map;
    EXPECT_LT(length(arriving(lamp, Vec3(0, 0, 2), folder.path()) - Rgb(3, 0, 0)), 1e-4f);
    EXPECT_LT(length(arriving(lamp, Vec3(0, 0, 0), folder.path()) - Rgb(0, 1.5f, 0)), 1e-4f);
    EXPECT_THAT(errorOfWorld("LightSource \"goniometric\" \"string mapname\" \"none.exr\""),
                AllOf(StartsWith("s.pbrt:2:44"), HasSubstr("none.exr")));
    EXPECT_THAT(errorOfWorld("LightSource \"projection\" \"float fov\" 0"), HasSubstr("must be between 0 and 180"));
}

// As in pbrt-v3, which decodes only images of textures.
TEST(LightFactory, PicturesOfIntegersAreTakenAsStored) {
    const TemporaryFolder folder;
    Image grey(4, 2);
    for (float& v : grey.data()) v = srgbDecode(0.5f);
    writePng(folder.path() + "/grey.png", grey);
    const std::string map = " \"string mapname\" \"grey.png\"";
    for (const char* light : {"goniometric", "projection"})
        EXPECT_NEAR(arriving(std::string("LightSource \"") + light + "\"" + map, Vec3(0, 0, 1), folder.path()).x, 0.5f,
                    0.002f)
            << light;
    const auto scene = loadWorld("LightSource \"infinite\"" + map, folder.path());
    EXPECT_NEAR(scene->lights.at(0)->escaped(Vec3(0.f), Vec3(0, 0, 1)).x, 0.5f, 0.002f);
}

TEST(LightFactory, AProjectedPictureRepeatsAtItsEdges) {
    const TemporaryFolder folder;
    Image image(2, 2);
    image.setRgb(0, 0, Rgb(8, 0, 0));  // the lowest x and y
    writeExr(folder.path() + "/map.exr", {{"", &image}});
    const std::string projector = "LightSource \"projection\" \"float fov\" 90 \"string mapname\" \"map.exr\"";
    const auto at = [&](float x, float y) { return arriving(projector, Vec3(x, y, 1), folder.path()).x; };
    // At the outer edge of the first pixel, half of it is interpolated with half of the pixel at the opposite edge.
    const float centre = at(-0.5f, -0.5f) * 1.5f;  // times the squared distance
    EXPECT_NEAR(centre, 8, 0.01f);
    EXPECT_NEAR(at(-0.999f, -0.5f) * 2.25f, 4, 0.05f);
    EXPECT_NEAR(at(0.999f, -0.5f) * 2.25f, 4, 0.05f);
    EXPECT_NEAR(at(-0.5f, 0.999f) * 2.25f, 4, 0.05f);
}

TEST(LightFactory, DistantLightsMayBeSeenUnderAnAngle) {
    const auto lightOf = [](const std::string& angle) {
        return loadWorld("LightSource \"distant\" \"rgb L\" [1 2 3] \"float angle\" " + angle)->lights.at(0);
    };
    EXPECT_TRUE(lightOf("0")->isDelta());
    const LightPtr sun = lightOf("60");
    EXPECT_FALSE(sun->isDelta());
    // Irradiance over pi sin^2.
    EXPECT_NEAR(sun->escaped(Vec3(0), Vec3(0, 0, -1)).y, 2 / (kPi * 0.25f), 1e-4);
    EXPECT_EQ(sun->escaped(Vec3(0), Vec3(0, 0, 1)), Rgb(0.f));
    EXPECT_THAT(errorOfWorld("LightSource \"distant\" \"float angle\" 200"),
                HasSubstr("must be from 0 to 180 degrees"));
    EXPECT_THAT(errorOfWorld("LightSource \"distant\" \"float angle\" -1"), HasSubstr("must be from 0 to 180 degrees"));
}

// In both dialects: the sphere is in the scene, keeps the intensity, and has the transformation's size.
TEST(LightFactory, PointsAndSpotsMayHaveARadius) {
    const std::string scaled = "Translate 0 0 5 Scale 2 2 2 ";
    const std::string point = "LightSource \"point\" \"rgb I\" [1 2 3] \"float radius\" .25\n";
    const std::string spot = "LightSource \"spot\" \"rgb I\" [1 2 3] \"float radius\" .25 \"float coneangle\" 20\n";
    for (const Dialect dialect : {Dialect::V3, Dialect::V4})
        for (const std::string& light : {point, spot}) {
            SCOPED_TRACE(light);
            const auto scene = dialect == Dialect::V3 ? loadWorld(scaled + light) : loadWorldV4(scaled + light);
            ASSERT_EQ(scene->primitives.size(), 1u);
            const Primitive& bulb = scene->primitives[0];
            EXPECT_FALSE(bulb.visibleToCamera);
            EXPECT_FALSE(bulb.material);
            EXPECT_EQ(bulb.areaLight, scene->lights.at(0));
            EXPECT_LT(length(bulb.shape->bounds().min + scene->origin - Vec3(-.5f, -.5f, 4.5f)), 1e-5f);
            // The irradiance of the books, I / d^2, along the axis.
            double sum = 0;
            constexpr uint32_t kSamples = 1 << 12;
            for (uint32_t i = 0; i < kSamples; ++i)
                if (const auto s = scene->lights[0]->sample(Vec3(0, 0, 9) - scene->origin, Sampler(1, i).get2D()))
                    sum += double(s->radiance.y * -s->wi.z / s->pdf) / kSamples;
            EXPECT_NEAR(sum, 2. / 16, 1e-3);
            // Beside the axis there is the spot's cone.
            EXPECT_EQ(bool(scene->lights[0]->sample(Vec3(4, 0, 5) - scene->origin, Vec2(0.5f, 0.5f))), light == point);
        }
    EXPECT_THAT(errorOfWorld("LightSource \"point\" \"float radius\" -1"), HasSubstr("'radius'"));
}

TEST(LightFactory, LampsMayBeNarrowHiddenAndWithoutABody) {
    const std::string lamp = "AreaLightSource \"diffuse\" \"float spread\" 60\nShape \"disk\" ";
    for (const Dialect dialect : {Dialect::V3, Dialect::V4}) {
        const auto load = [&](const std::string& text) {
            return dialect == Dialect::V3 ? loadWorld(text) : loadWorldV4(text);
        };
        const auto plain = load(lamp);
        EXPECT_TRUE(plain->primitives.at(0).visibleToCamera);
        EXPECT_TRUE(plain->primitives[0].material);
        const AreaLight& light = *plain->primitives[0].areaLight;
        EXPECT_GT(light.emitted({Vec3(0), Vec3(0, 0, 1)}, Vec3(0, 0, 1)).x, 1);
        EXPECT_TRUE(isBlack(light.emitted({Vec3(0), Vec3(0, 0, 1)}, normalize(Vec3(0.6f, 0, 1)))));
        EXPECT_NEAR(light.power(1).x, kPi * kPi, 1e-4);
        const auto bodiless = load(lamp + "\"bool visibletocamera\" false \"bool blockslight\" false");
        EXPECT_FALSE(bodiless->primitives.at(0).visibleToCamera);
        EXPECT_FALSE(bodiless->primitives[0].material);
        EXPECT_TRUE(bodiless->primitives[0].areaLight);
        EXPECT_FALSE(load("LightSource \"infinite\" \"bool visibletocamera\" false")->lights.at(0)->visibleToCamera());
        for (const std::string source : {"LightSource \"infinite\" ", "LightSource \"distant\" \"float angle\" 3 "}) {
            const auto backdrop = load(source + "\"bool illuminates\" false");
            EXPECT_TRUE(backdrop->lights.at(0)->visibleToCamera());
            EXPECT_FALSE(backdrop->lights[0]->illuminates());
            EXPECT_TRUE(load(source)->lights.at(0)->illuminates());
        }
        // The camera would not see it, so that nothing is left.
        EXPECT_TRUE(load("LightSource \"distant\" \"bool illuminates\" false")->lights.empty());
        EXPECT_FALSE(load("Shape \"disk\" \"bool visibletodiffuse\" false")->primitives.at(0).visibleToDiffuse);
        EXPECT_TRUE(load("Shape \"disk\"")->primitives.at(0).visibleToDiffuse);
    }
    EXPECT_THAT(errorOfWorld("LightSource \"infinite\" \"bool visibletocamera\" false \"bool illuminates\" false"),
                AllOf(StartsWith("s.pbrt:2:"), HasSubstr("is seen by nothing")));
    for (const char* wrong : {"0", "-3", "181"})
        EXPECT_THAT(errorOfWorld(std::string("AreaLightSource \"diffuse\" \"float spread\" ") + wrong),
                    AllOf(StartsWith("s.pbrt:2:"), HasSubstr("must be above 0 and at most 180 degrees")));
}

TEST(LightFactory, ScaleMultipliesEveryLight) {
    for (const char* light : {"point", "spot", "goniometric", "projection"})
        EXPECT_EQ(arriving(std::string("LightSource \"") + light + "\" \"rgb I\" [1 2 3] \"rgb scale\" [2 3 .5]",
                           Vec3(0, 0, 2)),
                  Rgb(0.5f, 1.5f, 0.375f))
            << light;
    EXPECT_EQ(arriving("LightSource \"distant\" \"rgb L\" [1 2 3] \"rgb scale\" [2 3 .5]", Vec3(0, 0, 2)),
              Rgb(2, 6, 1.5f));
    const auto scene = loadWorld(
        "AreaLightSource \"diffuse\" \"rgb L\" [1 2 3] \"rgb scale\" [2 2 2] \"integer nsamples\" 4\nShape \"disk\"");
    EXPECT_LT(length(scene->lights.at(0)->power(1) - Rgb(2, 4, 6) * (kPi * kPi)), 1e-3f);
}

}  // namespace
}  // namespace drc::pbrt
