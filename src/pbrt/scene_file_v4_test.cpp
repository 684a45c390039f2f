// Scenes in pbrt-v4's format: what is interpreted differently from pbrt-v3's.
#include <gmock/gmock.h>

#include "base/log.h"
#include "image/color.h"
#include "image/image_io.h"
#include "pbrt/material_comparison.h"
#include "pbrt/scene_file.h"
#include "pbrt/spectrum.h"
#include "pbrt/test_scenes.h"
#include "scene/materials/material_matte.h"

namespace drc::pbrt {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kTriangle = "Shape \"trianglemesh\" \"point3 P\" [0 0 0  1 0 0  0 1 0]\n";

RenderSettings settingsOf(const std::string& options) {
    return loadPbrtString("ColorSpace \"srgb\"\n" + options + "\nWorldBegin\n", ".", {}, "s.pbrt")->sensor.settings;
}
std::string errorOfOptions(const std::string& options) {
    return errorOf([&] { settingsOf(options); });
}
template <typename F>
int warningsOf(const F& f) {
    forgetWarnings();
    f();
    return warningCount();
}
// The colour of a diffuse surface.
Rgb albedoOf(const std::string& world, const std::string& directory = ".", const std::string& end = "") {
    const auto scene = loadWorldV4(world + "\n" + kTriangle + end, directory);
    Bsdf bsdf(Frame(), Vec3(0, 0, 1));
    TextureContext at;
    at.uv = Vec2(0.25f, 0.75f);
    at.n = Vec3(0, 0, 1);
    scene->primitives.back().material->addLobes(at, Rgb(1.f), bsdf);
    return bsdf.albedo(Vec3(0, 0, 1));
}
void expectNear(const Rgb& a, const Rgb& b, float tolerance = 1e-4f) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << a << " " << b;
}

TEST(SceneFileV4, DefaultsArePbrtV4s) {
    const RenderSettings s = settingsOf("");
    EXPECT_EQ(s.film.width, 1280);
    EXPECT_EQ(s.integrator, "volpath");
    EXPECT_EQ(s.sampler, "zsobol");
    EXPECT_EQ(s.samplesPerPixel, 16);
    EXPECT_EQ(s.filmScale, 1);
    EXPECT_EQ(s.filter->radius(), Vec2(1.5f, 1.5f));
    // A standard deviation of half a pixel, down to zero at the radius.
    const float edge = std::exp(-4.5f);
    EXPECT_NEAR(s.filter->eval(Vec2(0.5f, 0)) / s.filter->eval(Vec2(0, 0)), (std::exp(-0.5f) - edge) / (1 - edge),
                1e-5f);
    const auto scene = loadWorldV4(kTriangle);
    EXPECT_TRUE(alike(*scene->primitives[0].material, *makeMatte({})));
}

TEST(SceneFileV4, Settings) {
    const RenderSettings s = settingsOf(
        "Option \"bool disablepixeljitter\" true Option \"string rendercoordsys\" \"world\"\n"
        "Film \"rgb\" \"integer xresolution\" 64 \"integer yresolution\" 32 \"integer pixelbounds\" [1 9 2 8]\n"
        "  \"float iso\" 200 \"string sensor\" \"cie1931\" \"bool savefp16\" false \"float maxcomponentvalue\" 7\n"
        "Camera \"perspective\" \"float shutterclose\" .25 \"float fov\" 30\n"
        "Sampler \"pmj02bn\" \"integer pixelsamples\" 33 \"integer seed\" 4\n"
        "PixelFilter \"box\" \"float xradius\" 1 \"float yradius\" 2\n"
        "Integrator \"path\" \"integer maxdepth\" 9 \"string lightsampler\" \"bvh\" \"bool regularize\" false\n");
    EXPECT_EQ(s.film.width, 64);
    EXPECT_EQ(s.region().x1, 9);
    EXPECT_EQ(s.region().y0, 2);
    // ISO 200 for a quarter of a second.
    EXPECT_EQ(s.filmScale, 0.5f);
    EXPECT_EQ(s.maxSampleLuminance, 14);  // 7 once exposed
    EXPECT_EQ(s.samplesPerPixel, 33);
    EXPECT_EQ(s.filter->radius(), Vec2(1, 2));
    EXPECT_EQ(s.integrator, "path");
    EXPECT_EQ(s.maxDepth, 9);
    EXPECT_EQ(settingsOf("Sampler \"independent\"").samplesPerPixel, 4);
    EXPECT_EQ(settingsOf("Sampler \"stratified\" \"integer xsamples\" 3").samplesPerPixel, 12);
}

TEST(SceneFileV4, WhiteBalanceIsForALightOfThatTemperature) {
    std::optional<RgbMatrix> balance;
    EXPECT_EQ(warningsOf([&] { balance = settingsOf("Film \"rgb\" \"float whitebalance\" 5000").whiteBalance; }), 0);
    expectNear(balance.value() * daylight(5000), Rgb(1.f), 1e-3f);
    const Rgb bulb = blackbodyToRgb(2800);
    expectNear(settingsOf("Film \"rgb\" \"float whitebalance\" 2800").whiteBalance.value() * bulb, Rgb(luminance(bulb)),
               1e-3f);
    EXPECT_FALSE(settingsOf("Film \"rgb\" \"float whitebalance\" 0").whiteBalance);
    EXPECT_FALSE(settingsOf("").whiteBalance);
    for (const char* bad : {"-5000", "10", "1e6"})
        EXPECT_THAT(errorOfOptions("Film \"rgb\" \"float whitebalance\" " + std::string(bad)),
                    HasSubstr("must be a temperature from 1000 to 25000 kelvin, or 0 for none"));
}

TEST(SceneFileV4, WhatIsKnownButNotBuiltIsNamed) {
    EXPECT_EQ(warningsOf([] { settingsOf("Film \"rgb\" \"string sensor\" \"canon_eos_100d\""); }), 1);
    EXPECT_EQ(warningsOf([] { settingsOf("Film \"gbuffer\" \"string coordinatesystem\" \"world\""); }), 1);
    EXPECT_EQ(warningsOf([] { settingsOf("Integrator \"volpath\" \"bool regularize\" true"); }), 1);
    EXPECT_EQ(warningsOf([] { settingsOf("Camera \"spherical\""); }), 1);
    EXPECT_EQ(warningsOf([] { settingsOf("Camera \"spherical\" \"string mapping\" \"equirectangular\""); }), 0);
    EXPECT_EQ(warningsOf([] { settingsOf("Option \"bool forcediffuse\" true"); }), 1);
    EXPECT_EQ(warningsOf([] { settingsOf("Option \"bool forcedifuse\" true"); }), 1);
    std::unique_ptr<Scene> scene;
    EXPECT_EQ(warningsOf([&] {
                  scene = loadWorldV4(
                      "MakeNamedMedium \"v4fog\" \"string type\" \"uniformgrid\" \"float density\" [1]\n"
                      "MediumInterface \"v4fog\" \"\"\n" +
                      kTriangle);
              }),
              1);
    EXPECT_EQ(scene->primitives.size(), 1u);
    // Unsupported directives need not have valid parameters of pbrt-v3.
    EXPECT_EQ(errorOfWorldV4("MakeNamedMedium \"m\" \"string type\" \"uniformgrid\" \"blackbody Le\" 6500"), "");
    EXPECT_THAT(errorOfOptions("Sampler \"sobl\""), HasSubstr("did you mean 'sobol'?"));
    EXPECT_THAT(errorOfOptions("Camera \"perspective\" \"float shutterclose\" 0"), HasSubstr("shutter"));
    EXPECT_THAT(errorOfOptions("Film \"rgb\" \"float iso\" 0"), HasSubstr("must be positive"));
    EXPECT_THAT(errorOfOptions("Integrator \"path\" \"string lightsampler\" \"best\""),
                HasSubstr("unknown lightsampler 'best'"));
    EXPECT_THAT(errorOfWorldV4("Shape \"hyperboloid\""), HasSubstr("only pbrt-v3 has"));
}

TEST(SceneFileV4, TheWorldEndsWithTheFile) {
    EXPECT_EQ(loadWorldV4(kTriangle)->primitives.size(), 1u);
    EXPECT_EQ(errorOfWorldV4("WorldEnd"), "");
    EXPECT_THAT(errorOfWorldV4("AttributeBegin"), HasSubstr("the file ends before the AttributeEnd"));
    EXPECT_THAT(errorOfScene("Film \"rgb\""), HasSubstr("without a WorldBegin"));
}

TEST(SceneFileV4, CurvesCylindersAndSubdivisionAreAsInV3) {
    const auto scene = loadWorldV4(
        "Shape \"cylinder\" \"float radius\" 2\n"
        "Shape \"curve\" \"string type\" \"flat\" \"float width\" .1 \"point3 P\" [0 0 0  1 0 0  2 1 0  3 1 0]\n"
        "Shape \"loopsubdiv\" \"integer levels\" 1 \"integer indices\" [0 1 2] \"point3 P\" [0 0 0  1 0 0  0 1 0]\n");
    ASSERT_EQ(scene->primitives.size(), 3u);
}

TEST(SceneFileV4, ShapesDoNotChangeTheirMaterial) {
    std::unique_ptr<Scene> scene;
    EXPECT_EQ(warningsOf([&] {
                  scene =
                      loadWorldV4("Material \"diffuse\"\n" + kTriangle + kTriangle + " \"rgb reflectance\" [1 0 0]");
              }),
              1);
    EXPECT_EQ(scene->primitives[0].material, scene->primitives[1].material);
}

TEST(SceneFileV4, MaterialsAndTextures) {
    expectNear(albedoOf("Material \"diffuse\" \"rgb reflectance\" [.2 .4 .6]"), Rgb(.2f, .4f, .6f));
    expectNear(albedoOf("MakeNamedMaterial \"a\" \"string type\" \"diffuse\" \"float reflectance\" 1\n"
                        "MakeNamedMaterial \"b\" \"string type\" \"diffuse\" \"float reflectance\" 0\n"
                        "Material \"mix\" \"string materials\" [\"a\" \"b\"] \"float amount\" .25"),
               Rgb(.75f));
    // A constant spectrum is grey under daylight.
    expectNear(albedoOf("Material \"diffuse\" \"spectrum reflectance\" [360 .3 830 .3]"), Rgb(.3f));
    const std::string texture = "Texture \"t\" \"spectrum\" ",
                      use = "\nMaterial \"diffuse\" \"texture reflectance\" \"t\"";
    expectNear(albedoOf(texture + "\"scale\" \"rgb tex\" [.2 .4 .6] \"float scale\" .5" + use), Rgb(.1f, .2f, .3f));
    expectNear(albedoOf(texture + "\"mix\" \"rgb tex1\" [0 0 0] \"rgb tex2\" [1 1 1] \"float amount\" .25" + use),
               Rgb(.25f));
    EXPECT_EQ(warningsOf([&] {
                  // The surface faces z.
                  const std::string mix = texture + "\"directionmix\" \"rgb tex1\" [1 0 0] \"rgb tex2\" [0 0 1] ";
                  expectNear(albedoOf(mix + use), Rgb(0, 0, 1));
                  expectNear(albedoOf(mix + "\"vector dir\" [0 0 -3]" + use), Rgb(1, 0, 0));
                  expectNear(albedoOf(mix + "\"vector dir\" [0 3 4]" + use), Rgb(.8f, 0, .2f));
                  expectNear(albedoOf("Rotate 90 1 0 0 " + mix + use + " Identity"), Rgb(1, 0, 0));
              }),
              0);
    EXPECT_THAT(errorOfWorldV4(texture + "\"directionmix\" \"vector dir\" [0 0 0]"), HasSubstr("must not be zero"));
    EXPECT_THAT(errorOfWorldV4(texture + "\"imagemap\" \"string filename\" \"no.png\""), HasSubstr("no.png"));
}

TEST(SceneFileV4, ImageMaps) {
    const TemporaryFolder folder;
    Image image(1, 2);
    image.setRgb(0, 0, Rgb(0.2f));  // the upper half: v > 1/2
    image.setRgb(0, 1, Rgb(0.8f));
    folder.write("a.png", encodePng(image));
    const auto upper = [&](const std::string& params) {
        return albedoOf("Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"a.png\" " + params +
                            "\nMaterial \"diffuse\" \"texture reflectance\" \"t\"",
                        folder.path())
            .x;
    };
    EXPECT_NEAR(upper("\"string filter\" \"point\""), 0.2f, 5e-3f);
    EXPECT_NEAR(upper("\"bool invert\" true"), 0.8f, 5e-3f);
    EXPECT_NEAR(upper("\"float scale\" 2 \"bool invert\" true"), 0.6f, 1e-2f);
    EXPECT_NEAR(upper("\"string encoding\" \"linear\""), 0.4845f, 5e-3f);
    EXPECT_NEAR(upper("\"string encoding\" \"gamma 1.8\""), std::pow(srgbEncode(0.2f), 1.8f), 5e-3f);
    for (const char* encoding : {"gamma", "gamma x", "gamma 0", "gamma -1", "gamma 2.2x", ""})
        EXPECT_THAT(errorOf([&] { upper("\"string encoding\" \"" + std::string(encoding) + "\""); }),
                    HasSubstr("must be 'sRGB', 'linear' or 'gamma' with a positive number"))
            << encoding;
    EXPECT_THAT(errorOf([&] { upper("\"string encoding\" \"rgb\""); }),
                HasSubstr("must be 'sRGB', 'linear' or 'gamma'"));
    EXPECT_THAT(errorOf([&] { upper("\"string filter\" \"trilinaer\""); }), HasSubstr("did you mean 'trilinear'?"));
}

// No surface reflects more than it receives.
TEST(SceneFileV4, ReflectancesAreAtMostOne) {
    EXPECT_EQ(
        errorOfWorldV4("Material \"diffuse\" \"rgb reflectance\" [2 1 .5]"),
        "s.pbrt:2:38: parameter 'reflectance' of material 'diffuse' is the share of the light that is reflected, and "
        "must be from 0 to 1, not 2\n"
        "    Material \"diffuse\" \"rgb reflectance\" [2 1 .5]\n"
        "                                         ^");
    for (const char* material :
         {"\"coateddiffuse\" \"rgb reflectance\"", "\"diffusetransmission\" \"rgb transmittance\"",
          "\"conductor\" \"rgb reflectance\"", "\"coatedconductor\" \"rgb reflectance\"", "\"hair\" \"rgb color\"",
          "\"subsurface\" \"rgb reflectance\"", "\"coateddiffuse\" \"rgb albedo\""})
        for (const char* value : {" [0 1.5 0]", " [0 -.5 0]"})
            EXPECT_THAT(errorOfWorldV4("Material " + std::string(material) + value), HasSubstr("must be from 0 to 1"))
                << material;
    expectNear(albedoOf("Texture \"s\" \"spectrum\" \"constant\" \"rgb value\" [.9 .4 .2]\n"
                        "Texture \"t\" \"spectrum\" \"scale\" \"texture tex\" \"s\" \"float scale\" 2\n"
                        "Material \"diffuse\" \"texture reflectance\" \"t\""),
               Rgb(1, .8f, .4f));
    expectNear(albedoOf("Material \"diffuse\" \"spectrum reflectance\" [300 2 800 2]"), Rgb(1.f));
    expectNear(albedoOf("Material \"diffuse\" \"float reflectance\" 2"), Rgb(1.f));
    // Deep red, of which more than 1 would be reflected in our red.
    const Rgb deep = albedoOf("Material \"diffuse\" \"spectrum reflectance\" [400 0 590 0 600 1 800 1]");
    EXPECT_LE(deep.x, 1);
    // An index of refraction, and the factor of a texture, are no reflectances.
    EXPECT_EQ(errorOfWorldV4("Material \"conductor\" \"rgb eta\" [2 1 .5] \"rgb k\" [3 3 3]"), "");
    // In pbrt-v3 a reflectance may be anything.
    EXPECT_EQ(errorOfWorld("Material \"matte\" \"rgb Kd\" [2 1 .5]"), "");
}

TEST(SceneFileV4, SolidTexturesLieInTheirOwnSpace) {
    // Cubes of side 10 contain both the point (1/4, ..) and its neighbour at (5, ..). In pbrt-v3 their side would be
    // 1/10.
    const std::string board =
        "Scale 10 10 10 Texture \"t\" \"spectrum\" \"checkerboard\" \"integer dimension\" 3\n"
        "Material \"diffuse\" \"texture reflectance\" \"t\" Identity\n";
    const auto scene = loadWorldV4(board + kTriangle);
    const auto at = [&](const Vec3& p) {
        TextureContext context;
        context.p = p;
        context.n = Vec3(0, 0, 1);
        Bsdf bsdf(Frame(), Vec3(0, 0, 1));
        scene->primitives[0].material->addLobes(context, Rgb(1.f), bsdf);
        return bsdf.albedo(Vec3(0, 0, 1)).x;
    };
    EXPECT_EQ(at(Vec3(1, 1, 1)), at(Vec3(9, 1, 1)));
    EXPECT_NE(at(Vec3(1, 1, 1)), at(Vec3(11, 1, 1)));
}

TEST(SceneFileV4, ColorSpaces) {
    const std::string grey = "Material \"diffuse\" \"rgb reflectance\" [.5 .5 .5]";
    expectNear(albedoOf("ColorSpace \"aces2065-1\" " + grey), Rgb(.5f), 1e-3f);
    expectNear(albedoOf("ColorSpace \"rec2020\" Material \"diffuse\" \"rgb reflectance\" [.5 .4 .3]"),
               Rgb(.5734f, .3884f, .2863f), 1e-3f);
    // The colour space is restored at the end of its block.
    expectNear(albedoOf("AttributeBegin ColorSpace \"rec2020\" AttributeEnd Material \"diffuse\" \"rgb reflectance\" "
                        "[.5 .4 .3]"),
               Rgb(.5f, .4f, .3f));
    const auto sky = [](const std::string& space) {
        return loadWorldV4("ColorSpace \"" + space + "\" LightSource \"infinite\" \"rgb L\" [1 1 1]")
            ->lights.at(0)
            ->escaped(Vec3(0.f), Vec3(0, 0, 1));
    };
    expectNear(sky("dci-p3"), Rgb(1.f), 1e-3f);
    EXPECT_GT(sky("aces2065-1").x, 1.02f);  // its white point is warmer
    EXPECT_THAT(errorOfWorldV4("ColorSpace \"rec2002\""),
                StartsWith("s.pbrt:2:12: unknown colour space 'rec2002'; did you mean 'rec2020'?"));
}

TEST(SceneFileV4, AttributesAreDefaultsOfWhatFollows) {
    const std::string world =
        "Attribute \"material\" \"rgb reflectance\" [.1 .2 .3] \"float roughness\" .3\nAttributeBegin\n"
        "Attribute \"material\" \"rgb reflectance\" [.4 .5 .6]\n";
    expectNear(albedoOf(world + "Material \"diffuse\"", ".", "AttributeEnd"), Rgb(.4f, .5f, .6f));
    expectNear(albedoOf(world + "AttributeEnd Material \"diffuse\""), Rgb(.1f, .2f, .3f));
    expectNear(albedoOf(world + "Material \"diffuse\" \"rgb reflectance\" [1 1 1]", ".", "AttributeEnd"), Rgb(1.f));
    std::unique_ptr<Scene> scene;
    EXPECT_EQ(warningsOf([&] {
                  scene = loadWorldV4(
                      "Attribute \"light\" \"float scale\" 3\nAttribute \"shape\" \"float radius\" 2\n"
                      "LightSource \"infinite\" Shape \"sphere\" " +
                      kTriangle);
              }),
              0)
        << "not everything need have what an attribute says";
    EXPECT_EQ(scene->lights[0]->escaped(Vec3(0.f), Vec3(0, 0, 1)), Rgb(3.f));
    EXPECT_NEAR(scene->primitives[0].shape->bounds().max.x, 2, 1e-5f);
    EXPECT_THAT(errorOfWorldV4("Attribute \"lights\" \"float scale\" 1"), HasSubstr("did you mean 'light'?"));
}

TEST(SceneFileV4, BilinearMeshes) {
    const auto scene = loadWorldV4(
        "Shape \"bilinearmesh\" \"point3 P\" [0 0 0 2 0 0 0 3 0 2 3 0]\nShape \"bilinearmesh\" \"integer indices\" "
        "[0 1 2 3 2 3 4 5] \"point3 P\" [0 0 0 1 0 0 0 1 0 1 1 0 0 2 0 1 2 0] \"float alpha\" 0\n"
        "Shape \"sphere\" \"float alpha\" 0");
    const TriangleMesh& one = *scene->primitives[0].mesh;
    ASSERT_EQ(one.triangleCount(), 2u);
    EXPECT_EQ(one.area(0) + one.area(1), 6);
    for (uint32_t i = 0; i < 2; ++i) EXPECT_EQ(one.geometricNormal(i), Vec3(0, 0, 1));
    for (size_t i = 0; i < 4; ++i) EXPECT_EQ(one.uvs[i], Vec2(one.positions[i].x / 2, one.positions[i].y / 3));
    // Patches that share vertices must each cover the whole range of (u, v).
    const TriangleMesh& two = *scene->primitives[1].mesh;
    EXPECT_EQ(two.triangleCount(), 4u);
    EXPECT_EQ(two.uvs[two.indices[6]], Vec2(0, 0));
    EXPECT_EQ(two.uvs[two.indices[2]], Vec2(1, 1));
    EXPECT_NE(scene->primitives[1].alpha, nullptr);
    EXPECT_NE(scene->primitives[2].alpha, nullptr);
    EXPECT_THAT(
        errorOfWorldV4("Shape \"bilinearmesh\" \"point3 P\" [0 0 0 2 0 0 0 3 0 2 3 0] \"integer indices\" [0 1 2]"),
        HasSubstr("four values a patch"));
    EXPECT_THAT(errorOfWorldV4("Shape \"trianglemesh\" \"point3 P\" [0 0 0 2 0 0 0 3 0 2 3 0]"),
                HasSubstr("needs the parameter 'indices'"));
}

TEST(SceneFileV4, ImportsAreIncludesThatLeaveNothingBehind) {
    const TemporaryFolder folder;
    folder.write("part.pbrt",
                 "Translate 1 0 0\nMaterial \"diffuse\" \"rgb reflectance\" [1 0 0]\nReverseOrientation\n" + kTriangle);
    const auto scene = loadWorldV4("Material \"diffuse\"\nImport \"part.pbrt\"\n" + kTriangle, folder.path());
    ASSERT_EQ(scene->primitives.size(), 2u);
    EXPECT_EQ(scene->primitives[0].mesh->positions[0].x, 1);
    EXPECT_EQ(scene->primitives[1].mesh->positions[0].x, 0);
    EXPECT_FALSE(scene->primitives[1].mesh->flipNormal);
    EXPECT_NE(scene->primitives[0].material, scene->primitives[1].material);
    // Unlike Import, Include leaves its changes of the graphics state in effect.
    EXPECT_EQ(loadWorldV4("Include \"part.pbrt\"\n" + kTriangle, folder.path())->primitives[1].mesh->positions[0].x, 1);
    folder.write("nested.pbrt", "Translate 0 1 0 Import \"part.pbrt\" " + kTriangle);
    EXPECT_EQ(loadWorldV4("Import \"nested.pbrt\" Import \"nested.pbrt\"", folder.path())->primitives.size(), 4u);
    folder.write("open.pbrt", "AttributeBegin\n");
    EXPECT_THAT(errorOfWorldV4("Import \"open.pbrt\"", folder.path()),
                HasSubstr("open.pbrt:1:1: the AttributeBegin is not ended in the imported file"));
    folder.write("close.pbrt", "AttributeEnd\n");
    EXPECT_THAT(errorOfWorldV4("AttributeBegin Import \"close.pbrt\" AttributeEnd", folder.path()),
                HasSubstr("close.pbrt:1:1: AttributeEnd without AttributeBegin in the imported file"));
    EXPECT_THAT(errorOfWorldV4("Import \"none.pbrt\"", folder.path()), HasSubstr("cannot find the file to include"));
}

}  // namespace
}  // namespace drc::pbrt
