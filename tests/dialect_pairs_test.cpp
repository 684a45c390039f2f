// Scenes written for pbrt-v3 and for pbrt-v4 must give the same picture.
#include <gtest/gtest.h>

#include "pipeline.h"
#include "test_scenes.h"

namespace drc {
namespace {

using test::Pipeline;

struct Pair {
    const char* name;
    std::string v3, v4;
};
void PrintTo(const Pair& pair, std::ostream* out) { *out << pair.name; }

const std::string kAreaLight = "AreaLightSource \"diffuse\" \"rgb L\" [8 7 6]\n" +
                               test::quad("-0.5 -0.5 2.9", "-0.5 0.5 2.9", "0.5 0.5 2.9", "0.5 -0.5 2.9");
const std::string kLit = "AttributeBegin\n" + kAreaLight + "AttributeEnd\n";
const std::string kBall = "\nTranslate 0 0.4 0.8\nShape \"sphere\" \"float radius\" 0.6\n";

// In a grey room with a lamp below the ceiling, unless the pair has a light of its own.
std::vector<Pair> pairs() {
    return {
        {"Diffuse", kLit + R"(Material "matte" "rgb Kd" [0.7 0.4 0.3])" + kBall,
         kLit + R"(Material "diffuse" "rgb reflectance" [0.7 0.4 0.3])" + kBall},
        {"Dielectric", kLit + R"(Material "glass" "float eta" 1.4)" + kBall,
         kLit + R"(Material "dielectric" "float eta" 1.4)" + kBall},
        {"RoughDielectric",
         kLit + R"(Material "glass" "float uroughness" 0.3 "float vroughness" 0.2 "bool remaproughness" "false")" +
             kBall,
         kLit + R"(Material "dielectric" "float uroughness" 0.3 "float vroughness" 0.2 "bool remaproughness" "false")" +
             kBall},
        {"Conductor",
         kLit + R"(Material "metal" "rgb eta" [0.2 0.9 1.1] "rgb k" [3.9 2.4 2.2] "float roughness" 0.2
                   "bool remaproughness" "false")" +
             kBall,
         kLit + R"(Material "conductor" "rgb eta" [0.2 0.9 1.1] "rgb k" [3.9 2.4 2.2] "float roughness" 0.2
                   "bool remaproughness" "false")" +
             kBall},
        {"DiffuseTransmission",
         kLit + R"(Material "translucent" "rgb Kd" [0.8 0.6 0.4] "rgb Ks" [0 0 0] "rgb reflect" [0.5 0.5 0.5]
                   "rgb transmit" [0.25 0.25 0.25])" +
             kBall,
         kLit + R"(Material "diffusetransmission" "rgb reflectance" [0.4 0.3 0.2] "rgb transmittance" [0.2 0.15 0.1])" +
             kBall},
        {"Mix",
         kLit + R"(MakeNamedMaterial "a" "string type" "matte" "rgb Kd" [0.8 0.1 0.1]
                   MakeNamedMaterial "b" "string type" "matte" "rgb Kd" [0.1 0.1 0.8]
                   Material "mix" "string namedmaterial1" "a" "string namedmaterial2" "b" "rgb amount" [0.3 0.3 0.3])" +
             kBall,
         kLit + R"(MakeNamedMaterial "a" "string type" "diffuse" "rgb reflectance" [0.8 0.1 0.1]
                   MakeNamedMaterial "b" "string type" "diffuse" "rgb reflectance" [0.1 0.1 0.8]
                   Material "mix" "string materials" ["a" "b"] "float amount" 0.7)" +
             kBall},
        {"PointLight", R"(LightSource "point" "rgb I" [4 5 6] "point from" [0.5 -1 2] "rgb scale" [2 2 2])" + kBall,
         R"(LightSource "point" "rgb I" [4 5 6] "point3 from" [0.5 -1 2] "float scale" 2)" + kBall},
        {"TwoSidedAreaLight",
         "AttributeBegin\nTranslate 0 0 -1\nReverseOrientation\n"
         "AreaLightSource \"diffuse\" \"rgb L\" [2 2 1] \"rgb scale\" [3 3 3] \"bool twosided\" \"true\"\n" +
             test::quad("-0.5 -0.5 2.9", "-0.5 0.5 2.9", "0.5 0.5 2.9", "0.5 -0.5 2.9") + "AttributeEnd\n",
         "AttributeBegin\nTranslate 0 0 -1\nReverseOrientation\n"
         "AreaLightSource \"diffuse\" \"rgb L\" [2 2 1] \"float scale\" 3 \"bool twosided\" \"true\"\n" +
             test::quad("-0.5 -0.5 2.9", "-0.5 0.5 2.9", "0.5 0.5 2.9", "0.5 -0.5 2.9") + "AttributeEnd\n"},
        {"Checkerboard",
         kLit + R"(Texture "c" "color" "checkerboard" "rgb tex1" [0.8 0.2 0.1] "rgb tex2" [0.1 0.2 0.8]
                   "float uscale" 6 "float vscale" 4
                   Material "matte" "texture Kd" "c")" +
             kBall,
         kLit + R"(Texture "c" "spectrum" "checkerboard" "rgb tex1" [0.8 0.2 0.1] "rgb tex2" [0.1 0.2 0.8]
                   "float uscale" 6 "float vscale" 4
                   Material "diffuse" "texture reflectance" "c")" +
             kBall},
        {"BilinearMesh", kLit + R"(Material "matte" "rgb Kd" [0.7 0.4 0.3]
                   Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "float uv" [0 0  1 0  1 1  0 1]
                   "point P" [-1.2 0.6 0.1  1.2 0.6 0.1  1.2 0.9 1.6  -1.2 0.9 1.6])",
         kLit + R"(Material "diffuse" "rgb reflectance" [0.7 0.4 0.3]
                   Shape "bilinearmesh" "point3 P" [-1.2 0.6 0.1  1.2 0.6 0.1  -1.2 0.9 1.6  1.2 0.9 1.6])"},
        // Converted with the matrix from Rec. 2020 to Rec. 709 primaries, both with the white point D65.
        {"WideGamut", kLit + R"(Material "matte" "rgb Kd" [0.47336 0.28837 0.18628])" + kBall,
         kLit + R"(ColorSpace "rec2020" Material "diffuse" "rgb reflectance" [0.4 0.3 0.2])" + kBall},
        {"SharedAttributes", kLit + R"(Material "matte" "rgb Kd" [0.7 0.4 0.3])" + kBall,
         kLit + R"(Attribute "material" "rgb reflectance" [0.7 0.4 0.3]
                   Attribute "shape" "float radius" 0.6
                   Material "diffuse" Translate 0 0.4 0.8 Shape "sphere")"},
    };
}

std::string roomAround(const std::string& content, bool v4) {
    const std::string material = v4 ? "Material \"diffuse\" \"rgb reflectance\" " : "Material \"matte\" \"rgb Kd\" ";
    const std::string film =
        "Film \"" + std::string(v4 ? "rgb" : "image") + "\" \"integer xresolution\" 16 \"integer yresolution\" 12\n";
    const std::string text =
        "LookAt 0 -1.9 1.5  0 0 1  0 0 1\nCamera \"perspective\" \"float fov\" 70\n" + film + "WorldBegin\n" +
        material + "[0.6 0.6 0.6]\n" + test::quad("-2 -2 0", "2 -2 0", "2 2 0", "-2 2 0") +
        test::quad("-2 -2 3", "-2 2 3", "2 2 3", "2 -2 3") + test::quad("-2 2 0", "2 2 0", "2 2 3", "-2 2 3") +
        test::quad("-2 -2 0", "-2 -2 3", "2 -2 3", "2 -2 0") + material + "[0.7 0.2 0.1]\n" +
        test::quad("-2 -2 0", "-2 2 0", "-2 2 3", "-2 -2 3") + material + "[0.1 0.3 0.7]\n" +
        test::quad("2 -2 0", "2 -2 3", "2 2 3", "2 2 0") + content + (v4 ? "" : "WorldEnd\n");
    return v4 ? test::respelt(text, "\"point P\"", "\"point3 P\"") : text;
}

class DialectPairs : public testing::TestWithParam<Pair> {};
INSTANTIATE_TEST_SUITE_P(V3AndV4, DialectPairs, testing::ValuesIn(pairs()), [](const auto& i) { return i.param.name; });

TEST_P(DialectPairs, GiveTheSamePicture) {
    const Pipeline v3(roomAround(GetParam().v3, false)), v4(roomAround(GetParam().v4, true));
    ASSERT_EQ(v3.pixels(), 16 * 12);
    ASSERT_EQ(v4.pixels(), v3.pixels());
    // Both use the same random numbers, so differences are not noise.
    const test::Estimate a = v3.estimate(&Pipeline::path, 64, 64 / 2), b = v4.estimate(&Pipeline::path, 64, 64 / 2);
    double sum = 0, difference = 0;
    for (size_t i = 0; i < a.mean.size(); ++i) {
        sum += a.mean[i];
        difference += std::abs(a.mean[i] - b.mean[i]);
    }
    EXPECT_GT(sum / double(a.mean.size()), 0.05);
    EXPECT_LT(difference / sum, 1e-3);
}

}  // namespace
}  // namespace drc
