// Lights in pbrt-v4's format.
#include "pbrt/light_factory_v4.h"

#include <gmock/gmock.h>

#include "base/log.h"
#include "image/image_io.h"
#include "pbrt/equal_area_image.h"
#include "pbrt/spectrum.h"
#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

LightPtr lightOf(const std::string& text, const std::string& directory = ".") {
    return loadWorldV4(text, directory)->lights.at(0);
}
Rgb arriving(const std::string& text, const Vec3& p, const std::string& directory = ".") {
    const auto s = lightOf(text, directory)->sample(p, Vec2(0.5f, 0.5f));
    return s ? s->radiance : Rgb(0.f);
}
void expectNear(const Rgb& a, const Rgb& b, float tolerance = 1e-2f) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << a << " " << b;
}
std::string light(const std::string& rest) { return "LightSource " + rest; }

TEST(LightFactoryV4, ScaleIsANumber) {
    for (const char* type : {"point", "spot", "goniometric"})
        expectNear(arriving(light("\"" + std::string(type) + "\" \"rgb I\" [1 2 3] \"float scale\" 2"), Vec3(0, 0, 2)),
                   Rgb(0.5f, 1, 1.5f));
    expectNear(arriving(light("\"distant\" \"rgb L\" [1 2 3] \"float scale\" 2"), Vec3(0, 0, 2)), Rgb(2, 4, 6));
    expectNear(lightOf(light("\"infinite\" \"rgb L\" [1 2 3] \"float scale\" 2"))->escaped(Vec3(0.f), Vec3(1, 0, 0)),
               Rgb(2, 4, 6));
    EXPECT_THAT(errorOfWorldV4(light("\"point\" \"float scale\" -1")), HasSubstr("must not be negative"));
    EXPECT_THAT(warningsOfWorldV4(light("\"point\" \"rgb scale\" [1 1 1]")), HasSubstr("must be of type 'float'"));
}

TEST(LightFactoryV4, PowerAndIlluminance) {
    const auto power = [](const std::string& text) { return luminance(lightOf(text)->power(1)); };
    EXPECT_NEAR(power(light("\"point\" \"float power\" 60")), 60, 0.05f);
    EXPECT_NEAR(power(light("\"point\" \"float power\" 60 \"float scale\" 2")), 120, 0.1f);
    EXPECT_NEAR(power(light("\"spot\" \"float power\" 60 \"float coneangle\" 40 \"float conedeltaangle\" 20")), 60,
                0.05f);
    EXPECT_NEAR(power(light("\"goniometric\" \"float power\" 60")), 60, 0.05f);
    expectNear(arriving(light("\"distant\" \"float illuminance\" 5"), Vec3(0, 0, 0)), Rgb(5.f));
    // The illuminance is that of a horizontal surface under a uniform sky.
    expectNear(lightOf(light("\"infinite\" \"float illuminance\" 6.2831853"))->escaped(Vec3(0.f), Vec3(0, 0, 1)),
               Rgb(2.f));
}

TEST(LightFactoryV4, SpectraHaveUnitLuminance) {
    const auto sky = [](const std::string& params) {
        return lightOf(light("\"infinite\" " + params))->escaped(Vec3(0.f), Vec3(0, 0, 1));
    };
    expectNear(sky("\"blackbody L\" 6500 \"float scale\" 3"), atUnitLuminance(blackbodyToRgb(6500)) * 3);
    EXPECT_NEAR(luminance(sky("\"blackbody L\" [3000]")), 1, 1e-4f);
    EXPECT_NEAR(luminance(sky("\"spectrum L\" [400 7 700 7]")), 1, 1e-4f);
    expectNear(sky("\"spectrum L\" \"stdillum-D65\""), Rgb(1.f), 2e-3f);
    EXPECT_GT(sky("\"spectrum L\" \"stdillum-A\"").x, 1.5f);
    EXPECT_THAT(errorOfWorldV4(light("\"infinite\" \"blackbody L\" [6500 2]")), HasSubstr("a temperature alone"));
    EXPECT_THAT(errorOfWorldV4(light("\"infinite\" \"spectrum L\" \"stdillum-D66\"")), HasSubstr("cannot find"));
}

TEST(LightFactoryV4, SpotsFadeSmoothly) {
    const std::string spot = light("\"spot\" \"float coneangle\" 60 \"float conedeltaangle\" 60");
    const float c = 0.75f;  // the cosine halfway between the edge and the axis
    EXPECT_NEAR(arriving(spot, Vec3(std::sqrt(1 - c * c), 0, c)).x, 0.5f, 1e-3f);
}

// An equal-area image of all directions, which is red around the light's +z.
std::string squareMap(const TemporaryFolder& folder) {
    Image image(32, 32);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            const Vec3 d = equalAreaDirectionOf(Vec2((float(x) + 0.5f) / 32, (float(y) + 0.5f) / 32));
            image.setRgb(x, y, d.z > 0.8f ? Rgb(4, 0, 0) : d.x > 0 ? Rgb(0, 1, 0) : Rgb(0, 0, 1));
        }
    writeExr(folder.path() + "/square.exr", {{"", &image}});
    return " \"string filename\" \"square.exr\" ";
}

TEST(LightFactoryV4, EnvironmentsAreEqualAreaSquares) {
    const TemporaryFolder folder;
    const std::string map = squareMap(folder);
    const auto sky = lightOf(light("\"infinite\"" + map), folder.path());
    expectNear(sky->escaped(Vec3(0.f), Vec3(0.1f, 0.1f, 1)), Rgb(4, 0, 0));
    expectNear(sky->escaped(Vec3(0.f), normalize(Vec3(1, 0.3f, -0.5f))), Rgb(0, 1, 0));
    expectNear(sky->escaped(Vec3(0.f), normalize(Vec3(-1, 0.3f, -0.5f))), Rgb(0, 0, 1));
    const auto turned = lightOf("Rotate 90 0 1 0 " + light("\"infinite\"" + map), folder.path());
    expectNear(turned->escaped(Vec3(0.f), Vec3(1, 0.1f, 0.1f)), Rgb(4, 0, 0));
    // After scaling, the cosine-weighted luminance of the upper hemisphere must be the requested illuminance.
    const auto bright = lightOf(light("\"infinite\" \"float illuminance\" 10" + map), folder.path());
    double sum = 0;
    const int n = 200;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const float z = std::sqrt((float(i) + 0.5f) / n), phi = 2 * kPi * (float(j) + 0.5f) / n,
                        r = std::sqrt(1 - z * z);
            sum += double(luminance(bright->escaped(Vec3(0.f), Vec3(r * std::cos(phi), r * std::sin(phi), z))));
        }
    EXPECT_NEAR(sum / (n * n) * double(kPi), 10, 0.2);
    Image wide(4, 2);
    writeExr(folder.path() + "/wide.exr", {{"", &wide}});
    EXPECT_THAT(errorOfWorldV4(light("\"infinite\" \"string filename\" \"wide.exr\""), folder.path()),
                AllOf(StartsWith("s.pbrt:2:42: "), HasSubstr("4 x 2 pixels; pbrt-v4 takes square ones alone")));
    EXPECT_THAT(errorOfWorldV4(light("\"infinite\" \"rgb L\" [1 1 1]" + map), folder.path()),
                HasSubstr("both 'L' and 'filename'"));
}

TEST(LightFactoryV4, PortalsAreInWorldSpace) {
    const std::string portal = " \"point3 portal\" [0 0 2  0 1 2  1 1 2  1 0 2] ";
    const auto sky = lightOf("Translate 7 7 7 " + light("\"infinite\" \"rgb L\" [1 2 3] \"float scale\" 2" + portal));
    // The square from (0, 0) to (1, 1) at z = 2, outward upwards, whatever the transformation.
    expectNear(sky->escaped(Vec3(0.5f, 0.5f, 0), Vec3(0, 0, 1)), Rgb(2, 4, 6));
    EXPECT_TRUE(isBlack(sky->escaped(Vec3(1.5f, 0.5f, 0), Vec3(0, 0, 1))));
    EXPECT_TRUE(isBlack(sky->escaped(Vec3(0.5f, 0.5f, 3), Vec3(0, 0, 1))));
    EXPECT_TRUE(sky->sample(Vec3(0.5f, 0.5f, 0), Vec2(0.3f, 0.4f)));
    // With an image, too; and where the scene is moved, since it is far from the origin.
    const TemporaryFolder folder;
    const auto shown = lightOf(light("\"infinite\"" + squareMap(folder) + portal), folder.path());
    expectNear(shown->escaped(Vec3(0.5f, 0.5f, 0), Vec3(0.1f, 0.1f, 1)), Rgb(4, 0, 0));
    const auto scene =
        loadWorldV4(light("\"infinite\" \"point3 portal\" [1e6 0 2  1e6 1 2  1000001 1 2  1000001 0 2]") +
                    "\nTranslate 1e6 0 0 Shape \"sphere\"");
    const Vec3 below = Vec3(1e6f, 0, 0) - scene->origin + Vec3(0.5f, 0.5f, 0);
    expectNear(scene->lights.at(0)->escaped(below, Vec3(0, 0, 1)), Rgb(1.f));
}

TEST(LightFactoryV4, PortalsMustBeRectangles) {
    const auto error = [](const std::string& points) {
        return errorOfWorldV4(light("\"infinite\" \"point3 portal\" [" + points + "]"));
    };
    EXPECT_THAT(
        error("0 0 0 1 0 0 1 1 0"),
        AllOf(StartsWith("s.pbrt:2:24: "), HasSubstr("must have the 4 corners of a rectangle"), HasSubstr("3 points")));
    EXPECT_THAT(error("0 0 0  1 0 0  1 1 0  0 2 0"), HasSubstr("the angle at corner 3 is 135 degrees, not 90"));
    EXPECT_THAT(error("0 0 0  1 0 0  1 0 0  0 1 0"), HasSubstr("corners 2 and 3 are at the same place"));
    EXPECT_THAT(error("0 0 0  1 1 0  1 0 0  0 1 0"), HasSubstr("the angle at corner"));
    EXPECT_THAT(warningsOfWorldV4(light("\"infinite\" \"float portal\" [0 0 0]")), HasSubstr("must be of type"));
}

TEST(LightFactoryV4, GoniometricDiagramsStandOnTheirPole) {
    const TemporaryFolder folder;
    Image image(32, 32);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            const Vec3 d = equalAreaDirectionOf(Vec2((float(x) + 0.5f) / 32, (float(y) + 0.5f) / 32));
            image.setRgb(x, y, Rgb(d.z > 0 ? 3.f : d.y > 0 ? 1.f : 0.f));
        }
    writeExr(folder.path() + "/lamp.exr", {{"", &image}});
    const std::string lamp = light("\"goniometric\" \"string filename\" \"lamp.exr\" ");
    // The image's +z is the light's +y, and vice versa.
    expectNear(arriving(lamp, Vec3(0, 1, 0), folder.path()), Rgb(3.f));
    expectNear(arriving(lamp, Vec3(0.1f, -0.7f, 0.7f), folder.path()), Rgb(1 / 0.99f), 2e-2f);
    EXPECT_TRUE(isBlack(arriving(lamp, Vec3(0, -0.5f, -0.7f), folder.path())));
    EXPECT_NEAR(luminance(lightOf(lamp + "\"float power\" 8", folder.path())->power(1)), 8, 0.1f);
}

TEST(LightFactoryV4, ProjectedPicturesStandUpright) {
    const TemporaryFolder folder;
    Image image(2, 2);
    image.setRgb(0, 0, Rgb(1, 0, 0));  // top left
    image.setRgb(1, 0, Rgb(0, 1, 0));
    image.setRgb(0, 1, Rgb(0, 0, 1));
    image.setRgb(1, 1, Rgb(1, 1, 1));
    writeExr(folder.path() + "/slide.exr", {{"", &image}});
    const std::string slide = light("\"projection\" \"string filename\" \"slide.exr\" ");
    EXPECT_GT(arriving(slide, Vec3(-0.9f, 0.9f, 1), folder.path()).x, 0.3f);
    EXPECT_EQ(arriving(slide, Vec3(-0.9f, 0.9f, 1), folder.path()).z, 0);
    EXPECT_GT(arriving(slide, Vec3(-0.9f, -0.9f, 1), folder.path()).z, 0.3f);
    EXPECT_TRUE(isBlack(arriving(slide, Vec3(-1.1f, 0, 1), folder.path()))) << "90 degrees";
    EXPECT_NEAR(luminance(lightOf(slide + "\"float power\" 8", folder.path())->power(1)), 8, 0.1f);
    EXPECT_THAT(errorOfWorldV4(light("\"projection\"")), HasSubstr("needs the parameter \"string filename\""));
}

TEST(LightFactoryV4, AreaLights) {
    const auto emitted = [](const std::string& params, const std::string& shape) {
        const auto scene = loadWorldV4("AreaLightSource \"diffuse\" " + params + "\n" + shape);
        EmitterHit hit;
        hit.ng = Vec3(0, 0, 1);
        return scene->primitives.at(0).areaLight->emitted(hit, Vec3(0, 0, 1));
    };
    const std::string disk = "Shape \"disk\"";
    expectNear(emitted("", disk), Rgb(1.f));
    expectNear(emitted("\"rgb L\" [1 2 3] \"float scale\" 2", disk), Rgb(2, 4, 6));
    expectNear(emitted("\"float power\" 20", disk), Rgb(20 / (kPi * kPi)));
    expectNear(emitted("\"float power\" 20 \"bool twosided\" true", disk), Rgb(10 / (kPi * kPi)));
    // As in pbrt each triangle gets the full power, so a square of two triangles has twice as much.
    const std::string square =
        "Shape \"trianglemesh\" \"point3 P\" [0 0 0 2 0 0 2 2 0 0 2 0] \"integer indices\" [0 1 2 0 2 3]";
    expectNear(emitted("\"float power\" 20", square), Rgb(10 / kPi));
}

// A red, green, blue and white quarter, from the top left.
std::string quarters(const TemporaryFolder& folder) {
    Image image(2, 2);
    image.setRgb(0, 0, Rgb(4, 0, 0));
    image.setRgb(1, 0, Rgb(0, 4, 0));
    image.setRgb(0, 1, Rgb(0, 0, 4));
    image.setRgb(1, 1, Rgb(4, 4, 4));
    writeExr(folder.path() + "/quarters.exr", {{"", &image}});
    return " \"string filename\" \"quarters.exr\" ";
}
const std::string kScreen =
    "Shape \"bilinearmesh\" \"point3 P\" [0 0 0  2 0 0  0 2 0  2 2 0] \"integer indices\" [0 1 2 3]\n";

TEST(LightFactoryV4, PicturesOnAreaLightsStandUpright) {
    const TemporaryFolder folder;
    const auto emitted = [&](const std::string& params, const Vec2& uv, const Vec3& wo = Vec3(0, 0, 1)) {
        const auto scene =
            loadWorldV4("AreaLightSource \"diffuse\"" + quarters(folder) + params + "\n" + kScreen, folder.path());
        return scene->primitives.at(0).areaLight->emitted({Vec3(0.f), Vec3(0, 0, 1), 0, uv}, wo);
    };
    // The lower left corner of the picture is at (0, 0).
    expectNear(emitted("", Vec2(0.25f, 0.25f)), Rgb(0, 0, 4));
    expectNear(emitted("", Vec2(0.75f, 0.25f)), Rgb(4, 4, 4));
    expectNear(emitted("", Vec2(0.25f, 0.75f)), Rgb(4, 0, 0));
    expectNear(emitted("", Vec2(0.75f, 0.75f)), Rgb(0, 4, 0));
    // It is interpolated, and extended beyond its edges.
    expectNear(emitted("", Vec2(0.5f, 0.75f)), Rgb(2, 2, 0));
    expectNear(emitted("", Vec2(-5, 3)), Rgb(4, 0, 0));
    expectNear(emitted("\"float scale\" 3", Vec2(0.25f, 0.75f)), Rgb(12, 0, 0));
    EXPECT_TRUE(isBlack(emitted("", Vec2(0.25f, 0.25f), Vec3(0, 0, -1))));
    expectNear(emitted("\"bool twosided\" true", Vec2(0.25f, 0.25f), Vec3(0, 0, -1)), Rgb(0, 0, 4));
    // The image's mean luminance is 2. As in pbrt, each of the two triangles has the power.
    const float white = 50 / (kPi * 4 / 2 * 2);
    expectNear(emitted("\"float power\" 50", Vec2(0.75f, 0.25f)), Rgb(4 * white));
    expectNear(emitted("\"float power\" 50 \"bool twosided\" true", Vec2(0.75f, 0.25f)), Rgb(2 * white));
    const auto scene = loadWorldV4("AreaLightSource \"diffuse\" \"float power\" 50" + quarters(folder) + "\n" + kScreen,
                                   folder.path());
    EXPECT_NEAR(luminance(scene->lights.at(0)->power(1)), 2 * 50, 0.5f);
}

TEST(LightFactoryV4, PicturesOnAreaLightsMayFail) {
    const TemporaryFolder folder;
    const auto error = [&](const std::string& params) {
        return errorOfWorldV4("AreaLightSource \"diffuse\" " + params + "\n" + kScreen, folder.path());
    };
    EXPECT_THAT(error("\"string filename\" \"none.exr\""),
                AllOf(StartsWith("s.pbrt:2:45: "), HasSubstr("cannot find the picture that is emitted 'none.exr'")));
    folder.write("broken.exr", "no picture");
    EXPECT_THAT(error("\"string filename\" \"broken.exr\""),
                AllOf(StartsWith("s.pbrt:2:45: "), HasSubstr("broken.exr")));
    EXPECT_THAT(error("\"rgb L\" [1 1 1]" + quarters(folder)), HasSubstr("both 'L' and 'filename'"));
    const Image black(2, 2);
    writeExr(folder.path() + "/black.exr", {{"", &black}});
    EXPECT_THAT(error("\"float power\" 5 \"string filename\" \"black.exr\""),
                HasSubstr("is black: it cannot have the 'power'"));
    EXPECT_TRUE(loadWorldV4("AreaLightSource \"diffuse\" \"string filename\" \"black.exr\"\n" + kScreen, folder.path())
                    ->lights.empty());
    // Pixels that are no numbers are black.
    Image nan(2, 1);
    nan.setRgb(0, 0, Rgb(NAN, 1, 1));
    nan.setRgb(1, 0, Rgb(1.f));
    writeExr(folder.path() + "/nan.exr", {{"", &nan}});
    const auto scene =
        loadWorldV4("AreaLightSource \"diffuse\" \"string filename\" \"nan.exr\"\n" + kScreen, folder.path());
    EXPECT_NEAR(luminance(scene->lights.at(0)->power(1)), kPi * 4 / 2, 0.02f);
    // What pbrt wants for sampling a patch, its light finds itself.
    forgetWarnings();
    loadWorldV4("AreaLightSource \"diffuse\"" + quarters(folder) + kScreen + "\"string emissionfilename\" \"x.exr\"",
                folder.path());
    EXPECT_EQ(warningCount(), 0);
}

}  // namespace
}  // namespace drc::pbrt
