// Small scenes shared by the tests of the whole pipeline, as pbrt-v3 text.
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace drc::test {

// Materials that cover every lobe of pbrt-v3's materials, by name.
inline std::vector<std::pair<std::string, std::string>> allMaterials() {
    return {
        {"matte", R"(Material "matte" "rgb Kd" [0.7 0.4 0.3])"},
        {"oren_nayar", R"(Material "matte" "rgb Kd" [0.6 0.6 0.5] "float sigma" 40)"},
        {"plastic", R"(Material "plastic" "rgb Kd" [0.2 0.4 0.5] "rgb Ks" [0.4 0.4 0.4] "float roughness" 0.15)"},
        {"smooth_plastic",
         R"(Material "plastic" "rgb Kd" [0.2 0.4 0.5] "rgb Ks" [0.4 0.4 0.4] "float roughness" 0.01)"},
        {"smooth_metal", R"(Material "metal" "float roughness" 0.005)"},
        {"metal", R"(Material "metal" "float roughness" 0.1)"},
        {"mirror", R"(Material "mirror" "rgb Kr" [0.8 0.9 0.8])"},
        {"glass", R"(Material "glass" "float index" 1.5)"},
        {"rough_glass", R"(Material "glass" "float index" 1.5 "float uroughness" 0.3 "float vroughness" 0.3)"},
        {"uber", R"(Material "uber" "rgb Kd" [0.3 0.2 0.4] "rgb Ks" [0.2 0.2 0.2] "rgb Kr" [0.3 0.3 0.3]
                    "rgb opacity" [0.6 0.7 0.8] "float roughness" 0.2)"},
        {"uber_transmission", R"(Material "uber" "rgb Kd" [0.3 0.3 0.3] "rgb Ks" [0 0 0] "rgb Kt" [0.5 0.5 0.5])"},
        {"substrate", R"(Material "substrate" "rgb Kd" [0.4 0.3 0.2] "rgb Ks" [0.2 0.2 0.2]
                         "float uroughness" 0.1 "float vroughness" 0.2)"},
        {"translucent", R"(Material "translucent" "rgb Kd" [0.4 0.4 0.3] "rgb Ks" [0.2 0.2 0.2] "float roughness" 0.3
                           "rgb reflect" [0.5 0.5 0.5] "rgb transmit" [0.5 0.5 0.5])"},
        {"mix", R"(MakeNamedMaterial "a" "string type" "mirror" "rgb Kr" [0.9 0.9 0.9]
                   MakeNamedMaterial "b" "string type" "matte" "rgb Kd" [0.5 0.2 0.2]
                   Material "mix" "string namedmaterial1" "a" "string namedmaterial2" "b" "rgb amount" [0.3 0.3 0.3])"},
        {"disney", R"(Material "disney" "rgb color" [0.5 0.4 0.6] "float metallic" 0.3 "float roughness" 0.5
                      "float sheen" 0.5 "float clearcoat" 0.5 "bool thin" "true" "float flatness" 0.3
                      "float difftrans" 0.6)"},
        {"hair", R"(Material "hair" "float eumelanin" 0.3 "float beta_m" 0.4 "float beta_n" 0.5)"},
        {"subsurface", R"(Material "subsurface" "string name" "Skin1")"},
        {"rough_subsurface", R"(Material "kdsubsurface" "rgb Kd" [0.6 0.4 0.3] "float uroughness" 0.3
                                "float vroughness" 0.3)"},
    };
}

// Materials of pbrt-v4 without an equivalent in pbrt-v3, by name, for scenes in the syntax of pbrt-v4.
inline std::vector<std::pair<std::string, std::string>> materialsOfV4() {
    return {
        {"rough_diffuse", R"(Material "diffuse" "rgb reflectance" [0.6 0.3 0.2] "float diffuseroughness" 0.8)"},
        {"coated_diffuse", R"(Material "coateddiffuse" "rgb reflectance" [0.6 0.3 0.2] "float roughness" 0)"},
        {"rough_coated_diffuse", R"(Material "coateddiffuse" "rgb reflectance" [0.6 0.3 0.2] "float roughness" 0.3
                                    "float thickness" 0.1 "rgb albedo" [0.5 0.4 0.3])"},
        {"conductor", R"(Material "conductor" "rgb reflectance" [0.8 0.6 0.3] "float uroughness" 0.4
                         "float vroughness" 0.2)"},
        {"coated_conductor", R"(Material "coatedconductor" "float interface.roughness" 0 "float conductor.roughness" 0.3
                                "rgb reflectance" [0.7 0.6 0.5])"},
        {"rough_coated_conductor", R"(Material "coatedconductor" "float interface.roughness" 0.3
                                      "float conductor.roughness" 0.2 "rgb reflectance" [0.7 0.6 0.5])"},
        {"thin_dielectric", R"(Material "thindielectric" "float eta" 1.5)"},
        {"diffuse_transmission", R"(Material "diffusetransmission" "rgb reflectance" [0.3 0.2 0.4]
                                    "rgb transmittance" [0.4 0.5 0.3])"},
        {"mix_of_v4", R"(MakeNamedMaterial "a" "string type" "conductor" "rgb reflectance" [0.8 0.7 0.6]
                         MakeNamedMaterial "b" "string type" "diffusetransmission" "rgb reflectance" [0.3 0.2 0.3]
                         "rgb transmittance" [0.5 0.5 0.4]
                         Material "mix" "string materials" ["a" "b"] "float amount" 0.6)"},
    };
}

inline std::string respelt(std::string text, const std::string& from, const std::string& to) {
    for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}
// Converts a scene of this file from pbrt-v3 to pbrt-v4.
inline std::string inWordsOfV4(std::string text) {
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
             {"Film \"image\"", "Film \"rgb\""},
             {"\"point P\"", "\"point3 P\""},
             {"Material \"matte\" \"rgb Kd\"", "Material \"diffuse\" \"rgb reflectance\""},
             {"Material \"mirror\" \"rgb Kr\"", "Material \"conductor\" \"rgb reflectance\""},
             {"WorldEnd", ""}})
        text = respelt(text, from, to);
    return text;
}

inline std::string quad(const std::string& a, const std::string& b, const std::string& c, const std::string& d) {
    return "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] \"point P\" [" + a + " " + b + " " + c + " " + d +
           "]\n";
}

// A closed room [-2,2]x[-2,2]x[0,3] (z up) with grey and coloured walls, an area light below the ceiling, a mirror on
// one wall that shows the light, and a quad and a ball of `material`. Film size in pixels.
inline std::string room(const std::string& material, int width, int height) {
    const std::string size =
        "\"integer xresolution\" " + std::to_string(width) + " \"integer yresolution\" " + std::to_string(height);
    return "LookAt 0 -1.9 1.5  0 0 1  0 0 1\nCamera \"perspective\" \"float fov\" 70\nFilm \"image\" " + size +
           "\nIntegrator \"path\"\nWorldBegin\n"
           "Material \"matte\" \"rgb Kd\" [0.6 0.6 0.6]\n" +
           quad("-2 -2 0", "2 -2 0", "2 2 0", "-2 2 0") + quad("-2 -2 3", "-2 2 3", "2 2 3", "2 -2 3") +
           quad("-2 2 0", "2 2 0", "2 2 3", "-2 2 3") + quad("-2 -2 0", "-2 -2 3", "2 -2 3", "2 -2 0") +
           "Material \"matte\" \"rgb Kd\" [0.7 0.2 0.1]\n" + quad("-2 -2 0", "-2 2 0", "-2 2 3", "-2 -2 3") +
           "Material \"matte\" \"rgb Kd\" [0.1 0.3 0.7]\n" + quad("2 -2 0", "2 -2 3", "2 2 3", "2 2 0") +
           "Material \"mirror\" \"rgb Kr\" [0.8 0.8 0.8]\n" + quad("1.99 0 1", "1.99 0 2", "1.99 1 2", "1.99 1 1") +
           "AttributeBegin\nMaterial \"matte\" \"rgb Kd\" [0 0 0]\nAreaLightSource \"diffuse\" \"rgb L\" [8 7 6]\n" +
           quad("-0.5 -0.5 2.9", "-0.5 0.5 2.9", "0.5 0.5 2.9", "0.5 -0.5 2.9") + "AttributeEnd\n" + material + "\n" +
           quad("-1.2 0.6 0.1", "1.2 0.6 0.1", "1.2 0.9 1.6", "-1.2 0.9 1.6") +
           "AttributeBegin\nTranslate 0.5 -0.4 0.5\nShape \"sphere\" \"float radius\" 0.4\nAttributeEnd\nWorldEnd\n";
}

// A white furnace: a closed box whose walls emit 1 - albedo and reflect albedo, with a ball of the same material.
// Radiance is 1 everywhere in every direction.
inline std::string furnace(float albedo, int width, int height) {
    const auto number = [](float x) { return std::to_string(x); };
    const std::string a = number(albedo), e = number(1 - albedo);
    const std::string size =
        "\"integer xresolution\" " + std::to_string(width) + " \"integer yresolution\" " + std::to_string(height);
    return "LookAt 0 -1.9 0.3  0 0 0  0 0 1\nCamera \"perspective\" \"float fov\" 80\nFilm \"image\" " + size +
           "\nWorldBegin\nMaterial \"matte\" \"rgb Kd\" [" + a + " " + a + " " + a +
           "]\nAreaLightSource \"diffuse\" \"rgb L\" [" + e + " " + e + " " + e + "] \"bool twosided\" \"true\"\n" +
           quad("-2 -2 -2", "2 -2 -2", "2 2 -2", "-2 2 -2") + quad("-2 -2 2", "-2 2 2", "2 2 2", "2 -2 2") +
           quad("-2 2 -2", "2 2 -2", "2 2 2", "-2 2 2") + quad("-2 -2 -2", "-2 -2 2", "2 -2 2", "2 -2 -2") +
           quad("-2 -2 -2", "-2 2 -2", "-2 2 2", "-2 -2 2") + quad("2 -2 -2", "2 -2 2", "2 2 2", "2 2 -2") +
           "Shape \"sphere\" \"float radius\" 0.8\nWorldEnd\n";
}

// A floor [-2,2]x[-2,2] at z = 0.05 with shading normals that lean towards +y by 45 to 52 degrees: whoever looks that
// way from less than as far above it is below their horizon.
inline std::string leaningFloor() {
    return "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] \"point P\" [-2 -2 0.05  2 -2 0.05  2 2 0.05  -2 "
           "2 "
           "0.05] \"normal N\" [0.2 1 1  -0.2 1 1  -0.1 1 0.8  0.1 1 0.8]\n";
}

// Curves of the type, side by side from x = -1 to 1, bent in z and about as long as they are far apart.
inline std::string bentCurves(const std::string& type, float width) {
    std::string text;
    for (int i = 0; i < 6; ++i) {
        const std::string x = std::to_string(-1 + 0.4f * float(i)) + " ";
        text += "Shape \"curve\" \"string type\" \"" + type + "\" \"float width\" " + std::to_string(width) +
                (type == "ribbon" ? " \"normal N\" [0.3 -1 0  -0.3 -1 0.2]" : "") + " \"point P\" [" + x + "0 -0.8 " +
                x + "0.2 -0.3 " + x + "-0.2 0.3 " + x + "0 0.8]\n";
    }
    return text;
}

// Lamps of every kind of shape, one- and two-sided, whole and partial, for the furnace and for the room.
inline std::string everyShape() {
    const std::string bent = "\"point P\" [-1.2 -0.6 0.3  -0.6 0.2 0.9  0.2 -0.8 0.9  0.9 -0.2 0.4]";
    return "AttributeBegin\nTranslate -1.2 0.2 1.2\nRotate 30 1 1 0\n"
           "Shape \"cylinder\" \"float radius\" 0.3 \"float zmin\" -0.3 \"float zmax\" 0.3 \"float phimax\" "
           "240\nAttributeEnd\n"
           "AttributeBegin\nTranslate -0.5 0.9 0.9\nScale 1 0.7 1\n"
           "Shape \"cone\" \"float radius\" 0.35 \"float height\" 0.6\nAttributeEnd\n"
           "AttributeBegin\nTranslate 0.4 0.6 1.7\nRotate 200 1 0 0\n"
           "Shape \"paraboloid\" \"float radius\" 0.4 \"float zmin\" 0.1 \"float zmax\" 0.5\nAttributeEnd\n"
           "AttributeBegin\nTranslate 1.2 0.5 1\n"
           "Shape \"hyperboloid\" \"point p1\" [0.3 0.1 -0.3] \"point p2\" [0.1 0.3 0.4]\nAttributeEnd\n"
           "AttributeBegin\nTranslate 0 0 1.4\nScale 0.4 0.4 0.4\nReverseOrientation\n"
           "Shape \"loopsubdiv\" \"integer nlevels\" 2 \"integer indices\" [0 1 4 1 2 4 2 3 4 3 0 4 1 0 5 2 1 5 3 2 5 "
           "0 3 5] "
           "\"point P\" [1 0 0 0 1 0 -1 0 0 0 -1 0 0 0 1 0 0 -1]\nAttributeEnd\n"
           "AttributeBegin\nTranslate -0.2 -1 -0.2\nScale 0.8 0.8 0.5\n"
           "Shape \"heightfield\" \"integer nu\" 3 \"integer nv\" 2 \"float Pz\" [0 0.4 0.1 0.2 0.5 0]\nAttributeEnd\n"
           "Shape \"curve\" \"string type\" \"cylinder\" \"float width0\" 0.2 \"float width1\" 0.05 " +
           bent + "\nTranslate 0 0 0.3\nShape \"curve\" \"float width\" 0.1 " + bent +
           "\nTranslate 0 0 0.3\nShape \"curve\" \"string type\" \"ribbon\" \"float width\" 0.2 "
           "\"normal N\" [0 0 1 0 1 1] " +
           bent + "\n";
}

}  // namespace drc::test
