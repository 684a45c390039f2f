#include "pbrt/scene_json.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using Json = nlohmann::json;
using testing::EndsWith;

SceneListing listingOf(const std::string& text) {
    SceneListing listing;
    LoadOptions options;
    options.listing = &listing;
    loadPbrtString(text, ".", options, "s.pbrt");
    return listing;
}
std::string textOf(const SceneListing& listing, const std::vector<MeshFile>& meshes = {}) {
    std::string text;
    writeSceneJson(listing, meshes, [&](std::string_view part) { text += part; });
    return text;
}

TEST(SceneJson, HasEverythingOfTheListing) {
    const Json json = Json::parse(textOf(listingOf(
        "Scale 2 2 2 Camera \"perspective\" \"float fov\" 40.5\nWorldBegin\n"
        "Texture \"t\" \"spectrum\" \"checkerboard\" \"string mapping\" \"uv\" \"bool x\" \"true\"\n"
        "Material \"matte\" \"texture Kd\" \"t\"\nAreaLightSource \"diffuse\" \"rgb L\" [1 2 3]\nTranslate 4 5 6\n"
        "Shape \"sphere\" \"float radius\" .1\nLightSource \"point\"\nObjectBegin \"o\" ObjectEnd\nWorldEnd")));
    EXPECT_EQ(json["format"], "drc-scene");
    EXPECT_EQ(json["version"], kSceneJsonVersion);
    EXPECT_EQ(json["dialect"], "pbrt-v3");
    EXPECT_EQ(json["files"], Json({"s.pbrt"}));
    EXPECT_EQ(json["camera"]["at"], Json({0, 1, 20}));
    EXPECT_EQ(json["camera"]["to_world"], Json::parse("[[0.5,0,0,0],[0,0.5,0,0],[0,0,0.5,0],[0,0,0,1]]"));
    EXPECT_EQ(json["camera"]["parameters"],
              Json::parse(R"([{"type":"float","name":"fov","at":[0,1,34],"values":[40.5]}])"));
    EXPECT_EQ(json["sampler"]["at"], nullptr);
    EXPECT_EQ(json["textures"][0]["value"], "spectrum");
    EXPECT_EQ(json["textures"][0]["parameters"][1]["values"], Json({true}));
    EXPECT_EQ(json["materials"][1]["parameters"][0]["spectrum_texture"], 0);
    EXPECT_EQ(json["area_lights"][0]["parameters"][0]["linear_rgb"], Json::parse("[[1,2,3]]"));
    const Json& shape = json["shapes"][0];
    EXPECT_EQ(shape["to_world"][1], Json({0, 1, 0, 5}));
    EXPECT_EQ(shape["parameters"][0]["values"], Json({.1}));
    EXPECT_EQ(shape["material"], 1);
    EXPECT_EQ(shape["area_light"], 0);
    EXPECT_EQ(shape["object"], nullptr);
    EXPECT_FALSE(shape.contains("mesh"));
    EXPECT_EQ(json["lights"][0]["type"], "point");
    EXPECT_EQ(json["objects"][0]["name"], "o");
}

TEST(SceneJson, LeavesTheVerticesToMeshFiles) {
    const SceneListing listing = listingOf(
        "WorldBegin\nShape \"trianglemesh\" \"integer indices\" [0 1 2] \"point P\" [0 0 0 1 0 0 0 1 0] "
        "\"float alpha\" 1\nWorldEnd");
    EXPECT_EQ(Json::parse(textOf(listing))["shapes"][0]["parameters"][0]["values"], Json({0, 1, 2}));
    MeshFile file{"/a/0.ply", 3, 1, false, false, {Vec3(0, 0, 0), Vec3(1, 1, 0)}};
    const Json shape = Json::parse(textOf(listing, {file}))["shapes"][0];
    EXPECT_EQ(shape["mesh"], Json::parse(R"({"file":"/a/0.ply","vertices":3,"triangles":1,"normals":false,
                                             "uvs":false,"bounds":[[0,0,0],[1,1,0]]})"));
    for (const Json& param : shape["parameters"]) EXPECT_EQ(param.contains("values"), param["name"] == "alpha");
    file.bounds = {};
    EXPECT_FALSE(Json::parse(textOf(listing, {file}))["shapes"][0]["mesh"].contains("bounds"));
}

TEST(SceneJson, SurvivesNamesOfAllKinds) {
    const Json json = Json::parse(
        textOf(listingOf("WorldBegin\nMakeNamedMaterial \"a\\\"b\\\\\xFF\" \"string type\" \"matte\"\nWorldEnd")));
    EXPECT_EQ(json["materials"][1]["name"], "a\"b\\\xEF\xBF\xBD");
}

TEST(SceneJson, ComesInPartsOfBoundedSize) {
    std::string points, indices;
    for (int i = 0; i < 50'000; ++i) points += std::to_string(i) + ".25 0 1 ";
    for (int i = 0; i < 3; ++i) indices += std::to_string(i) + ' ';
    const SceneListing listing = listingOf("WorldBegin\nShape \"trianglemesh\" \"integer indices\" [" + indices +
                                           "] \"point P\" [" + points + "]\nWorldEnd");
    size_t parts = 0, largest = 0;
    writeSceneJson(listing, {}, [&](std::string_view part) {
        ++parts;
        largest = std::max(largest, part.size());
    });
    EXPECT_GT(parts, 5u);
    EXPECT_LT(largest, 100'000u);
    EXPECT_THAT(textOf(listing), EndsWith("]}\n"));
}

}  // namespace
}  // namespace drc::pbrt
