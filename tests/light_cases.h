// A small scene for lights of every type, as pbrt-v3 text, or pbrt-v4 for lights that only it has.
#pragma once
#include <ostream>
#include <string>

#include "base/folder_testing.h"
#include "image/image_io.h"
#include "test_scenes.h"

namespace drc::test {

inline const std::string kPlastic =
    R"(Material "plastic" "rgb Kd" [0.3 0.4 0.5] "rgb Ks" [0.4 0.4 0.4] "float roughness" 0.3)";

// A corner of a room that is open to the sky, with a mirror on one wall, a glossy ball, and the given light.
inline std::string corner(const std::string& light, int width, int height) {
    return "LookAt 0 -1.9 1.5  0 0 1  0 0 1\nCamera \"perspective\" \"float fov\" 70\nFilm \"image\" "
           "\"integer xresolution\" " +
           std::to_string(width) + " \"integer yresolution\" " + std::to_string(height) +
           "\nWorldBegin\n"
           "Material \"matte\" \"rgb Kd\" [0.7 0.6 0.5]\n" +
           quad("-2 -2 0", "2 -2 0", "2 2 0", "-2 2 0") + quad("-2 2 0", "2 2 0", "2 2 3", "-2 2 3") +
           "Material \"matte\" \"rgb Kd\" [0.7 0.2 0.1]\n" + quad("-2 -2 0", "-2 2 0", "-2 2 3", "-2 -2 3") +
           "Material \"mirror\" \"rgb Kr\" [0.8 0.8 0.8]\n" + quad("-1.9 0 0", "-1.9 0 2", "-1.9 1 2", "-1.9 1 0") +
           kPlastic + "\nAttributeBegin\nTranslate 0.5 0.2 0.6\nShape \"sphere\" \"float radius\" 0.6\nAttributeEnd\n" +
           light + "WorldEnd\n";
}

struct LightCase {
    const char *name, *light;
    bool v4 = false;
};
inline void PrintTo(const LightCase& c, std::ostream* out) { *out << c.name; }
inline const LightCase kLightCases[] = {
    {"Point", "LightSource \"point\" \"rgb I\" [9 8 7] \"point from\" [-0.5 -0.8 2]\n"},
    {"Spot",
     "LightSource \"spot\" \"rgb I\" [40 30 20] \"point from\" [-0.5 -1 2.5] \"point to\" [0.4 0.3 0.2] "
     "\"float coneangle\" 40 \"float conedeltaangle\" 15\n"},
    {"Goniometric",
     "AttributeBegin\nTranslate -0.4 -0.6 2\nRotate 90 1 0 0\n"
     "LightSource \"goniometric\" \"rgb I\" [20 20 20] \"string mapname\" \"map.exr\"\nAttributeEnd\n"},
    {"Projection",
     "AttributeBegin\nTranslate -0.4 -1 2.5\nRotate -140 1 0 0\n"
     "LightSource \"projection\" \"rgb I\" [50 50 50] \"float fov\" 70 \"string mapname\" \"map.exr\"\nAttributeEnd\n"},
    {"Sun",
     "LightSource \"distant\" \"rgb L\" [3 2 2] \"point from\" [1 -2 3] \"point to\" [0 0 0] \"float angle\" 12\n"},
    {"PointWithARadius", "LightSource \"point\" \"rgb I\" [9 8 7] \"point from\" [-0.5 -0.8 2] \"float radius\" 0.3\n"},
    {"SpotWithARadius",
     "LightSource \"spot\" \"rgb I\" [40 30 20] \"point from\" [-0.5 -1 2.5] \"point to\" [0.4 0.3 0.2] "
     "\"float coneangle\" 40 \"float conedeltaangle\" 15 \"float radius\" 0.3\n"},
    {"NarrowArea",
     "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [8 7 6] \"float spread\" 80\n"
     "Translate 0.3 -0.6 2.2\nRotate 180 1 0 0\nShape \"disk\" \"float radius\" 0.5 \"bool visibletocamera\" "
     "\"false\" \"bool blockslight\" \"false\"\nAttributeEnd\n"},
    {"HiddenSky", "LightSource \"infinite\" \"rgb L\" [0.6 0.7 0.9] \"bool visibletocamera\" \"false\"\n"},
    {"SkyForTheCamera",
     "LightSource \"infinite\" \"rgb L\" [0.6 0.7 0.9] \"bool illuminates\" \"false\"\n"
     "LightSource \"distant\" \"rgb L\" [2 3 2] \"point from\" [1 -2 3] \"float angle\" 20\n"},
    {"Distant", "LightSource \"distant\" \"rgb L\" [3 2 2] \"point from\" [1 -2 3] \"point to\" [0 0 0]\n"},
    {"Infinite", "LightSource \"infinite\" \"rgb L\" [0.6 0.7 0.9]\n"},
    {"InfiniteMap",
     "AttributeBegin\nRotate 60 1 2 0\nLightSource \"infinite\" \"string mapname\" \"map.exr\"\nAttributeEnd\n"},
    {"Area",
     "AttributeBegin\nMaterial \"matte\" \"rgb Kd\" [0 0 0]\nAreaLightSource \"diffuse\" \"rgb L\" [8 7 6]\n"
     "Translate 0.3 -0.6 2.2\nRotate 180 1 0 0\nShape \"disk\" \"float radius\" 0.5\nAttributeEnd\n"},
    {"TwoSidedSphere",
     "AttributeBegin\nMaterial \"matte\" \"rgb Kd\" [0.5 0.5 0.5]\n"
     "AreaLightSource \"diffuse\" \"rgb L\" [4 5 6] \"bool twosided\" \"true\"\n"
     "Translate -0.7 0.1 1.4\nShape \"sphere\" \"float radius\" 0.4 \"float zmax\" 0.2\nAttributeEnd\n"},
    {"AreaWithoutAMaterial",
     "AttributeBegin\nMaterial \"\"\nAreaLightSource \"diffuse\" \"rgb L\" [4 5 6]\n"
     "Translate -0.7 0.1 1.4\nShape \"sphere\" \"float radius\" 0.4\nAttributeEnd\n"},
    {"ImageOnAScreen",
     "AttributeBegin\nMaterial \"matte\" \"rgb Kd\" [0 0 0]\n"
     "AreaLightSource \"diffuse\" \"string filename\" \"picture.exr\" \"float scale\" 6\n"
     "Translate 0.3 -0.6 2.2\nRotate 180 1 0 0\n"
     "Shape \"bilinearmesh\" \"point P\" [-0.6 -0.4 0  0.6 -0.4 0  -0.6 0.4 0  0.6 0.4 0]\nAttributeEnd\n",
     true},
    {"ImageOnASphere",
     "AttributeBegin\nMaterial \"matte\" \"rgb Kd\" [0.3 0.3 0.3]\n"
     "AreaLightSource \"diffuse\" \"string filename\" \"picture.exr\" \"float scale\" 8\n"
     "Translate -0.5 -0.1 1.7\nRotate 30 1 1 0\nShape \"sphere\" \"float radius\" 0.4\nAttributeEnd\n",
     true},
    {"ImageOnManyTriangles",
     "AttributeBegin\nMaterial \"matte\" \"rgb Kd\" [0.2 0.2 0.2]\n"
     "AreaLightSource \"diffuse\" \"string filename\" \"picture.exr\" \"float scale\" 8\n"
     "Translate -0.4 -0.4 2\nScale 0.8 0.8 0.6\nReverseOrientation\n"
     "Shape \"loopsubdiv\" \"integer levels\" 1 \"integer indices\" [0 1 4 1 2 4 2 3 4 3 0 4 1 0 5 2 1 5 3 2 5 0 3 5] "
     "\"point P\" [1 0 0 0 1 0 -1 0 0 0 -1 0 0 0 1 0 0 -1]\nAttributeEnd\n",
     true},
    {"Portal",
     "LightSource \"infinite\" \"rgb L\" [2 2.5 3] \"point3 portal\" [-1.2 -1.2 2  -1.2 1.9 2  1.4 1.9 2  1.4 -1.2 "
     "2]\n",
     true},
    {"ManyAtOnce",
     "LightSource \"infinite\" \"rgb L\" [0.2 0.2 0.3]\nLightSource \"distant\" \"rgb L\" [1 1 1] \"point from\" "
     "[1 -2 3]\nLightSource \"point\" \"rgb I\" [3 3 3] \"point from\" [-0.5 -0.8 2]\n"
     "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [4 3 2]\nTranslate 0.3 -0.6 2.2\nRotate 180 1 0 0\n"
     "Shape \"disk\" \"float radius\" 0.4\nAttributeEnd\n"},
};

// The corner with the light of this case. If the light has an image, it is written to the folder.
inline std::string cornerWith(const LightCase& light, const TemporaryFolder& folder, int width, int height) {
    Image map(16, 8);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 16; ++x) map.setRgb(x, y, Rgb((x / 2 + y) % 3 == 0 ? 2.f : 0.1f, 0.5f, 0.1f * float(y)));
    writeExr(folder.path("map.exr"), map);
    // Dark, with bright patches of two colours.
    Image picture(12, 10);
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 12; ++x)
            picture.setRgb(x, y, (x / 2 + y / 2) % 4 == 0 ? Rgb(3, x > 5 ? 0.5f : 2.5f, 2) : Rgb(0.4f));
    writeExr(folder.path("picture.exr"), picture);
    std::string text = corner(light.light, width, height);
    for (const char* file : {"map.exr", "picture.exr"}) text = respelt(text, file, folder.path(file));
    return light.v4 ? inWordsOfV4(respelt(text, kPlastic,
                                          R"(Material "coateddiffuse" "rgb reflectance" [0.3 0.4 0.5] )"
                                          R"("float roughness" 0.3)"))
                    : text;
}

}  // namespace drc::test
