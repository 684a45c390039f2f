// Names that are used before they are defined: pbrt-v4 looks them up when it has read the last file, pbrt-v3 at once.
#include "pbrt/later_names.h"

#include <gmock/gmock.h>

#include "pbrt/material_comparison.h"
#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kTriangle = "Shape \"trianglemesh\" \"integer indices\" [0 1 2] \"point3 P\" [0 0 0  1 0 0  0 1 0]\n";
const std::string kRed = "\"string type\" \"diffuse\" \"rgb reflectance\" [.8 .2 .1]\n";

void expectRed(const Scene& scene, size_t primitive = 0) {
    const Rgb albedo = albedoOf(scene.primitives.at(primitive)), red(.8f, .2f, .1f);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(albedo[i], red[i], 1e-5f);
}

// What is defined, and what uses it, in either order.
struct Case {
    std::string name, definition, use;
};
std::vector<Case> cases() {
    const std::string number = "Texture \"t\" \"float\" \"constant\" \"float value\" .3\n",
                      color = "Texture \"t\" \"spectrum\" \"constant\" \"rgb value\" [.8 .2 .1]\n",
                      named = "MakeNamedMaterial \"m\" " + kRed;
    return {
        {"named material", named, "NamedMaterial \"m\"\n" + kTriangle + kTriangle},
        {"material of a lamp", named,
         "AttributeBegin NamedMaterial \"m\" AreaLightSource \"diffuse\"\n" + kTriangle +
             "AttributeEnd LightSource \"point\"\n" + kTriangle},
        {"spectrum texture", color, "Material \"diffuse\" \"texture reflectance\" \"t\"\n" + kTriangle},
        {"float texture", number, "Material \"conductor\" \"texture roughness\" \"t\"\n" + kTriangle},
        {"displacement", number, "Material \"diffuse\" \"texture displacement\" \"t\"\n" + kTriangle},
        {"alpha", number, kTriangle + "\"texture alpha\" \"t\"\n"},
        {"shadow alpha", number, kTriangle + "\"texture shadowalpha\" \"t\" \"float alpha\" .5\n"},
        {"part of a texture", color,
         "Texture \"u\" \"spectrum\" \"scale\" \"texture tex\" \"t\" \"float scale\" .5\n"
         "Material \"diffuse\" \"texture reflectance\" \"u\"\n" +
             kTriangle},
        {"part of a mix", named,
         "MakeNamedMaterial \"n\" \"string type\" \"mix\" \"string materials\" [\"m\" \"m\"] \"float amount\" .5\n"
         "NamedMaterial \"n\"\n" +
             kTriangle},
        {"object", "ObjectBegin \"o\"\n" + kTriangle + "ObjectEnd\n", "Translate 1 0 0\nObjectInstance \"o\"\n"},
        {"medium", "MakeNamedMedium \"m\" \"string type\" \"homogeneous\"\n",
         "MediumInterface \"m\" \"\"\n" + kTriangle},
        {"emissive material", "MakeNamedMaterial \"m\" \"string type\" \"principled\" \"rgb emission\" [1 2 3]\n",
         "AttributeBegin NamedMaterial \"m\"\n" + kTriangle + "AttributeEnd LightSource \"point\"\n" + kTriangle},
    };
}

void expectSame(const Scene& a, const Scene& b, const std::string& name) {
    ASSERT_EQ(a.primitives.size(), b.primitives.size()) << name;
    ASSERT_EQ(a.lights.size(), b.lights.size()) << name;
    ASSERT_EQ(a.instances.size(), b.instances.size()) << name;
    for (size_t i = 0; i < a.primitives.size(); ++i) {
        const Primitive &p = a.primitives[i], &q = b.primitives[i];
        EXPECT_TRUE(alike(*p.material, *q.material)) << name;
        EXPECT_EQ(p.material->relief().heights == nullptr, q.material->relief().heights == nullptr) << name;
        EXPECT_EQ(p.areaLight == nullptr, q.areaLight == nullptr) << name;
        EXPECT_EQ(p.media.changes(), q.media.changes()) << name;
        for (const auto mask : {&Primitive::alpha, &Primitive::shadowAlpha}) {
            ASSERT_EQ(p.*mask == nullptr, q.*mask == nullptr) << name;
            if (p.*mask) {
                EXPECT_EQ((p.*mask)->eval({}), (q.*mask)->eval({})) << name;
            }
        }
        EXPECT_EQ(p.alphaIsShare, q.alphaIsShare) << name;
    }
    // Lights have the same order, which decides by which random numbers they are sampled.
    for (size_t i = 0; i < a.lights.size(); ++i) EXPECT_EQ(a.lights[i]->isDelta(), b.lights[i]->isDelta()) << name;
}

TEST(LaterNames, TheOrderOfADefinitionAndItsUseDoesNotMatterInV4) {
    const TemporaryFolder folder;
    for (const Case& c : cases()) {
        std::unique_ptr<Scene> before, after;
        EXPECT_EQ(saidBy([&] { before = loadWorldV4(c.definition + c.use); }), "") << c.name;
        EXPECT_EQ(saidBy([&] { after = loadWorldV4("AttributeBegin\n" + c.use + "AttributeEnd\n" + c.definition); }),
                  "")
            << c.name;
        expectSame(*before, *after, c.name);
        folder.write("late.pbrt", c.definition);
        for (const std::string& include : std::vector<std::string>{"Include", "Import"})
            expectSame(
                *before,
                *loadWorldV4("AttributeBegin " + c.use + " AttributeEnd " + include + " \"late.pbrt\"", folder.path()),
                c.name + " by " + include);
        EXPECT_THAT(errorOfWorldV4(c.use), StartsWith("s.pbrt:")) << c.name;
    }
}

TEST(LaterNames, WhatIsUsedCountsWhereItStands) {
    // Of the place of use count the transformation, the light and the side; of that of the definition the defaults.
    const auto scene = loadWorldV4(
        "AttributeBegin\nTranslate 1 0 0 ReverseOrientation AreaLightSource \"diffuse\"\nNamedMaterial \"m\"\n"
        "Attribute \"material\" \"rgb reflectance\" [.1 .1 .9]\n" +
        kTriangle +
        "AttributeEnd\nAttributeBegin Attribute \"material\" \"rgb reflectance\" [.8 .2 .1]\n"
        "MakeNamedMaterial \"m\" \"string type\" \"diffuse\"\nAttributeEnd\n");
    expectRed(*scene);
    EXPECT_EQ(scene->primitives[0].mesh->positions[0].x, 1);
    EXPECT_TRUE(scene->primitives[0].mesh->flipNormal);
    EXPECT_NE(scene->primitives[0].areaLight, nullptr);
}

TEST(LaterNames, ChainsInTheWrongOrder) {
    std::string chain = "Material \"diffuse\" \"texture reflectance\" \"t0\"\n" + kTriangle;
    const auto link = [](int i) { return "\"t" + std::to_string(i) + "\""; };
    for (int i = 0; i < 50; ++i)
        chain += "Texture " + link(i) + " \"spectrum\" \"scale\" \"texture tex\" " + link(i + 1) + "\n";
    expectRed(*loadWorldV4(chain + "Texture " + link(50) + " \"spectrum\" \"constant\" \"rgb value\" [.8 .2 .1]\n"));
}

TEST(LaterNames, ErrorsNameThePlaceOfUse) {
    EXPECT_EQ(errorOfWorldV4(kTriangle + "NamedMaterial \"wod\"\n" + kTriangle + "MakeNamedMaterial \"wood\" " + kRed),
              "s.pbrt:3:15: no material 'wod' has been named; did you mean 'wood'?\n"
              "    NamedMaterial \"wod\"\n"
              "                  ^");
    EXPECT_THAT(
        errorOfWorldV4("Material \"diffuse\" \"texture reflectance\" \"t\"\n" + kTriangle +
                       "Texture \"t\" \"float\" \"constant\"\n"),
        StartsWith("s.pbrt:2:42: no spectrum texture 't' has been defined; the texture of that name has the other "
                   "type"));
    EXPECT_THAT(errorOfWorldV4(kTriangle + "\"texture alpha\" \"leaf\""),
                StartsWith("s.pbrt:3:17: no float texture 'leaf' has been defined"));
    EXPECT_THAT(errorOfWorldV4("ObjectInstance \"o\""), StartsWith("s.pbrt:2:16: no object 'o' has been defined"));
    // The first of several, although the second was tried before it.
    EXPECT_THAT(errorOfWorldV4("NamedMaterial \"a\"\n" + kTriangle + "NamedMaterial \"b\"\n" + kTriangle),
                StartsWith("s.pbrt:2:15: no material 'a'"));
}

TEST(LaterNames, CirclesAreErrors) {
    EXPECT_THAT(errorOfWorldV4("Texture \"a\" \"spectrum\" \"scale\" \"texture tex\" \"b\"\n"
                               "Texture \"b\" \"spectrum\" \"scale\" \"texture tex\" \"a\"\n"
                               "Material \"diffuse\" \"texture reflectance\" \"a\"\n" +
                               kTriangle),
                StartsWith("s.pbrt:2:46: the spectrum texture 'a' is made of itself: 'a' uses 'b' uses 'a'"));
    EXPECT_THAT(errorOfWorldV4("NamedMaterial \"m\"\n" + kTriangle +
                               "MakeNamedMaterial \"m\" \"string type\" \"mix\" \"string materials\" [\"m\" \"m\"]\n"),
                AllOf(StartsWith("s.pbrt:4:"), HasSubstr("the material 'm' is made of itself: 'm' uses 'm'")));
}

TEST(LaterNames, WhatIsDefinedTwiceWarnsInV4) {
    const std::string again = "MakeNamedMaterial \"m\" " + kRed + "MakeNamedMaterial \"m\" " + kRed +
                              "Texture \"t\" \"float\" \"constant\"\nTexture \"t\" \"float\" \"constant\"\n"
                              "Texture \"t\" \"spectrum\" \"constant\"\n";
    EXPECT_EQ(
        warningsOfWorldV4(again),
        "drc: s.pbrt:3:19: warning: a material 'm' has been defined before, which pbrt-v4 refuses; this one counts "
        "for what comes after it\n"
        "drc: s.pbrt:5:21: warning: a float texture 't' has been defined before, which pbrt-v4 refuses; this one "
        "counts for what comes after it\n");
}

TEST(LaterNames, NamesThatLookAlikeAreTheSameInV4) {
    const std::string composed =
                          "M\xC3\xB6"
                          "bel \xC3\xA9",
                      decomposed =
                          "Mo\xCC\x88"
                          "bel e\xCC\x81";
    const std::string definition = "\" " + kRed, use = "\"\n" + kTriangle;
    for (const bool swapped : {false, true}) {
        const std::string& a = swapped ? decomposed : composed;
        const std::string& b = swapped ? composed : decomposed;
        expectRed(*loadWorldV4("MakeNamedMaterial \"" + a + definition + "NamedMaterial \"" + b + use));
        expectRed(*loadWorldV4("Texture \"" + a + "\" \"spectrum\" \"constant\" \"rgb value\" [.8 .2 .1]\n" +
                               "Material \"diffuse\" \"texture reflectance\" \"" + b + use));
        expectRed(*loadWorldV4("MakeNamedMaterial \"" + a + definition + "Material \"mix\" \"string materials\" [\"" +
                               b + "\" \"" + a + "\"]\n" + kTriangle));
        EXPECT_EQ(loadWorldV4("ObjectBegin \"" + a + use + "ObjectEnd ObjectInstance \"" + b + "\"")->instances.size(),
                  1u);
        EXPECT_EQ(
            warningsOfWorldV4("CoordinateSystem \"" + a + "\" CoordSysTransform \"" + b + "\"\nMakeNamedMedium \"" + a +
                              "\" \"string type\" \"homogeneous\" MediumInterface \"" + b + use),
            "");
        EXPECT_THAT(
            warningsOfWorld("MakeNamedMaterial \"" + a + "\" \"string type\" \"matte\" NamedMaterial \"" + b + use),
            HasSubstr("has been named; the material before it stays"))
            << "pbrt-v3 compares bytes";
    }
    const std::string latin =
        "M\xF6"
        "bel";  // no UTF-8
    expectRed(*loadWorldV4("MakeNamedMaterial \"" + latin + definition + "NamedMaterial \"" + latin + use));
}

// In pbrt-v3 a name must be defined before it is used. Where it is not, pbrt says so and goes on.
TEST(LaterNames, V3WarnsAndGoesOn) {
    const std::string red = "MakeNamedMaterial \"m\" \"string type\" \"matte\" \"rgb Kd\" [.8 .2 .1]\n";
    std::unique_ptr<Scene> scene;
    EXPECT_EQ(saidBy([&] {
                  scene = loadWorld("Material \"matte\" \"rgb Kd\" [.8 .2 .1]\nNamedMaterial \"later\"\n" + kTriangle +
                                    "MakeNamedMaterial \"later\" \"string type\" \"mirror\"\n");
              }),
              "drc: s.pbrt:3:15: warning: no material 'later' has been named; the material before it stays\n");
    expectRed(*scene);
    EXPECT_THAT(
        saidBy([&] { scene = loadWorld("Material \"matte\" \"texture Kd\" \"t\"\n" + kTriangle); }),
        StartsWith("drc: s.pbrt:2:31: warning: no spectrum texture 't' has been defined; the default of 'Kd' of "
                   "material 'matte' counts"));
    EXPECT_EQ(albedoOf(scene->primitives[0]), Rgb(.5f));
    EXPECT_THAT(saidBy([&] { scene = loadWorld(kTriangle + "\"texture alpha\" \"t\"\n"); }),
                HasSubstr("s.pbrt:3:17: warning: no float texture 't' has been defined; the default of 'alpha'"));
    EXPECT_EQ(scene->primitives[0].alpha, nullptr);
    EXPECT_THAT(saidBy([&] {
                    scene = loadWorld(red +
                                      "Material \"mix\" \"string namedmaterial1\" \"m\" \"string namedmaterial2\" "
                                      "\"n\" \"rgb amount\" [1 1 1]\n" +
                                      kTriangle);
                }),
                HasSubstr("warning: the mix material's namedmaterial2 'n' has not been defined; 'matte' is mixed"));
    expectRed(*scene);
}

// An empty name names no texture and no file, where pbrt takes it so.
TEST(LaterNames, EmptyNamesAreNone) {
    std::unique_ptr<Scene> scene;
    const auto load = [&](const std::string& world, bool v4) {
        EXPECT_EQ(saidBy([&] { scene = v4 ? loadWorldV4(world + kTriangle) : loadWorld(world + kTriangle); }), "")
            << world;
        return scene->primitives.at(0).material;
    };
    EXPECT_FALSE(load("Material \"matte\" \"texture bumpmap\" \"\"\n", false)->relief().heights);
    EXPECT_FALSE(load("Material \"diffuse\" \"string normalmap\" \"\"\n", true)->relief().normals);
    EXPECT_FALSE(load("Material \"diffuse\" \"texture displacement\" \"\"\n", true)->relief().heights);
    load("Material \"matte\" \"texture Kd\" \"\" \"rgb Kd\" [.8 .2 .1]\n", false);
    expectRed(*scene);
    load("Attribute \"material\" \"texture reflectance\" \"gone\"\nMaterial \"diffuse\" \"texture reflectance\" \"\"\n",
         true);
    EXPECT_EQ(albedoOf(scene->primitives[0]), Rgb(.5f)) << "it takes back what Attribute has set";
    load("LightSource \"infinite\" \"string mapname\" \"\"\n", false);
    load("LightSource \"infinite\" \"string filename\" \"\"\n", true);
    EXPECT_EQ(warningsOfWorld(kTriangle + "\"texture alpha\" \"\" \"texture shadowalpha\" \"\"\n"), "");
    EXPECT_EQ(loadPbrtString("Film \"rgb\" \"string filename\" \"\" WorldBegin", ".")->sensor.settings.outputFile,
              "pbrt.exr");
    EXPECT_THAT(errorOfWorldV4("Texture \"t\" \"float\" \"imagemap\" \"string filename\" \"\""),
                HasSubstr("parameter 'filename' of texture 't' is empty; it must name a file"));
    EXPECT_THAT(errorOfWorldV4("Shape \"plymesh\" \"string filename\" \"\""), HasSubstr("it must name a file"));
}

}  // namespace
}  // namespace drc::pbrt
