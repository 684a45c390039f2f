#include "pbrt/material_factory_v4.h"

#include <gmock/gmock.h>

#include "pbrt/material_factory_testing.h"

namespace drc::pbrt {
namespace {

using testing::HasSubstr;

const MaterialLoader kLoader(Dialect::V4);

MaterialPtr load(const std::string& type, const std::string& parameters, const std::string& before = "") {
    return kLoader.load(type, parameters, before);
}
int warningsOf(const std::string& type, const std::string& parameters) { return kLoader.warningsOf(type, parameters); }
std::string errorOfMaterial(const std::string& type, const std::string& parameters, const std::string& before = "") {
    return errorOf([&] { load(type, parameters, before); });
}

TEST(MaterialFactoryV4, Defaults) {
    const std::string copper = "eta\" [.2004377 .9240334 1.1022120] ", copperK = "k\" [3.9129485 2.4528477 2.1421880] ";
    const DefaultsCase kAll[] = {
        {"diffuse", "\"rgb reflectance\" [.5 .5 .5]"},
        {"diffusetransmission",
         "\"rgb reflectance\" [.25 .25 .25] \"rgb transmittance\" [.25 .25 .25] \"float scale\" 1"},
        {"dielectric", "\"float eta\" 1.5 \"float roughness\" 0 \"bool remaproughness\" \"true\""},
        {"thindielectric", "\"float eta\" 1.5"},
        {"conductor",
         "\"rgb " + copper + "\"rgb " + copperK + "\"float roughness\" 0 \"bool remaproughness\" \"true\""},
        {"coateddiffuse",
         "\"rgb reflectance\" [.5 .5 .5] \"float roughness\" 0 \"float eta\" 1.5 \"float thickness\" .01 "
         "\"rgb albedo\" [0 0 0] \"float g\" 0 \"integer maxdepth\" 10 \"integer nsamples\" 1 "
         "\"bool remaproughness\" \"true\""},
        {"coatedconductor",
         "\"rgb conductor." + copper + "\"rgb conductor." + copperK +
             "\"float conductor.roughness\" 0 \"float interface.roughness\" 0 "
             "\"float interface.eta\" 1.5 \"float thickness\" .01 \"rgb albedo\" [0 0 0] \"float g\" 0"},
        {"hair",
         "\"float eumelanin\" 1.3 \"float eta\" 1.55 \"float beta_m\" .3 \"float beta_n\" .3 \"float alpha\" 2"},
        {"subsurface",
         "\"rgb sigma_a\" [.0011 .0024 .014] \"rgb sigma_s\" [2.55 3.21 3.77] \"float g\" 0 \"float scale\" 1 "
         "\"rgb mfp\" [1 1 1] \"float eta\" 1.33 \"float roughness\" 0 \"bool remaproughness\" \"true\""},
    };
    for (const DefaultsCase& c : kAll) {
        checkDefaults(kLoader, c);
        checkBump(kLoader, c.type, "displacement");
        EXPECT_THAT(errorOf([&] { load(c.type, "\"string normalmap\" \"n.png\""); }),
                    testing::HasSubstr("cannot find the normal map 'n.png'"))
            << c.type;
    }
}

TEST(MaterialFactoryV4, EveryParameterCountsAndMayBeATexture) {
    const ParameterCase kCases[] = {
        {"diffuse", "", "diffuseroughness", "reflectance"},
        {"principled", "", "diffuseroughness", "basecolor"},
        {"principled", "\"float transmission\" 1", "roughness ior", "basecolor reflectiontint"},
        {"diffusetransmission", "", "", "reflectance transmittance"},
        {"dielectric", "", "eta roughness uroughness vroughness", ""},
        {"thindielectric", "", "eta", ""},
        {"conductor", "", "roughness uroughness vroughness", "eta k reflectance"},
        {"coateddiffuse", "", "roughness uroughness vroughness thickness", "reflectance albedo"},
        {"coateddiffuse", "\"rgb albedo\" [.5 .5 .5]", "g", ""},
        {"coatedconductor", "",
         "interface.roughness interface.uroughness interface.vroughness thickness "
         "conductor.roughness conductor.uroughness conductor.vroughness",
         "conductor.eta conductor.k reflectance albedo"},
        {"coatedconductor", "\"rgb albedo\" [.5 .5 .5]", "g", ""},
        {"hair", "", "eumelanin pheomelanin eta beta_m beta_n alpha", "sigma_a reflectance"},
        {"subsurface", "", "roughness uroughness vroughness", "reflectance"},
    };
    for (const ParameterCase& c : kCases) checkParameters(kLoader, c);
}

TEST(MaterialFactoryV4, RoughnessIsTheSquareOfAlphaUnlessToldNotTo) {
    const struct {
        std::string type, prefix;
    } kAll[] = {{"dielectric", ""},
                {"conductor", ""},
                {"coateddiffuse", ""},
                {"coatedconductor", "conductor."},
                {"subsurface", ""}};
    for (const auto& [type, prefix] : kAll) {
        const std::string name = "\"float " + prefix + "roughness\" ";
        const MaterialPtr remapped = load(type, name + ".09");
        EXPECT_TRUE(alike(*remapped, *load(type, name + ".3 \"bool remaproughness\" \"false\""))) << type;
        EXPECT_FALSE(alike(*remapped, *load(type, name + ".09 \"bool remaproughness\" \"false\""))) << type;
        const MaterialPtr u = load(type, name + ".09 \"float " + prefix + "uroughness\" .3");
        EXPECT_FALSE(alike(*u, *load(type, name + ".09 \"float " + prefix + "vroughness\" .3"))) << type;
    }
}

TEST(MaterialFactoryV4, Interfaces) {
    for (const char* type : {"", "none", "interface"}) EXPECT_EQ(load(type, "\"float x\" 1"), nullptr) << type;
}

TEST(MaterialFactoryV4, Mix) {
    const std::string parts =
        "MakeNamedMaterial \"a\" \"string type\" \"diffuse\"\nMakeNamedMaterial \"b\" \"string type\" \"conductor\"\n"
        "MakeNamedMaterial \"gone\" \"string type\" \"interface\"\n"
        "Texture \"t\" \"float\" \"constant\" \"float value\" .7\n";
    const auto mix = [&](const std::string& parameters) { return load("mix", parameters, parts); };
    const auto error = [&](const std::string& parameters) { return errorOfMaterial("mix", parameters, parts); };
    const std::string names = "\"string materials\" [\"a\" \"b\"] ";
    // The amount is the weight of the second material.
    EXPECT_TRUE(alike(*mix(names + "\"float amount\" 0"), *load("diffuse", "")));
    EXPECT_TRUE(alike(*mix(names + "\"float amount\" 1"), *load("conductor", "")));
    EXPECT_TRUE(alike(*mix(names), *mix(names + "\"float amount\" .5")));
    EXPECT_TRUE(alike(*mix(names + "\"texture amount\" \"t\""), *mix(names + "\"float amount\" .7")));
    EXPECT_THAT(error(""), HasSubstr("needs the parameter \"string materials\""));
    EXPECT_THAT(error("\"string materials\" [\"a\"]"), HasSubstr("must have two materials' names, not 1"));
    EXPECT_THAT(error("\"string materials\" [\"a\" \"c\"]"),
                HasSubstr("the mix material's second of 'materials' 'c' has not been defined"));
    EXPECT_THAT(error("\"string materials\" [\"gone\" \"a\"]"), HasSubstr("'gone' is 'none'"));
}

TEST(MaterialFactoryV4, SubsurfaceMedia) {
    const std::string marble = "\"rgb sigma_s\" [2.19 2.62 3] \"rgb sigma_a\" [.0021 .0041 .0071] ";
    EXPECT_TRUE(alike(*load("subsurface", "\"string name\" \"Marble\""), *load("subsurface", marble)));
    EXPECT_FALSE(alike(*load("subsurface", marble + "\"float g\" .8"), *load("subsurface", marble)));
    EXPECT_FALSE(alike(*load("subsurface", marble + "\"float eta\" 1.5"), *load("subsurface", marble)));
    // How far light spreads does not change how much of it comes back.
    EXPECT_TRUE(alike(*load("subsurface", marble + "\"float scale\" 9"), *load("subsurface", marble)));
    EXPECT_EQ(warningsOf("subsurface", "\"string name\" \"Marble\" \"float g\" .5"), 1);
    EXPECT_TRUE(alike(*load("subsurface", "\"float reflectance\" .4 \"rgb mfp\" [1 2 3]"),
                      *load("subsurface", "\"rgb reflectance\" [.4 .4 .4]")));
    EXPECT_THAT(errorOfMaterial("subsurface", "\"string name\" \"Marbel\""),
                HasSubstr("unknown medium 'Marbel'; did you mean 'Marble'?"));
    EXPECT_THAT(errorOfMaterial("subsurface", marble + "\"rgb reflectance\" [.5 .5 .5]"),
                HasSubstr("has both 'reflectance' and 'sigma_a' or 'sigma_s'"));
    EXPECT_THAT(errorOfMaterial("subsurface", "\"rgb sigma_a\" [1 1 1]"), HasSubstr("has only one of"));
}

TEST(MaterialFactoryV4, NumbersForGreysAndSpectraForIndices) {
    EXPECT_TRUE(
        alike(*load("diffuse", "\"float reflectance\" .3"), *load("diffuse", "\"rgb reflectance\" [.3 .3 .3]")));
    EXPECT_TRUE(
        alike(*load("dielectric", "\"spectrum eta\" [400 1.7 700 1.7]"), *load("dielectric", "\"float eta\" 1.7")));
    EXPECT_FALSE(alike(*load("dielectric", "\"spectrum eta\" \"glass-F11\""), *load("dielectric", "")));
    EXPECT_FALSE(alike(*load("conductor", "\"spectrum eta\" \"metal-Au-eta\" \"spectrum k\" \"metal-Au-k\""),
                       *load("conductor", "")));
    EXPECT_EQ(warningsOf("conductor", "\"spectrum eta\" \"metal-CuZn-eta\""), 0);
    EXPECT_EQ(warningsOf("conductor", "\"spectrum eta\" \"metal-TiO2-eta\" \"spectrum k\" \"metal-TiO2-k\""), 0);
}

TEST(MaterialFactoryV4, Errors) {
    EXPECT_THAT(errorOfMaterial("conductr", ""), HasSubstr("did you mean 'conductor'?"));
    EXPECT_THAT(errorOfMaterial("conductor", "\"rgb eta\" [1 1 1] \"rgb reflectance\" [1 1 1]"),
                HasSubstr("has both 'reflectance' and 'eta' or 'k'"));
    EXPECT_THAT(errorOfMaterial("coatedconductor", "\"rgb conductor.k\" [1 1 1] \"rgb reflectance\" [1 1 1]"),
                HasSubstr("has both 'reflectance' and 'conductor.eta' or 'conductor.k'"));
    EXPECT_EQ(warningsOf("hair", "\"rgb sigma_a\" [1 1 1] \"float eumelanin\" 1"), 1);
}

}  // namespace
}  // namespace drc::pbrt
