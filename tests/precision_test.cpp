// Scenes far from zero, very small ones, and surfaces very close to each other show what they show at the origin.
#include <gtest/gtest.h>

#include "pictures.h"

namespace drc {
namespace {

constexpr const char* kIntegrators[] = {"path", "bdpt", "drc"};

// Where a scene is put: scaled, then moved along x.
struct Place {
    const char* name;
    double x = 0, scale = 1;
};

// anchor: something too small to be seen, at zero, that keeps the scene from being moved there when it is loaded.
std::string placed(const Place& place, const std::string& view, const std::string& world, bool anchor) {
    const auto number = [](double v) { return fmt::format("{:.9g}", v); };
    const std::string inverse = number(1 / place.scale), scale = number(place.scale);
    return "Integrator \"path\" \"integer maxdepth\" 8\n" + view + "Scale " + inverse + " " + inverse + " " + inverse +
           "\nTranslate " + number(-place.x) + " 0 0\nCamera \"perspective\" \"float fov\" 60\n" +
           "Film \"image\" \"integer xresolution\" 16 \"integer yresolution\" 16\nWorldBegin\n" +
           (anchor && place.x != 0 ? "Shape \"sphere\" \"float radius\" 1e-3\n" : "") + "Translate " + number(place.x) +
           " 0 0\nScale " + scale + " " + scale + " " + scale + "\n" + world + "WorldEnd\n";
}

std::string quad(const std::string& corners) {
    return "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] \"point P\" [" + corners + "]\n";
}
// From -r to r in x and y, at this z.
std::string square(double r, double z) {
    return quad(fmt::format("{0} {0} {2}  {1} {0} {2}  {1} {1} {2}  {0} {1} {2}", -r, r, z));
}
// A closed box, whose sides share their edges.
std::string box(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    std::string points;
    for (int i = 0; i < 8; ++i)
        points += fmt::format("{:.9g} {:.9g} {:.9g}  ", i & 1 ? b[0] : a[0], i & 2 ? b[1] : a[1], i & 4 ? b[2] : a[2]);
    return "Shape \"trianglemesh\" \"integer indices\" [0 2 1 1 2 3  4 5 6 5 7 6  0 1 4 1 5 4  2 6 3 3 6 7  0 4 2 2 4 "
           "6  "
           "1 3 5 3 7 5] \"point P\" [" +
           points + "]\n";
}

test::Estimate seen(const std::string& text, const std::string& integrator, int count) {
    const auto scene = pbrt::loadPbrtString(text);
    return test::estimateOfMeans(test::pictures(*scene, {.integrator = integrator, .count = count, .spp = 16}));
}
// anchored: whether the scene stays where it is when it is loaded.
void expectSameEverywhere(const std::string& view, const std::string& world, std::span<const Place> places, int count,
                          bool anchored) {
    for (const char* integrator : kIntegrators) {
        const test::Estimate expected = seen(placed({"origin"}, view, world, false), integrator, count);
        for (const Place& place : places) {
            SCOPED_TRACE(std::string(integrator) + " " + place.name);
            test::expectSameMeans(expected, seen(placed(place, view, world, anchored), integrator, count));
        }
    }
}

const std::string kFromAbove = "LookAt 0 -0.5 1.5  0 0 0  0 1 0\n";

TEST(Precision, AThinPaneBeforeAWall) {
    const std::string world = "LightSource \"infinite\" \"rgb L\" [1 1 1]\nMaterial \"matte\" \"rgb Kd\" [.5 .5 .5]\n" +
                              square(1, 0) + "Material \"glass\"\n" + box({-1, -1, 0.01}, {1, 1, 0.01 + 1 / 256.}) +
                              "Material \"matte\" \"rgb Kd\" [0 0 0]\n" + box({-3, -3, -1}, {3, 3, -0.5});
    const Place anchored[] = {{"at 120", 120}, {"at 128", 128}, {"at 300", 300}};
    expectSameEverywhere(kFromAbove, world, anchored, 16, true);
    const Place moved[] = {{"at 65536", 65536},
                           {"a thousandth", 0, 1e-3},
                           {"a millionth, at .03", 0.03, 1e-6},
                           {"a thousand times", 0, 1e3}};
    expectSameEverywhere(kFromAbove, world, moved, 16, false);
}

TEST(Precision, NothingShinesThroughABoardCloseToAWall) {
    const std::string world =
        "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\n" + square(9, -1 / 128.) +
        "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [0 0 0]\nMaterial \"matte\" \"rgb Kd\" "
        "[0 0 0]\n" +
        square(9, 0) + "AttributeEnd\n";
    for (const Place& place :
         {Place{"at the origin"}, Place{"at 256", 256}, Place{"at 700", 700}, Place{"small", 0, 1e-4}})
        for (const char* integrator : kIntegrators) {
            const auto scene = pbrt::loadPbrtString(placed(place, kFromAbove, world, true));
            const auto seen = test::pictures(*scene, {.integrator = integrator, .count = 1, .spp = 4});
            for (const Rgb& block : seen[0]) EXPECT_EQ(block, Rgb(0.f)) << place.name << " " << integrator;
        }
}

TEST(Precision, ARoomAnywhereAndOfAnySize) {
    const std::string world =
        "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [3 3 3]\nTranslate .2 .3 .5 Shape \"sphere\" \"float "
        "radius\" "
        ".25\nAttributeEnd\nMaterial \"matte\" \"rgb Kd\" [.6 .6 .6]\n" +
        box({-1, -1, -1}, {1, 1, 1}) + "Rotate 30 1 2 3\n" + box({-.4, -.5, -.6}, {0, -.1, -.2});
    const std::string view = "LookAt -.8 -.9 .3  .1 .2 -.2  0 0 1\n";
    const Place anchored[] = {{"at 1024", 1024}};
    expectSameEverywhere(view, world, anchored, 16, true);
    const Place moved[] = {
        {"at 1024", 1024}, {"at 65536", 65536}, {"a millionth", 0, 1e-6}, {"a million times", 0, 1e6}};
    expectSameEverywhere(view, world, moved, 16, false);
}

TEST(Precision, NoLightComesThroughTheEdgesOfABox) {
    const std::string world = "Material \"matte\" \"rgb Kd\" [.8 .8 .8]\n" + box({-1, -1, -1}, {1, 1, 1}) +
                              "AttributeBegin\nRotate 20 1 1 0\n" + box({-5, -5, -5}, {5, 5, 5}) +
                              "AttributeEnd\nAreaLightSource \"diffuse\" \"rgb L\" [1000 1000 1000]\n"
                              "Translate 0 0 3 Shape \"sphere\" \"float radius\" 1.5\n";
    for (const char* integrator : kIntegrators) {
        const auto scene =
            pbrt::loadPbrtString(placed({"origin"}, "LookAt -.8 -.9 .3  .1 .2 -.2  0 0 1\n", world, false));
        const auto blocks = test::pictures(*scene, {.integrator = integrator, .count = 1, .spp = 1024})[0];
        for (const Rgb& block : blocks) EXPECT_EQ(block, Rgb(0.f)) << integrator;
    }
}

// Textures lie where the file puts them, also in a scene that is moved to the origin.
TEST(Precision, TexturesMoveWithTheirScene) {
    const auto scene = [](const std::string& mapping, const Place& place) {
        return placed(
            place, kFromAbove,
            "LightSource \"infinite\" \"rgb L\" [1 1 1]\nTexture \"t\" \"spectrum\" \"checkerboard\" " + mapping +
                " \"rgb tex1\" [.9 .1 .1] \"rgb tex2\" [.1 .1 .9]\nMaterial \"matte\" \"texture Kd\" \"t\"\n" +
                square(1, 0) + "Material \"matte\" \"rgb Kd\" [0 0 0]\n" + box({-2, -2, -1}, {2, 2, -0.5}),
            false);
    };
    for (const char* mapping :
         {"\"integer dimension\" 3", "\"string mapping\" \"planar\" \"vector v1\" [2 0 0] \"vector v2\" [0 2 0]",
          "\"string mapping\" \"spherical\"", "\"string mapping\" \"cylindrical\""}) {
        SCOPED_TRACE(mapping);
        // A distance that repeats the checkerboard; pbrt-v3 looks solid and planar textures up in world coordinates.
        const auto picture = [&](const Place& place) {
            return test::pictures(*pbrt::loadPbrtString(scene(mapping, place)),
                                  {.integrator = "path", .count = 1, .spp = 64, .block = 1})[0];
        };
        const auto here = picture({"origin"}), there = picture({"at 4096", 4096});
        double difference = 0, total = 0;
        for (size_t i = 0; i < here.size(); ++i) {
            difference += double(length(here[i] - there[i]));
            total += double(length(here[i]));
        }
        EXPECT_LT(difference, 0.02 * total);
    }
}

}  // namespace
}  // namespace drc
