#include "pbrt/material_factory_v4.h"

#include <gmock/gmock.h>

#include "base/log.h"
#include "pbrt/material_comparison.h"
#include "pbrt/param_parser.h"
#include "pbrt/test_scenes.h"
#include "scene/material_matte.h"
#include "scene/material_mirror.h"

namespace drc::pbrt {
namespace {

using testing::HasSubstr;

class MaterialFactoryV4 : public testing::Test {
  protected:
    MaterialFactoryV4() {
        textures_.scalars.set("t", std::make_shared<ConstantTexture<float>>(.7f));
        textures_.colors.set("t", std::make_shared<ConstantTexture<Rgb>>(Rgb(.6f, .35f, .7f)));
        const auto name = [&](const std::string& as, MaterialPtr material) {
            auto instance = std::make_shared<MaterialInstance>();
            instance->material = std::move(material);
            materials_.set(as, std::move(instance));
        };
        name("a", makeMatte({}));
        name("b", makeMirror({}));
        name("gone", nullptr);
    }
    MaterialPtr load(const std::string& type, const std::string& parameters) {
        tokens_ = std::make_unique<TokenStream>(Source::fromText(parameters, "m.pbrt", "."));
        ParamSet params = parseParams(*tokens_, "material '" + type + "'", {}, files_, {.dialect = Dialect::V4});
        return makeMaterialV4(type, std::move(params), textures_, materials_)->material;
    }
    std::string errorOfLoading(const std::string& type, const std::string& parameters) {
        return errorOf([&] { load(type, parameters); });
    }
    int warningsOf(const std::string& type, const std::string& parameters) {
        const int before = warningCount();
        load(type, parameters);
        return warningCount() - before;
    }

    FileSearch files_{"."};
    NamedTextures textures_;
    NamedMaterials materials_;
    std::unique_ptr<TokenStream> tokens_;
};

TEST_F(MaterialFactoryV4, Defaults) {
    const std::string copper = "eta\" [.2004377 .9240334 1.1022120] ", copperK = "k\" [3.9129485 2.4528477 2.1421880] ";
    const struct {
        std::string type, defaults;
    } kAll[] = {
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
    };
    for (const auto& [type, defaults] : kAll) {
        const MaterialPtr plain = load(type, "");
        ASSERT_NE(plain, nullptr) << type;
        EXPECT_EQ(plain->bump(), nullptr) << type;
        EXPECT_TRUE(alike(*plain, *load(type, defaults))) << type;
        EXPECT_EQ(warningsOf(type, defaults), 0) << type;
        EXPECT_NE(load(type, "\"texture displacement\" \"t\"")->bump(), nullptr) << type;
        EXPECT_EQ(warningsOf(type, "\"string normalmap\" \"n.png\""), 1) << type;
        EXPECT_EQ(warningsOf(type, "\"float sgima\" 1"), 1) << type;
    }
}

TEST_F(MaterialFactoryV4, EveryParameterCountsAndMayBeATexture) {
    const ParameterCase kCases[] = {
        {"diffuse", "", "", "reflectance"},
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
    };
    for (const ParameterCase& c : kCases)
        checkParameters(c, [&](const std::string& parameters) { return load(c.type, parameters); });
}

TEST_F(MaterialFactoryV4, RoughnessIsTheSquareOfAlphaUnlessToldNotTo) {
    const struct {
        std::string type, prefix;
    } kAll[] = {{"dielectric", ""}, {"conductor", ""}, {"coateddiffuse", ""}, {"coatedconductor", "conductor."}};
    for (const auto& [type, prefix] : kAll) {
        const std::string name = "\"float " + prefix + "roughness\" ";
        const MaterialPtr remapped = load(type, name + ".09");
        EXPECT_TRUE(alike(*remapped, *load(type, name + ".3 \"bool remaproughness\" \"false\""))) << type;
        EXPECT_FALSE(alike(*remapped, *load(type, name + ".09 \"bool remaproughness\" \"false\""))) << type;
        const MaterialPtr u = load(type, name + ".09 \"float " + prefix + "uroughness\" .3");
        EXPECT_FALSE(alike(*u, *load(type, name + ".09 \"float " + prefix + "vroughness\" .3"))) << type;
    }
}

TEST_F(MaterialFactoryV4, Interfaces) {
    for (const char* type : {"", "none", "interface"}) EXPECT_EQ(load(type, "\"float x\" 1"), nullptr) << type;
}

TEST_F(MaterialFactoryV4, Mix) {
    const std::string names = "\"string materials\" [\"a\" \"b\"] ";
    // The amount is of the second.
    EXPECT_TRUE(alike(*load("mix", names + "\"float amount\" 0"), *makeMatte({})));
    EXPECT_TRUE(alike(*load("mix", names + "\"float amount\" 1"), *makeMirror({})));
    EXPECT_TRUE(alike(*load("mix", names), *load("mix", names + "\"float amount\" .5")));
    EXPECT_TRUE(alike(*load("mix", names + "\"texture amount\" \"t\""), *load("mix", names + "\"float amount\" .7")));
    EXPECT_THAT(errorOfLoading("mix", ""), HasSubstr("needs the parameter \"string materials\""));
    EXPECT_THAT(errorOfLoading("mix", "\"string materials\" [\"a\"]"),
                HasSubstr("must have two materials' names, not 1"));
    EXPECT_THAT(errorOfLoading("mix", "\"string materials\" [\"a\" \"c\"]"),
                HasSubstr("the mix material's second of 'materials' 'c' has not been defined"));
    EXPECT_THAT(errorOfLoading("mix", "\"string materials\" [\"gone\" \"a\"]"), HasSubstr("'gone' is 'none'"));
}

TEST_F(MaterialFactoryV4, NumbersForGreysAndSpectraForIndices) {
    EXPECT_TRUE(
        alike(*load("diffuse", "\"float reflectance\" .3"), *load("diffuse", "\"rgb reflectance\" [.3 .3 .3]")));
    EXPECT_TRUE(
        alike(*load("dielectric", "\"spectrum eta\" [400 1.7 700 1.7]"), *load("dielectric", "\"float eta\" 1.7")));
    EXPECT_FALSE(alike(*load("dielectric", "\"spectrum eta\" \"glass-F11\""), *load("dielectric", "")));
    EXPECT_FALSE(alike(*load("conductor", "\"spectrum eta\" \"metal-Au-eta\" \"spectrum k\" \"metal-Au-k\""),
                       *load("conductor", "")));
    EXPECT_EQ(warningsOf("conductor", "\"spectrum eta\" \"metal-CuZn-eta\""), 1);
    EXPECT_EQ(warningsOf("conductor", "\"spectrum eta\" \"metal-TiO2-eta\" \"spectrum k\" \"metal-TiO2-k\""), 0);
}

TEST_F(MaterialFactoryV4, Errors) {
    EXPECT_THAT(errorOfLoading("conductr", ""), HasSubstr("did you mean 'conductor'?"));
    EXPECT_THAT(errorOfLoading("conductor", "\"rgb eta\" [1 1 1] \"rgb reflectance\" [1 1 1]"),
                HasSubstr("has both 'reflectance' and 'eta' or 'k'"));
    EXPECT_THAT(errorOfLoading("coatedconductor", "\"rgb conductor.k\" [1 1 1] \"rgb reflectance\" [1 1 1]"),
                HasSubstr("has both 'reflectance' and 'conductor.eta' or 'conductor.k'"));
    EXPECT_EQ(warningsOf("measured", "\"string filename\" \"a\""), 1);
    EXPECT_EQ(warningsOf("hair", "\"rgb sigma_a\" [1 1 1] \"float eumelanin\" 1"), 1);
}

}  // namespace
}  // namespace drc::pbrt
