// A closed room whose walls are all of one material, and the materials that it is tried with: what cells answer for
// them is found out between corners, beside a window and near a lamp.
#pragma once
#include <string>
#include <vector>

#include "test_scenes.h"

namespace drc::test {

// A room [0,4]x[0,4]x[0,2.7] (z up), in the words of pbrt-v4, of a material in the words of either version. The sky
// shines in by a window, a lamp hangs .3 from a wall, a screen stands .3 before another.
inline std::string roomOf(const std::string& material, bool inV4, int width, int height) {
    const auto wall = [](const std::string& a, const std::string& b, const std::string& c, const std::string& d) {
        return respelt(quad(a, b, c, d), "\"point P\"", "\"float uv\" [0 0 1 0 1 1 0 1] \"point P\"");
    };
    const std::string text =
        "LookAt 1 3 1.4  3.9 0.1 1.4  0 0 1\nCamera \"perspective\" \"float fov\" 75\n"
        "Film \"image\" \"integer xresolution\" " +
        std::to_string(width) + " \"integer yresolution\" " + std::to_string(height) +
        "\nIntegrator \"path\" \"integer maxdepth\" 16\nWorldBegin\nLightSource \"infinite\" \"rgb L\" [3 3 3]\n"
        "AttributeBegin\nMaterial \"matte\" \"rgb Kd\" [0 0 0]\nAreaLightSource \"diffuse\" \"rgb L\" [16 14 11]\n"
        "Translate 3.6 1.8 1.7\nShape \"sphere\" \"float radius\" 0.1\nAttributeEnd\n" +
        material + "\n" + wall("0 0 0", "0 0 2.7", "4 0 2.7", "4 0 0") + wall("4 0 0", "4 0 2.7", "4 4 2.7", "4 4 0") +
        wall("0 0 0", "0 4 0", "0 4 2.7", "0 0 2.7") + wall("0 0 2.7", "0 4 2.7", "4 4 2.7", "4 0 2.7") +
        wall("0 0 0", "4 0 0", "4 4 0", "0 4 0") + wall("0 4 0", "2.2 4 0", "2.2 4 2.7", "0 4 2.7") +
        wall("3.6 4 0", "4 4 0", "4 4 2.7", "3.6 4 2.7") + wall("2.2 4 0", "3.6 4 0", "3.6 4 0.9", "2.2 4 0.9") +
        wall("2.2 4 2.2", "3.6 4 2.2", "3.6 4 2.7", "2.2 4 2.7") +
        wall("2.6 0.3 0", "3.4 0.3 0", "3.4 0.3 1", "2.6 0.3 1") + "WorldEnd\n";
    return inV4 ? respelt(inWordsOfV4(text), "\"float uv\"", "\"point2 uv\"") : text;
}

struct RoomMaterial {
    std::string name, material;
    bool inV4 = false;
    bool isSeparable = true;  // in part, so that cells have something to answer for

    std::string room(int width, int height) const { return roomOf(material, inV4, width, height); }
};
inline void PrintTo(const RoomMaterial& m, std::ostream* out) { *out << m.name; }

inline std::vector<RoomMaterial> roomMaterials() {
    std::vector<RoomMaterial> all;
    const auto addV3 = [&](const std::string& name, const std::string& text, bool isSeparable = true) {
        all.push_back({name, text, false, isSeparable});
    };
    const auto addV4 = [&](const std::string& name, const std::string& text, bool isSeparable = true) {
        all.push_back({name, text, true, isSeparable});
    };
    const auto principled = [](const std::string& more) {
        return "Material \"principled\" \"rgb basecolor\" [.7 .65 .6] " + more;
    };
    const std::string bumps =
        "Texture \"waves\" \"float\" \"wrinkled\" \"integer octaves\" 3\n"
        "Texture \"bumps\" \"float\" \"scale\" \"texture tex1\" \"waves\" \"float tex2\" 0.05\n";
    const std::string bumpsOfV4 = respelt(respelt(bumps, "texture tex1", "texture tex"), "float tex2", "float scale");
    const std::string alpha = "\"bool remaproughness\" \"false\" \"float roughness\" ";

    for (const char* sigma : {"0", "20", "40"})
        addV3(std::string("matte_sigma_") + sigma,
              std::string("Material \"matte\" \"rgb Kd\" [.7 .6 .5] \"float sigma\" ") + sigma);
    addV3("matte_bumps", bumps + "Material \"matte\" \"rgb Kd\" [.7 .7 .7] \"texture bumpmap\" \"bumps\"");
    for (const char* a : {"3", "5", "8"})
        addV3(std::string("plastic_") + a,
              "Material \"plastic\" \"rgb Kd\" [.6 .6 .6] \"rgb Ks\" [.25 .25 .25] " + alpha + "." + a);
    addV3("plastic_8_bumps", bumps +
                                 "Material \"plastic\" \"rgb Kd\" [.6 .6 .6] \"rgb Ks\" [.25 .25 .25] "
                                 "\"texture bumpmap\" \"bumps\" " +
                                 alpha + ".8");
    for (const char* a : {"3", "6"})
        addV3(std::string("substrate_") + a,
              "Material \"substrate\" \"rgb Kd\" [.6 .6 .6] \"rgb Ks\" [.3 .3 .3] \"bool remaproughness\" \"false\" "
              "\"float uroughness\" ." +
                  std::string(a) + " \"float vroughness\" ." + a);
    addV3("metal_7", "Material \"metal\" " + alpha + ".7", false);
    addV3("metal_9_and_5",
          "Material \"metal\" \"bool remaproughness\" \"false\" \"float uroughness\" .9 "
          "\"float vroughness\" .5",
          false);
    addV3("uber_7",
          "Material \"uber\" \"rgb Kd\" [.6 .5 .4] \"rgb Ks\" [.3 .3 .3] \"rgb opacity\" [.9 .9 .9] " + alpha + ".7");
    addV3("translucent_7", "Material \"translucent\" \"rgb Kd\" [.6 .6 .6] \"rgb Ks\" [.3 .3 .3] " + alpha + ".7");
    for (const char* r : {".5", ".8"})
        addV3(std::string("disney_") + (r + 1),
              std::string("Material \"disney\" \"rgb color\" [.7 .6 .5] \"float roughness\" ") + r);
    addV3("disney_8_sheen_coat",
          "Material \"disney\" \"rgb color\" [.7 .6 .5] \"float roughness\" .8 \"float sheen\" .8 "
          "\"float clearcoat\" .6 \"float metallic\" .3");
    addV3("disney_thin",
          "Material \"disney\" \"rgb color\" [.7 .6 .5] \"float roughness\" .6 \"bool thin\" \"true\" "
          "\"float flatness\" .5 \"float difftrans\" .6");
    addV3("hair", "Material \"hair\" \"rgb color\" [.6 .4 .3] \"float beta_m\" .4 \"float beta_n\" .5", false);
    addV3("matte_beside_metal", "MakeNamedMaterial \"a\" \"string type\" \"metal\" " + alpha +
                                    ".8\n"
                                    "MakeNamedMaterial \"b\" \"string type\" \"matte\" \"rgb Kd\" [.7 .7 .7]\n"
                                    "Material \"mix\" \"string namedmaterial1\" \"a\" \"string namedmaterial2\" \"b\"");
    addV4("rough_diffuse", "Material \"diffuse\" \"rgb reflectance\" [.7 .6 .5] \"float diffuseroughness\" .8");
    for (const char* r : {"2", "5", "8"})
        addV4(std::string("coated_diffuse_") + r,
              "Material \"coateddiffuse\" \"rgb reflectance\" [.7 .6 .5] " + alpha + "." + r);
    addV4("coated_conductor_7",
          "Material \"coatedconductor\" \"rgb reflectance\" [.8 .7 .6] \"bool remaproughness\" "
          "\"false\" \"float interface.roughness\" .6 \"float conductor.roughness\" .7",
          false);
    addV4("diffuse_transmission",
          "Material \"diffusetransmission\" \"rgb reflectance\" [.5 .4 .4] \"rgb transmittance\" [.3 .3 .2]");
    addV4("coated_beside_diffuse",
          "MakeNamedMaterial \"a\" \"string type\" \"coateddiffuse\" \"rgb reflectance\" [.8 .8 .8] \"float "
          "roughness\" .6\n"
          "MakeNamedMaterial \"b\" \"string type\" \"diffuse\" \"rgb reflectance\" [.5 .5 .6]\n"
          "Material \"mix\" \"string materials\" [\"a\" \"b\"] \"float amount\" .5");
    for (const char* r : {"3", "5", "7", "9"})
        addV4(std::string("principled_") + r, principled(std::string("\"float roughness\" .") + r));
    addV4("principled_9_bumps", bumpsOfV4 + principled("\"float roughness\" .9 \"texture displacement\" \"bumps\""));
    addV4("principled_9_no_specular", principled("\"float roughness\" .9 \"float specularlevel\" 0"));
    addV4("principled_9_rough_base", principled("\"float roughness\" .9 \"float diffuseroughness\" .8"));
    addV4("principled_9_metal", principled("\"float roughness\" .9 \"float metallic\" 1"), false);
    addV4("principled_8_half_metal", principled("\"float roughness\" .8 \"float metallic\" .5"));
    addV4("principled_8_sheen", principled("\"float roughness\" .8 \"float sheen\" .8 \"float sheenroughness\" .4"));
    addV4("principled_8_rough_coat", principled("\"float roughness\" .8 \"float coat\" 1 \"float coatroughness\" .7 "
                                                "\"rgb coattint\" [.8 .6 .4]"));
    addV4("principled_8_coloured_coat",
          principled("\"float roughness\" .8 \"float coat\" 1 \"float coatroughness\" .4 \"rgb coattint\" [.6 .4 .2]"));
    addV4("principled_8_translucent",
          principled("\"float roughness\" .8 \"float subsurface\" .7 \"bool thinwall\" \"true\""));
    addV4("principled_9_transmission", principled("\"float roughness\" .9 \"float transmission\" .4"));
    return all;
}

}  // namespace drc::test
