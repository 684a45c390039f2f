// Helpers for the material tests of both dialects.
#pragma once
#include <sstream>
#include <string>
#include <vector>

#include "base/log.h"
#include "pbrt/dialect.h"
#include "pbrt/material_comparison.h"
#include "pbrt/test_scenes.h"

namespace drc::pbrt {

// Loads `Material "type" parameters` after some directives, in one dialect.
class MaterialLoader {
  public:
    explicit MaterialLoader(Dialect dialect) : dialect_(dialect) {}

    MaterialPtr load(const std::string& type, const std::string& parameters, const std::string& before = "") const {
        static const std::string kTriangle =
            "\nShape \"trianglemesh\" \"integer indices\" [0 1 2] \"point3 P\" [0 0 0  1 0 0  0 1 0]\n";
        const std::string text = before + "\nMaterial \"" + type + "\" " + parameters + kTriangle;
        const auto scene = dialect_ == Dialect::V4 ? loadWorldV4(text) : loadWorld(text);
        return scene->primitives.at(0).material;
    }
    int warningsOf(const std::string& type, const std::string& parameters) const {
        forgetWarnings();
        load(type, parameters);
        return warningCount();
    }

  private:
    Dialect dialect_;
};

// The default parameters that the format's documentation states.
struct DefaultsCase {
    std::string type, defaults;
};
inline void checkDefaults(const MaterialLoader& loader, const DefaultsCase& c) {
    const MaterialPtr plain = loader.load(c.type, "");
    ASSERT_NE(plain, nullptr) << c.type;
    EXPECT_TRUE(alike(*plain, *loader.load(c.type, c.defaults))) << c.type;
    EXPECT_EQ(loader.warningsOf(c.type, c.defaults), 0) << c.type;
    EXPECT_EQ(loader.warningsOf(c.type, "\"float sgima\" 3"), 1) << c.type;
}

// Tests bump maps, under the parameter name of the dialect.
inline void checkBump(const MaterialLoader& loader, const std::string& type, const std::string& name) {
    const std::string height = "Texture \"height\" \"float\" \"constant\" \"float value\" .1\n";
    EXPECT_EQ(loader.load(type, "")->relief().heights, nullptr) << type;
    const MaterialPtr bumpy = loader.load(type, "\"texture " + name + "\" \"height\"", height);
    ASSERT_NE(bumpy->relief().heights, nullptr) << type;
    EXPECT_EQ(bumpy->relief().heights->eval({}), .1f) << type;
}

// Parameters of a material: `others` are always given; `scalars` and `colors` are names separated by spaces, each
// tested alone.
struct ParameterCase {
    const char *type, *others, *scalars, *colors;
};
// Each parameter must have an effect, and the same effect as a constant texture.
inline void checkParameters(const MaterialLoader& loader, const ParameterCase& c) {
    const std::string textures =
        "Texture \"t\" \"float\" \"constant\" \"float value\" .7\n"
        "Texture \"t\" \"spectrum\" \"constant\" \"rgb value\" [.6 .35 .7]\n";
    const MaterialPtr plain = loader.load(c.type, c.others);
    const auto check = [&](const std::string& names, const std::string& type, const std::string& value) {
        std::istringstream stream(names);
        for (std::string name; stream >> name;) {
            const std::string others = std::string(c.others) + " ";
            const MaterialPtr constant = loader.load(c.type, others + "\"" + type + " " + name + "\" " + value);
            EXPECT_FALSE(alike(*plain, *constant)) << c.type << " " << name;
            forgetWarnings();
            const MaterialPtr textured = loader.load(c.type, others + "\"texture " + name + "\" \"t\"", textures);
            EXPECT_EQ(warningCount(), 0) << c.type << " " << name;
            EXPECT_TRUE(alike(*constant, *textured)) << c.type << " " << name;
        }
    };
    check(c.scalars, "float", ".7");
    check(c.colors, "rgb", "[.6 .35 .7]");
}

}  // namespace drc::pbrt
