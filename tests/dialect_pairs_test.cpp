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
const std::string kStrands = R"(
    Shape "curve" "string type" "cylinder" "point P" [-0.5 0.3 0.2  -0.2 0.2 0.8  0.1 0.4 1.2  0.6 0.3 1.7] "float width" 0.2
    Shape "curve" "string type" "cylinder" "point P" [0.5 0.3 0.2  0.2 0.5 0.8  -0.1 0.3 1.4  -0.6 0.2 1.7] "float width0" 0.2
        "float width1" 0.1
)";
const std::string kQuadrics = R"(
    AttributeBegin Translate -0.7 0.5 0.9
    Shape "sphere" "float radius" 0.6 "float zmin" -0.2 "float zmax" 0.4 "float phimax" 250 AttributeEnd
    AttributeBegin Translate 0.7 0.4 0.3 Shape "cylinder" "float radius" 0.4 "float zmin" 0 "float zmax" 1 "float phimax" 300
    Translate 0 0 1.2 Shape "disk" "float radius" 0.5 "float innerradius" 0.2 AttributeEnd
)";
const std::string kLoop = R"(
    Translate 0 0.3 1 Scale 0.9 0.9 0.9
    Shape "loopsubdiv" "integer levels" 2 "integer indices" [0 1 2  0 2 3  0 3 1  1 3 2]
        "point P" [0 0 1  0.9 0 -0.3  -0.45 0.8 -0.3  -0.45 -0.8 -0.3]
)";
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
        {"Principled",
         kLit + R"(Material "principled" "rgb basecolor" [0.7 0.4 0.1] "float roughness" 0.4 "float coat" 0.5)" + kBall,
         kLit + R"(Material "principled" "rgb basecolor" [0.7 0.4 0.1] "float roughness" 0.4 "float coat" 0.5)" +
             kBall},
        {"Hair", kLit + R"(Material "hair" "rgb sigma_a" [0.3 0.6 1] "float beta_m" 0.4 "float eta" 1.5)" + kStrands,
         kLit + R"(Material "hair" "rgb sigma_a" [0.3 0.6 1] "float beta_m" 0.4 "float eta" 1.5)" +
             test::respelt(kStrands, "\"point P\"", "\"point3 P\"")},
        {"Subsurface",
         kLit + R"(Material "subsurface" "rgb sigma_a" [0.01 0.1 0.3] "rgb sigma_s" [1 1 1] "float g" 0.3)" + kBall,
         kLit + R"(Material "subsurface" "rgb sigma_a" [0.01 0.1 0.3] "rgb sigma_s" [1 1 1] "float g" 0.3)" + kBall},
        {"SubsurfaceOfAColour", kLit + R"(Material "kdsubsurface" "rgb Kd" [0.6 0.4 0.2])" + kBall,
         kLit + R"(Material "subsurface" "rgb reflectance" [0.6 0.4 0.2])" + kBall},
        // Equal indices: the coat of the one is not there, and the other is a diffuse surface.
        {"CoatOfIndexOne", kLit + R"(Material "matte" "rgb Kd" [0.6 0.4 0.2])" + kBall,
         kLit + R"(Material "coateddiffuse" "rgb reflectance" [0.6 0.4 0.2] "float eta" 1 "float thickness" 0)" +
             kBall},
        {"Bump",
         kLit + R"(Texture "b" "float" "wrinkled" "integer octaves" 3 "float roughness" 0.4
                   Texture "s" "float" "scale" "texture tex1" "b" "float tex2" 0.1
                   Material "matte" "rgb Kd" [0.6 0.6 0.6] "texture bumpmap" "s")" +
             kBall,
         kLit + R"(Texture "b" "float" "wrinkled" "integer octaves" 3 "float roughness" 0.4
                   Texture "s" "float" "scale" "texture tex" "b" "float scale" 0.1
                   Material "diffuse" "rgb reflectance" [0.6 0.6 0.6] "texture displacement" "s")" +
             kBall},
        // An amount in [0, 1]: beyond, colours may exceed 1, and pbrt-v4 clamps those.
        {"MixedTextures",
         kLit + R"(Texture "f" "float" "bilerp" "float v00" 0 "float v01" 0.3 "float v10" 0.7 "float v11" 1
                   Texture "d" "color" "dots" "rgb inside" [0.9 0.1 0.1] "rgb outside" [0.2 0.3 0.8] "float uscale" 8
                           "float vscale" 8
                   Texture "m" "color" "mix" "texture tex1" "d" "rgb tex2" [0.5 0.7 0.2] "texture amount" "f"
                   Material "matte" "texture Kd" "m")" +
             kBall,
         kLit + R"(Texture "f" "float" "bilerp" "float v00" 0 "float v01" 0.3 "float v10" 0.7 "float v11" 1
                   Texture "d" "spectrum" "dots" "rgb inside" [0.9 0.1 0.1] "rgb outside" [0.2 0.3 0.8] "float uscale" 8
                           "float vscale" 8
                   Texture "m" "spectrum" "mix" "texture tex1" "d" "rgb tex2" [0.5 0.7 0.2] "texture amount" "f"
                   Material "diffuse" "texture reflectance" "m")" +
             kBall},
        {"Bilerp",
         kLit + R"(Texture "b" "color" "bilerp" "rgb v00" [0.9 0.1 0.1] "rgb v01" [0.1 0.9 0.1] "rgb v10" [0.1 0.1 0.9]
                           "rgb v11" [0.8 0.8 0.1]
                   Material "matte" "texture Kd" "b")" +
             kBall,
         kLit + R"(Texture "b" "spectrum" "bilerp" "rgb v00" [0.9 0.1 0.1] "rgb v01" [0.1 0.9 0.1]
                           "rgb v10" [0.1 0.1 0.9] "rgb v11" [0.8 0.8 0.1]
                   Material "diffuse" "texture reflectance" "b")" +
             kBall},
        // pbrt-v3 looks solid textures up at the transformed point, pbrt-v4 at the inverse of the transformation.
        {"SolidCheckerboard",
         kLit + R"(Scale 0.4 0.4 0.4
                   Texture "c" "color" "checkerboard" "integer dimension" 3 "rgb tex1" [0.8 0.2 0.1] "rgb tex2" [0 0.2 0.8]
                   Scale 2.5 2.5 2.5 Material "matte" "texture Kd" "c")" +
             kBall,
         kLit + R"(Scale 2.5 2.5 2.5
                   Texture "c" "spectrum" "checkerboard" "integer dimension" 3 "rgb tex1" [0.8 0.2 0.1]
                           "rgb tex2" [0 0.2 0.8]
                   Scale 0.4 0.4 0.4 Material "diffuse" "texture reflectance" "c")" +
             kBall},
        {"MaskedShape",
         kLit + R"(Texture "a" "float" "checkerboard" "float uscale" 10 "float vscale" 10 "float tex1" 1 "float tex2" 0
                   Material "matte" "rgb Kd" [0.7 0.4 0.3] Translate 0 0.4 0.8
                   Shape "sphere" "float radius" 0.6 "texture alpha" "a")",
         kLit + R"(Texture "a" "float" "checkerboard" "float uscale" 10 "float vscale" 10 "float tex1" 1 "float tex2" 0
                   Material "diffuse" "rgb reflectance" [0.7 0.4 0.3] Translate 0 0.4 0.8
                   Shape "sphere" "float radius" 0.6 "texture alpha" "a")"},
        {"PartsOfQuadrics", kLit + R"(Material "matte" "rgb Kd" [0.7 0.4 0.3])" + kQuadrics,
         kLit + R"(Material "diffuse" "rgb reflectance" [0.7 0.4 0.3])" + kQuadrics},
        {"SubdivisionSurface", kLit + R"(Material "matte" "rgb Kd" [0.7 0.4 0.3])" + kLoop,
         kLit + R"(Material "diffuse" "rgb reflectance" [0.7 0.4 0.3])" +
             test::respelt(kLoop, "\"point P\"", "\"point3 P\"")},
        {"Instances",
         kLit +
             R"(ObjectBegin "ball" Material "matte" "rgb Kd" [0.2 0.6 0.3] Shape "sphere" "float radius" 0.3 ObjectEnd
                   Translate -0.6 0 0.5 ObjectInstance "ball" Translate 1.2 0.3 0.4 Scale 1 2 1 ObjectInstance "ball")",
         kLit +
             R"(ObjectBegin "ball" Material "diffuse" "rgb reflectance" [0.2 0.6 0.3] Shape "sphere" "float radius" 0.3
                   ObjectEnd
                   Translate -0.6 0 0.5 ObjectInstance "ball" Translate 1.2 0.3 0.4 Scale 1 2 1 ObjectInstance "ball")"},
        {"Motion",
         kLit +
             R"(Material "matte" "rgb Kd" [0.7 0.4 0.3] ActiveTransform EndTime Translate 0.5 0 0 ActiveTransform All)" +
             kBall,
         kLit + R"(Material "diffuse" "rgb reflectance" [0.7 0.4 0.3] ActiveTransform EndTime Translate 0.5 0 0
                   ActiveTransform All)" +
             kBall},
        {"CoordinateSystems",
         kLit +
             R"(Translate 0.5 0.3 0.2 CoordinateSystem "there" Translate 5 5 5 Material "matte" "rgb Kd" [0.7 0.4 0.3]
                   CoordSysTransform "there")" +
             kBall,
         kLit + R"(Translate 0.5 0.3 0.2 CoordinateSystem "there" Translate 5 5 5
                   Material "diffuse" "rgb reflectance" [0.7 0.4 0.3] CoordSysTransform "there")" +
             kBall},
        {"LampSphere",
         R"(AttributeBegin AreaLightSource "diffuse" "rgb L" [9 8 6] Translate 0.6 -0.4 2.2
            Shape "sphere" "float radius" 0.2 AttributeEnd
            Material "matte" "rgb Kd" [0.7 0.4 0.3])" +
             kBall,
         R"(AttributeBegin AreaLightSource "diffuse" "rgb L" [9 8 6] Translate 0.6 -0.4 2.2
            Shape "sphere" "float radius" 0.2 AttributeEnd
            Material "diffuse" "rgb reflectance" [0.7 0.4 0.3])" +
             kBall},
        // A power is that of white light from all of the surface: pi times its area.
        {"PowerOfAnAreaLight",
         R"(AttributeBegin AreaLightSource "diffuse" "rgb L" [10 10 10] Translate 0.6 -0.4 2.2
            Shape "sphere" "float radius" 0.25 AttributeEnd)" +
             kBall,
         R"(AttributeBegin AreaLightSource "diffuse" "rgb L" [1 1 1] "float power" 24.674011 Translate 0.6 -0.4 2.2
            Shape "sphere" "float radius" 0.25 AttributeEnd)" +
             kBall},
        {"PowerOfAPoint", R"(LightSource "point" "rgb I" [8 8 8] "point from" [0.5 -1 2])" + kBall,
         R"(LightSource "point" "rgb I" [1 1 1] "float power" 100.530965 "point3 from" [0.5 -1 2])" + kBall},
        {"SpotWithASharpEdge",
         R"(LightSource "spot" "rgb I" [9 8 7] "point from" [0 -1 2.5] "point to" [0 0.5 0.5] "float coneangle" 50
            "float conedeltaangle" 0)" +
             kBall,
         R"(LightSource "spot" "rgb I" [9 8 7] "point3 from" [0 -1 2.5] "point3 to" [0 0.5 0.5] "float coneangle" 50
            "float conedeltaangle" 0)" +
             kBall},
        {"MaterialsByName",
         kLit + R"(MakeNamedMaterial "red" "string type" "matte" "rgb Kd" [0.8 0.1 0.1] NamedMaterial "red")" + kBall,
         kLit +
             R"(MakeNamedMaterial "red" "string type" "diffuse" "rgb reflectance" [0.8 0.1 0.1] NamedMaterial "red")" +
             kBall},
        {"NoMaterial", kLit + R"(Material "none")" + kBall, kLit + R"(Material "interface")" + kBall},
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
