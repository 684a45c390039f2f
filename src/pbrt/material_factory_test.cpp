#include "pbrt/material_factory.h"

#include <gmock/gmock.h>

#include "pbrt/material_factory_testing.h"

namespace drc::pbrt {
namespace {

using testing::HasSubstr;

const MaterialLoader kLoader(Dialect::V3);

MaterialPtr load(const std::string& type, const std::string& parameters, const std::string& before = "") {
    return kLoader.load(type, parameters, before);
}
int warningsOf(const std::string& type, const std::string& parameters) { return kLoader.warningsOf(type, parameters); }

TEST(MaterialFactory, Defaults) {
    const DefaultsCase kAll[] = {
        {"matte", "\"rgb Kd\" [.5 .5 .5] \"float sigma\" 0"},
        {"plastic",
         "\"rgb Kd\" [.25 .25 .25] \"rgb Ks\" [.25 .25 .25] \"float roughness\" .1 \"bool remaproughness\" "
         "\"true\""},
        {"metal",
         "\"float roughness\" .01 \"float uroughness\" .01 \"float vroughness\" .01 \"bool remaproughness\" "
         "\"true\" \"rgb eta\" [.2004377 .9240334 1.1022120] \"rgb k\" [3.9129485 2.4528477 2.1421880]"},
        {"mirror", "\"rgb Kr\" [.9 .9 .9]"},
        {"glass",
         "\"rgb Kr\" [1 1 1] \"rgb Kt\" [1 1 1] \"float eta\" 1.5 \"float uroughness\" 0 \"float vroughness\" "
         "0 \"bool remaproughness\" \"true\""},
        {"uber",
         "\"rgb Kd\" [.25 .25 .25] \"rgb Ks\" [.25 .25 .25] \"rgb Kr\" [0 0 0] \"rgb Kt\" [0 0 0] "
         "\"rgb opacity\" [1 1 1] \"float roughness\" .1 \"float uroughness\" .1 \"float vroughness\" .1 "
         "\"float eta\" 1.5 \"bool remaproughness\" \"true\""},
        {"substrate",
         "\"rgb Kd\" [.5 .5 .5] \"rgb Ks\" [.5 .5 .5] \"float uroughness\" .1 \"float vroughness\" .1 "
         "\"bool remaproughness\" \"true\""},
        {"translucent",
         "\"rgb Kd\" [.25 .25 .25] \"rgb Ks\" [.25 .25 .25] \"rgb reflect\" [.5 .5 .5] "
         "\"rgb transmit\" [.5 .5 .5] \"float roughness\" .1 \"bool remaproughness\" \"true\""},
        {"disney",
         "\"rgb color\" [.5 .5 .5] \"float metallic\" 0 \"float eta\" 1.5 \"float roughness\" .5 "
         "\"float speculartint\" 0 \"float anisotropic\" 0 \"float sheen\" 0 \"float sheentint\" .5 "
         "\"float clearcoat\" 0 \"float clearcoatgloss\" 1 \"float spectrans\" 0 \"rgb scatterdistance\" "
         "[0 0 0] \"bool thin\" \"false\" \"float flatness\" 0 \"float difftrans\" 1"},
        {"hair",
         "\"float eumelanin\" 1.3 \"float pheomelanin\" 0 \"float eta\" 1.55 \"float beta_m\" .3 "
         "\"float beta_n\" .3 \"float alpha\" 2"},
        {"subsurface",
         "\"rgb sigma_a\" [.0011 .0024 .014] \"rgb sigma_s\" [2.55 3.21 3.77] \"float g\" 0 \"float scale\" 1 "
         "\"float eta\" 1.33 \"rgb Kr\" [1 1 1] \"rgb Kt\" [1 1 1] \"float uroughness\" 0 "
         "\"float vroughness\" 0 \"bool remaproughness\" \"true\""},
        {"kdsubsurface",
         "\"rgb Kd\" [.5 .5 .5] \"rgb mfp\" [1 1 1] \"float g\" 0 \"float scale\" 1 \"float eta\" 1.33 "
         "\"rgb Kr\" [1 1 1] \"rgb Kt\" [1 1 1] \"float uroughness\" 0 \"float vroughness\" 0 "
         "\"bool remaproughness\" \"true\""},
    };
    for (const DefaultsCase& c : kAll) checkDefaults(kLoader, c);
}

TEST(MaterialFactory, EveryParameterCountsAndMayBeATexture) {
    const ParameterCase kCases[] = {
        {"matte", "", "sigma", "Kd"},
        {"plastic", "", "roughness", "Kd Ks"},
        {"metal", "", "roughness uroughness vroughness", "eta k"},
        {"mirror", "", "", "Kr"},
        {"glass", "", "eta index uroughness vroughness", "Kr Kt"},
        {"glass", "\"float uroughness\" .1", "eta index vroughness", "Kr Kt"},
        {"uber", "\"rgb Kt\" [.1 .2 .1]", "roughness uroughness vroughness eta index", "Kd Ks Kr opacity"},
        {"uber", "", "", "Kt"},
        {"substrate", "", "uroughness vroughness", "Kd Ks"},
        {"translucent", "", "roughness", "Kd Ks reflect transmit"},
        {"disney", "\"float sheen\" .4 \"float clearcoat\" .4 \"float metallic\" .2 \"rgb color\" [.2 .4 .1]",
         "eta roughness speculartint anisotropic sheentint clearcoatgloss spectrans", ""},
        {"disney", "", "metallic sheen clearcoat", "color"},
        {"disney", "\"bool thin\" \"true\"", "flatness difftrans spectrans", ""},
        {"hair", "", "eumelanin pheomelanin eta beta_m beta_n alpha", "sigma_a color"},
        {"subsurface", "", "uroughness vroughness", "sigma_a sigma_s Kr Kt"},
        {"kdsubsurface", "", "uroughness vroughness", "Kd Kr Kt"},
    };
    for (const ParameterCase& c : kCases) checkParameters(kLoader, c);
}

TEST(MaterialFactory, RoughnessIsRemappedUnlessToldNotTo) {
    for (const std::string type :
         {"plastic", "metal", "glass", "uber", "substrate", "translucent", "subsurface", "kdsubsurface"}) {
        const std::string rough = type == "glass" || type == "substrate" || type.ends_with("subsurface")
                                      ? "\"float uroughness\" .3 \"float vroughness\" .3"
                                      : "\"float roughness\" .3";
        const MaterialPtr remapped = load(type, rough);
        EXPECT_TRUE(alike(*remapped, *load(type, rough + " \"bool remaproughness\" \"true\""))) << type;
        EXPECT_FALSE(alike(*remapped, *load(type, rough + " \"bool remaproughness\" \"false\""))) << type;
    }
}

TEST(MaterialFactory, RoughnessAlongUAndV) {
    for (const std::string type : {"metal", "glass", "uber", "substrate", "subsurface", "kdsubsurface"}) {
        const MaterialPtr u = load(type, "\"float uroughness\" .1 \"float vroughness\" .4");
        const MaterialPtr v = load(type, "\"float uroughness\" .4 \"float vroughness\" .1");
        EXPECT_FALSE(alike(*u, *v)) << type;
    }
    // The vroughness of uber defaults to its uroughness, that of metal to its roughness.
    EXPECT_TRUE(alike(*load("uber", "\"float uroughness\" .4"),
                      *load("uber", "\"float uroughness\" .4 \"float vroughness\" .4")));
    EXPECT_TRUE(alike(*load("metal", "\"float uroughness\" .4"),
                      *load("metal", "\"float uroughness\" .4 \"float vroughness\" .01")));
}

TEST(MaterialFactory, IndexHasTwoNames) {
    for (const char* type : {"glass", "uber"}) {
        EXPECT_TRUE(alike(*load(type, "\"float index\" 1.3"), *load(type, "\"float eta\" 1.3"))) << type;
        EXPECT_TRUE(alike(*load(type, "\"float index\" 1.7 \"float eta\" 1.3"), *load(type, "\"float eta\" 1.3")));
    }
}

TEST(MaterialFactory, AllTakeABumpMap) {
    for (const char* type : {"matte", "plastic", "metal", "mirror", "glass", "uber", "substrate", "translucent",
                             "disney", "hair", "subsurface", "kdsubsurface"})
        checkBump(kLoader, type, "bumpmap");
}

const std::string kParts =
    "MakeNamedMaterial \"a\" \"string type\" \"matte\" \"rgb Kd\" [.2 .4 .6]\n"
    "MakeNamedMaterial \"b\" \"string type\" \"mirror\"\nMakeNamedMaterial \"n\" \"string type\" \"none\"\n";

TEST(MaterialFactory, Mix) {
    const std::string names = "\"string namedmaterial1\" \"a\" \"string namedmaterial2\" \"b\" ";
    const MaterialPtr half = load("mix", names, kParts);
    EXPECT_TRUE(alike(*half, *load("mix", names + "\"rgb amount\" [.5 .5 .5]", kParts)));
    // The amount is the weight of the first material.
    EXPECT_TRUE(alike(*load("matte", "\"rgb Kd\" [.2 .4 .6]"), *load("mix", names + "\"rgb amount\" [1 1 1]", kParts)));
    EXPECT_TRUE(alike(*load("mirror", ""), *load("mix", names + "\"rgb amount\" [0 0 0]", kParts)));
    const std::string texture = "Texture \"t\" \"spectrum\" \"constant\" \"rgb value\" [.1 .5 .9]\n";
    EXPECT_TRUE(alike(*load("mix", names + "\"rgb amount\" [.1 .5 .9]", kParts),
                      *load("mix", names + "\"texture amount\" \"t\"", kParts + texture)));
    // A mix can be named and mixed again.
    const std::string again = kParts + "MakeNamedMaterial \"m\" \"string type\" \"mix\" " + names + "\n";
    const MaterialPtr twice = load("mix", "\"string namedmaterial1\" \"m\" \"string namedmaterial2\" \"a\"", again);
    EXPECT_EQ(twice->maxLobes(), 3);
}

TEST(MaterialFactory, MixErrors) {
    const auto error = [](const std::string& text) { return errorOfWorld(kParts + "Material \"mix\" " + text); };
    EXPECT_THAT(warningsOfWorld(kParts + "Material \"mix\" \"string namedmaterial1\" \"a\""),
                HasSubstr("namedmaterial2 '' has not been defined; 'matte' is mixed in its place"));
    EXPECT_THAT(error("\"string namedmaterial1\" \"a\" \"string namedmaterial2\" \"n\""), HasSubstr("'n' is 'none'"));
    const auto mixOf = [](const std::string& name, const std::string& a, const std::string& b) {
        return "MakeNamedMaterial \"" + name + "\" \"string type\" \"mix\" \"string namedmaterial1\" \"" + a +
               "\" \"string namedmaterial2\" \"" + b + "\"\n";
    };
    const std::string uber = "MakeNamedMaterial \"u\" \"string type\" \"uber\"\n";
    EXPECT_EQ(errorOfWorld(uber + mixOf("m", "u", "u")), "");
    EXPECT_EQ(errorOfWorld(uber + mixOf("m", "u", "u") + mixOf("o", "m", "u")), "");
    EXPECT_THAT(errorOfWorld(uber + mixOf("m", "u", "u") + mixOf("o", "m", "m")),
                HasSubstr("s.pbrt:4:19: the mix has up to 20 lobes, which is more than the 16"));
}

TEST(MaterialFactory, SubsurfaceMedia) {
    const std::string skin = "\"rgb sigma_s\" [.74 .88 1.01] \"rgb sigma_a\" [.032 .17 .48] ";
    EXPECT_TRUE(alike(*load("subsurface", "\"string name\" \"Skin1\""), *load("subsurface", skin)));
    EXPECT_TRUE(alike(*load("subsurface", "\"string name\" \"Skin1\" \"float g\" .9"), *load("subsurface", skin)));
    EXPECT_FALSE(alike(*load("subsurface", skin + "\"float g\" .9"), *load("subsurface", skin)));
    EXPECT_FALSE(alike(*load("subsurface", skin + "\"float eta\" 1.5"), *load("subsurface", skin)));
    EXPECT_FALSE(alike(*load("kdsubsurface", "\"float eta\" 1.5"), *load("kdsubsurface", "")));
    // As in pbrt, the other parameters count if the name is not known.
    EXPECT_TRUE(alike(*load("subsurface", skin + "\"string name\" \"Skin7\""), *load("subsurface", skin)));
    EXPECT_EQ(warningsOf("subsurface", "\"string name\" \"Skin7\""), 1);
    // How far light spreads does not change how much of it comes back.
    EXPECT_TRUE(alike(*load("subsurface", skin + "\"float scale\" 9"), *load("subsurface", skin)));
    EXPECT_TRUE(alike(*load("kdsubsurface", "\"rgb mfp\" [2 1 3] \"float scale\" 7 \"float g\" .5"),
                      *load("kdsubsurface", "")));
}

TEST(MaterialFactory, SubsurfaceScatteringIsAWarning) {
    EXPECT_EQ(warningsOf("disney", "\"rgb scatterdistance\" [.1 .1 .1]"), 1);
    EXPECT_EQ(warningsOf("disney", "\"rgb scatterdistance\" [0 0 0]"), 0);
    EXPECT_TRUE(alike(*load("disney", "\"rgb scatterdistance\" [.1 .1 .1]"), *load("disney", "")));
}

TEST(MaterialFactory, HairHasOneColour) {
    const std::string sigma = "\"rgb sigma_a\" [.3 .4 .5] ", color = "\"rgb color\" [.6 .3 .1] ";
    EXPECT_EQ(warningsOf("hair", sigma + color + "\"float eumelanin\" 3"), 2);
    EXPECT_TRUE(alike(*load("hair", sigma + color + "\"float eumelanin\" 3"), *load("hair", sigma)));
    EXPECT_EQ(warningsOf("hair", color + "\"float pheomelanin\" 3"), 1);
    EXPECT_EQ(warningsOf("hair", "\"float pheomelanin\" 3 \"float eumelanin\" 3"), 0);
}

TEST(MaterialFactory, WrongParametersAndTypesAreReported) {
    EXPECT_EQ(
        warningsOfWorld("Material \"disney\" \"rgb metallic\" [1 1 1]"),
        "drc: s.pbrt:2:19: warning: parameter 'metallic' of material 'disney' must be of type 'float' or 'texture', "
        "not 'rgb'; ignored\n");
    EXPECT_THAT(warningsOfWorld("Material \"disney\" \"string thin\" \"true\""), HasSubstr("must be of type 'bool'"));
    EXPECT_THAT(errorOfWorld("Material \"disnee\""), HasSubstr("did you mean 'disney'?"));
}

}  // namespace
}  // namespace drc::pbrt
