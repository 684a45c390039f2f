// The numbers of objects and materials, and where the objects are.
#include <gtest/gtest.h>

#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

std::string world(const std::string& place, const std::string& colour, const std::string& light = "") {
    return light + "Material \"matte\" \"rgb Kd\" [" + colour +
           "]\n"
           "ObjectBegin \"pair\" Shape \"sphere\" Translate 1 0 0 Shape \"sphere\" ObjectEnd\n" +
           "AttributeBegin " + place + " Shape \"sphere\" AttributeEnd\n" + "AttributeBegin Material \"mirror\" " +
           place +
           " ObjectInstance \"pair\" Shape \"trianglemesh\" \"point P\" [0 0 0 1 0 0 0 1 0] "
           "\"integer indices\" [0 1 2] AttributeEnd\n"
           "Shape \"sphere\" \"float radius\" 9";
}

struct Numbers {
    std::vector<uint32_t> objects, instances, materials;
    bool operator==(const Numbers&) const = default;
};

Numbers numbersOf(const std::string& text) {
    const auto scene = loadWorld(text);
    Numbers numbers;
    for (const Primitive& p : scene->primitives) {
        if (p.objectNumber == 0) continue;
        numbers.objects.push_back(p.objectNumber);
        numbers.materials.push_back(p.materialNumber);
    }
    for (const Instance& i : scene->instances) numbers.instances.push_back(i.objectNumber);
    return numbers;
}

TEST(ObjectNumbers, AreThoseOfTheFilesOrder) {
    const Numbers numbers = numbersOf(world("Translate 1 2 3", ".5 .5 .5"));
    EXPECT_EQ(numbers.objects, (std::vector<uint32_t>{1, 3, 4}));
    EXPECT_EQ(numbers.instances, std::vector<uint32_t>{2});
    EXPECT_EQ(numbers.materials, (std::vector<uint32_t>{1, 2, 1}));
}

TEST(ObjectNumbers, DoNotDependOnPlacesLightsAndParameters) {
    const Numbers numbers = numbersOf(world("Translate 1 2 3", ".5 .5 .5"));
    EXPECT_EQ(numbersOf(world("Rotate 30 0 1 0 Scale 1 2 1", ".5 .5 .5")), numbers);
    EXPECT_EQ(numbersOf(world("", ".9 .1 .1")), numbers);
    EXPECT_EQ(numbersOf(world("", ".5 .5 .5", "LightSource \"point\"\n")), numbers);
    // The moving shapes of a file are instances, one of which has two shapes.
    const std::string moving = "ActiveTransform EndTime Translate 0 1 0 ActiveTransform All";
    EXPECT_EQ(numbersOf(world("", ".5 .5 .5")).objects.size(), 3);
    const auto scene = loadWorld(world(moving, ".5 .5 .5"));
    std::vector<uint32_t> inObjects;
    for (const ObjectDefinition& object : scene->objects)
        for (const Primitive& p : object.primitives)
            if (p.objectNumber > 0) inObjects.push_back(p.objectNumber);
    EXPECT_EQ(inObjects, (std::vector<uint32_t>{1, 3}));
}

TEST(ObjectNumbers, AreGivenWhereAnObjectIsLeftOut) {
    const std::string last = "Shape \"sphere\"";
    EXPECT_EQ(numbersOf("ObjectInstance \"missing\"\n" + last).objects, std::vector<uint32_t>{2});
}

TEST(ObjectNumbers, TellThePlaces) {
    const auto scene = loadWorld(world("Translate 1 2 3 Rotate 90 0 0 1", ".5 .5 .5"));
    const ObjectPlacements places = scene->placements.at(0);
    for (const uint32_t moved : {1u, 2u, 3u}) {
        const Vec3 p = places.of(moved).point(Vec3(1, 0, 0));
        EXPECT_NEAR(length(p - Vec3(1, 3, 3)), 0, 1e-6f) << moved;
    }
    EXPECT_TRUE(places.of(4).isIdentity());
    EXPECT_EQ(places.size(), 3);
}

// The shapes of an instance have the transformation of the object's beginning, too.
TEST(ObjectNumbers, TellThePlacesOfInstancesWithTheirObjects) {
    const auto scene = loadWorld(
        "Translate 1 0 0 ObjectBegin \"o\" Translate 0 0 5 Shape \"sphere\" ObjectEnd Translate 0 3 0 ObjectInstance "
        "\"o\"");
    EXPECT_EQ(scene->placements.at(0).of(1).point(Vec3(0.f)), Vec3(2, 3, 0));
    // In pbrt-v4 an object may be defined after its use.
    const auto later = loadWorldV4(
        "ObjectInstance \"o\" Shape \"sphere\" Translate 1 0 0 ObjectBegin \"o\" Shape \"sphere\" ObjectEnd");
    EXPECT_EQ(later->placements.at(0).of(1).point(Vec3(0.f)), Vec3(1, 0, 0));
    EXPECT_TRUE(later->placements.at(0).of(2).isIdentity());
}

TEST(ObjectNumbers, TellThePlacesOfWhatMoves) {
    const auto scene = loadWorld("ActiveTransform EndTime Translate 0 2 0 ActiveTransform All Shape \"sphere\"");
    EXPECT_FLOAT_EQ(scene->placements.at(0.5f).of(1).point(Vec3(0.f)).y, 1);
    EXPECT_FLOAT_EQ(scene->placements.at(0).of(1).point(Vec3(0.f)).y, 0);
}

// Far from zero the scene has an origin of its own, the places have not.
TEST(ObjectNumbers, TellThePlacesInTheFilesWorld) {
    const auto scene = loadWorld("Translate 5000 0 0 Shape \"sphere\" Translate 0 3 0 Shape \"sphere\"");
    EXPECT_NE(scene->origin.x, 0);
    EXPECT_EQ(scene->placements.at(0).of(1).point(Vec3(0.f)).x, 5000);
}

}  // namespace
}  // namespace drc::pbrt
