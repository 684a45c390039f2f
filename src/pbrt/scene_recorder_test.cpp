#include "pbrt/scene_recorder.h"

#include <gmock/gmock.h>

#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;

SceneListing listingOf(const std::string& text, const std::string& directory = ".") {
    SceneListing listing;
    LoadOptions options;
    options.listing = &listing;
    loadPbrtString(text, directory, options, "s.pbrt");
    return listing;
}
SceneListing listingOfWorld(const std::string& text, const std::string& directory = ".") {
    return listingOf("WorldBegin\n" + text + "\nWorldEnd\n", directory);
}
SceneListing listingOfWorldV4(const std::string& text) { return listingOf("Film \"rgb\" WorldBegin\n" + text + "\n"); }

std::string place(const SourceLocation& at) { return at.str(); }
// Where the transformation takes the point (1, 2, 3).
Vec3 image(const Transform& t) { return t.point(Vec3(1, 2, 3)); }

const ListedParam& paramOf(const ListedDirective& directive, const std::string& name) {
    for (const ListedParam& param : directive.params)
        if (param.name == name) return param;
    throw Error("no parameter " + name);
}

constexpr const char* kTriangle = "Shape \"trianglemesh\" \"integer indices\" [0 1 2] \"point P\" [0 0 0 1 0 0 0 1 0]";

TEST(SceneRecorder, KeepsSettingsWithTheirParametersAndPlaces) {
    const SceneListing listing = listingOf(
        "LookAt 0 0 5 0 0 0 0 1 0\nCamera \"perspective\" \"float fov\" 40\n"
        "Sampler \"halton\" \"integer pixelsamples\" [8]\n  Integrator \"path\" \"integer maxdepth\" 3\n"
        "PixelFilter \"box\" \"float xwidth\" 1\nFilm \"image\" \"string filename\" \"x.exr\"\nWorldBegin\nWorldEnd");
    EXPECT_EQ(listing.camera.type, "perspective");
    EXPECT_EQ(place(listing.camera.at), "s.pbrt:2:8");
    EXPECT_EQ(place(paramOf(listing.camera, "fov").at), "s.pbrt:2:22");
    EXPECT_THAT(paramOf(listing.camera, "fov").numbers, ElementsAre(40));
    // pbrt's camera is left-handed: x points to the left of an eye that looks along -z.
    EXPECT_EQ(image(listing.camera.toWorld.start()), Vec3(-1, 2, 2));
    EXPECT_EQ(listing.sampler.type, "halton");
    EXPECT_EQ(place(listing.integrator.at), "s.pbrt:4:14");
    EXPECT_EQ(listing.filter.type, "box");
    EXPECT_THAT(paramOf(listing.film, "filename").strings, ElementsAre("x.exr"));
    EXPECT_EQ(listing.dialect.dialect, Dialect::V3);
}

TEST(SceneRecorder, NamesDefaultsWithoutAPlace) {
    const SceneListing listing = listingOfWorld(kTriangle);
    EXPECT_EQ(listing.camera.type, "perspective");
    EXPECT_TRUE(listing.camera.at.empty());
    ASSERT_EQ(listing.materials.size(), 1u);
    EXPECT_EQ(listing.materials[0].type, "matte");
    EXPECT_EQ(listing.shapes[0].material, 0u);
    EXPECT_EQ(listingOfWorldV4("").materials[0].type, "diffuse");
}

TEST(SceneRecorder, KeepsTheGraphicsStateOfEachShape) {
    const SceneListing listing = listingOfWorld(
        "MakeNamedMaterial \"a\" \"string type\" \"mirror\"\nTranslate 10 0 0\nAttributeBegin\nNamedMaterial \"a\"\n"
        "ReverseOrientation Scale 2 2 2\nAreaLightSource \"diffuse\" \"rgb L\" [1 2 3]\n  Shape \"sphere\"\n"
        "AttributeEnd\nShape \"sphere\"\nAttributeBegin Material \"glass\" Shape \"disk\" AttributeEnd");
    ASSERT_EQ(listing.shapes.size(), 3u);
    const ListedShape &lit = listing.shapes[0], &plain = listing.shapes[1], &glass = listing.shapes[2];
    EXPECT_EQ(place(lit.at), "s.pbrt:8:9");
    EXPECT_EQ(image(lit.toWorld.start()), Vec3(12, 4, 6));
    EXPECT_TRUE(lit.reverseOrientation);
    EXPECT_EQ(listing.materials[lit.material].name, "a");
    EXPECT_EQ(listing.materials[lit.material].type, "mirror");
    EXPECT_EQ(lit.areaLight, 0u);
    EXPECT_THAT(paramOf(listing.areaLights[0], "L").numbers, ElementsAre(1, 2, 3));
    EXPECT_EQ(image(plain.toWorld.start()), Vec3(11, 2, 3));
    EXPECT_FALSE(plain.reverseOrientation);
    EXPECT_EQ(plain.material, 0u);
    EXPECT_FALSE(plain.areaLight.has_value());
    EXPECT_EQ(listing.materials[glass.material].type, "glass");
    EXPECT_EQ(glass.type, "disk");
}

TEST(SceneRecorder, ListsWhatTheRendererLeavesOut) {
    testing::internal::CaptureStderr();
    const SceneListing listing = listingOfWorld("Shape \"nurbs\"\nShape \"sphere\"");
    EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("nurbs"));
    ASSERT_EQ(listing.shapes.size(), 2u);
    EXPECT_EQ(listing.shapes[0].type, "nurbs");
}

TEST(SceneRecorder, ListsEachOfTheCurvesThatAreJoined) {
    const std::string curve = "Shape \"curve\" \"point P\" [0 0 0 1 0 0 2 0 0 3 0 0]\n";
    EXPECT_EQ(listingOfWorld(curve + curve + kTriangle).shapes.size(), 3u);
    EXPECT_NE(listingOfWorld(curve + curve + kTriangle).shapes[2].mesh, nullptr);
}

TEST(SceneRecorder, ResolvesTexturesWhereTheyAreUsed) {
    const std::string red = "Texture \"t\" \"spectrum\" \"constant\" \"rgb value\" [1 0 0]\n";
    const SceneListing listing = listingOfWorld(
        red + "Material \"matte\" \"texture Kd\" \"t\"\n" + kTriangle + "\nAttributeBegin\n" +
        "Texture \"t\" \"spectrum\" \"scale\" \"texture tex1\" \"t\"\nTexture \"t\" \"float\" \"constant\"\n" +
        "Material \"matte\" \"texture Kd\" \"t\"\n" + kTriangle + "\nAttributeEnd\n" +
        "Material \"matte\" \"texture Kd\" \"t\"\n" + kTriangle);
    ASSERT_EQ(listing.textures.size(), 3u);
    EXPECT_EQ(place(listing.textures[1].at), "s.pbrt:6:24");
    EXPECT_EQ(paramOf(listing.textures[1], "tex1").spectrumTexture, 0u);
    EXPECT_TRUE(listing.textures[2].isFloat);
    const auto kdOf = [&](size_t shape) { return paramOf(listing.materials[listing.shapes[shape].material], "Kd"); };
    EXPECT_EQ(kdOf(0).spectrumTexture, 0u);
    EXPECT_FALSE(kdOf(0).floatTexture.has_value());
    EXPECT_EQ(kdOf(1).spectrumTexture, 1u);
    EXPECT_EQ(kdOf(1).floatTexture, 2u);
    EXPECT_EQ(kdOf(2).spectrumTexture, 0u);  // AttributeEnd restores the name
}

TEST(SceneRecorder, ResolvesNamesThatPbrtV4DefinesLater) {
    const SceneListing listing =
        listingOfWorldV4(std::string("NamedMaterial \"m\"\n") + kTriangle +
                         " \"texture alpha\" \"a\"\nObjectInstance \"o\"\n"
                         "MakeNamedMaterial \"m\" \"string type\" \"diffuse\" \"texture reflectance\" \"t\"\n"
                         "Texture \"t\" \"spectrum\" \"constant\"\nTexture \"a\" \"float\" \"constant\"\n"
                         "ObjectBegin \"o\"\nShape \"sphere\"\nObjectEnd");
    ASSERT_EQ(listing.shapes.size(), 2u);
    EXPECT_EQ(listing.materials[listing.shapes[0].material].name, "m");
    EXPECT_EQ(paramOf(listing.materials[listing.shapes[0].material], "reflectance").spectrumTexture, 0u);
    EXPECT_EQ(paramOf(listing.shapes[0], "alpha").floatTexture, 1u);
    ASSERT_EQ(listing.instances.size(), 1u);
    EXPECT_EQ(listing.instances[0].object, 0u);
    EXPECT_EQ(listing.shapes[1].object, 0u);
}

TEST(SceneRecorder, CompletesParametersByAttributes) {
    const SceneListing listing =
        listingOfWorldV4("Attribute \"material\" \"float roughness\" .5\nMaterial \"conductor\"\nShape \"sphere\"");
    const ListedParam& roughness = paramOf(listing.materials[listing.shapes[0].material], "roughness");
    EXPECT_THAT(roughness.numbers, ElementsAre(.5));
    EXPECT_EQ(place(roughness.at), "s.pbrt:2:22");
}

TEST(SceneRecorder, KeepsObjectsAndInstances) {
    const SceneListing listing = listingOfWorld(
        "ObjectBegin \"o\" Scale 2 2 2 Shape \"sphere\" ObjectEnd\nShape \"disk\"\nTranslate 5 0 0\n"
        "ObjectInstance \"o\"");
    ASSERT_EQ(listing.objects.size(), 1u);
    EXPECT_EQ(listing.objects[0].name, "o");
    EXPECT_EQ(listing.shapes[0].object, 0u);
    EXPECT_EQ(image(listing.shapes[0].toWorld.start()), Vec3(2, 4, 6));
    EXPECT_FALSE(listing.shapes[1].object.has_value());
    EXPECT_EQ(place(listing.instances[0].at), "s.pbrt:5:16");
    EXPECT_EQ(image(listing.instances[0].toWorld.start()), Vec3(6, 2, 3));
}

TEST(SceneRecorder, KeepsLightsMediaAndMotion) {
    const SceneListing listing = listingOf(
        "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\"\nMediumInterface \"\" \"fog\"\n"
        "Camera \"perspective\"\nTransformTimes 0 2\nWorldBegin\nTranslate 0 0 1\n"
        "LightSource \"point\" \"rgb I\" [1 1 1]\nActiveTransform EndTime Translate 0 0 7 ActiveTransform All\n"
        "MediumInterface \"fog\" \"\"\n" +
        std::string(kTriangle) + "\nWorldEnd");
    EXPECT_EQ(listing.media[0].name, "fog");
    EXPECT_EQ(listing.media[0].type, "homogeneous");
    EXPECT_EQ(listing.cameraMedium, "fog");
    EXPECT_EQ(image(listing.lights[0].toWorld.start()), Vec3(1, 2, 4));
    EXPECT_FALSE(listing.lights[0].toWorld.isAnimated());
    EXPECT_EQ(image(listing.shapes[0].toWorld.at[1]), Vec3(1, 2, 11));
    EXPECT_EQ(listing.shapes[0].inside, "fog");
    EXPECT_THAT(listing.shapes[0].outside, IsEmpty());
    EXPECT_EQ(listing.transformTimes[1], 2);
}

TEST(SceneRecorder, ResolvesFilesAndPlacesAcrossIncludes) {
    const TemporaryFolder folder;
    folder.write("meshes/m.ply",
                 "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                 "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n0 1 0\n0 0 1\n3 0 1 2\n");
    folder.write("k.spd", "400 .5\n700 .5\n");
    folder.write("parts/inner.pbrt",
                 "\n  Shape \"plymesh\" \"string filename\" [ \"meshes/m.ply\" ]\n"
                 "Material \"matte\" \"spectrum Kd\" \"k.spd\" Shape \"sphere\"\n");
    const SceneListing listing = listingOfWorld("Include \"parts/inner.pbrt\"", folder.path());
    EXPECT_THAT(place(listing.shapes[0].at), EndsWith("parts/inner.pbrt:2:9"));
    EXPECT_THAT(paramOf(listing.shapes[0], "filename").strings, ElementsAre(folder.path("meshes/m.ply")));
    ASSERT_NE(listing.shapes[0].mesh, nullptr);
    EXPECT_EQ(listing.shapes[0].mesh->triangleCount(), 1u);
    const ListedParam& kd = paramOf(listing.materials[listing.shapes[1].material], "Kd");
    EXPECT_THAT(kd.strings, ElementsAre(folder.path("k.spd")));
    ASSERT_EQ(kd.colors.size(), 1u);
    EXPECT_NEAR(kd.colors[0].y, .5, .05);
}

TEST(SceneRecorder, KeepsTheFilesCoordinatesOfASceneFarFromZero) {
    const SceneListing listing =
        listingOf("Translate 0 0 5\nCamera \"perspective\"\nWorldBegin\nTranslate 100000 0 0\n" +
                  std::string(kTriangle) + "\nWorldEnd");
    EXPECT_NE(listing.origin.x, 0);
    ASSERT_EQ(listing.shapes.size(), 1u);  // although the file is read twice
    EXPECT_EQ(image(listing.shapes[0].toWorld.start()), Vec3(100001, 2, 3));
    EXPECT_EQ(image(listing.camera.toWorld.start()), Vec3(1, 2, -2));
    EXPECT_EQ(listing.shapes[0].mesh->positions[1] + listing.origin, Vec3(100001, 0, 0));
}

}  // namespace
}  // namespace drc::pbrt
