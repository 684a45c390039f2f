#include "interior_generator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

namespace drc::interior {
namespace {

constexpr int kRooms = 24;
constexpr FilmSize kFilm{320, 240};

const std::vector<Interior>& rooms() {
    static const std::vector<Interior> all = [] {
        std::vector<Interior> v;
        for (int i = 1; i <= kRooms; ++i) v.push_back(generateInterior(7, i, kFilm));
        return v;
    }();
    return all;
}

// A minimal check of pbrt's grammar, enough to catch files that no reader would accept.
struct Tokens {
    std::vector<std::string> words;
    bool balanced = true;
    int attributeDepth = 0;
};

Tokens tokenize(const std::string& text) {
    Tokens t;
    bool inList = false;
    for (size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (std::isspace(static_cast<unsigned char>(c)) != 0) {
            ++i;
        } else if (c == '#') {
            i = text.find('\n', i);
        } else if (c == '[' || c == ']') {
            if (inList == (c == '[')) t.balanced = false;
            inList = c == '[';
            ++i;
        } else if (c == '"') {
            const size_t end = text.find('"', i + 1);
            if (end == std::string::npos) {
                t.balanced = false;
                break;
            }
            t.words.push_back(text.substr(i, end - i + 1));
            i = end + 1;
        } else {
            const size_t end = text.find_first_of(" \n[]\"", i);
            t.words.push_back(text.substr(i, end - i));
            if (t.words.back() == "AttributeBegin") ++t.attributeDepth;
            if (t.words.back() == "AttributeEnd" && --t.attributeDepth < 0) t.balanced = false;
            i = end;
        }
    }
    if (inList) t.balanced = false;
    return t;
}

TEST(InteriorGenerator, SameSeedGivesTheSameBytes) {
    for (int i : {1, 5, 9}) EXPECT_EQ(generateInterior(7, i, kFilm).pbrt, rooms()[static_cast<size_t>(i) - 1].pbrt);
}

TEST(InteriorGenerator, SeedsAndNumbersDiffer) {
    EXPECT_NE(rooms()[0].pbrt, rooms()[1].pbrt);
    EXPECT_NE(generateInterior(8, 1, kFilm).pbrt, rooms()[0].pbrt);
}

TEST(InteriorGenerator, FilesAreWellFormed) {
    const std::set<std::string> directives = {
        "LookAt",     "Camera",         "Film",         "Sampler",   "PixelFilter",       "Integrator",
        "WorldBegin", "WorldEnd",       "LightSource",  "Texture",   "MakeNamedMaterial", "NamedMaterial",
        "Shape",      "AttributeBegin", "AttributeEnd", "Translate", "ConcatTransform",   "AreaLightSource"};
    for (const Interior& room : rooms()) {
        const Tokens t = tokenize(room.pbrt);
        EXPECT_TRUE(t.balanced);
        EXPECT_EQ(t.attributeDepth, 0);
        EXPECT_EQ(t.words.back(), "WorldEnd");
        for (const std::string& w : t.words) {
            if (w[0] == '"') continue;
            if (std::isalpha(static_cast<unsigned char>(w[0])) != 0) {
                EXPECT_TRUE(directives.contains(w)) << w;
            } else {
                size_t used = 0;
                const double x = std::stod(w, &used);
                EXPECT_EQ(used, w.size()) << w;
                EXPECT_TRUE(std::isfinite(x));
            }
        }
    }
}

TEST(InteriorGenerator, IndicesAndNormalsFit) {
    for (const Interior& room : rooms()) {
        EXPECT_GT(room.draft.triangleCount(), 30u);
        EXPECT_LT(room.draft.triangleCount(), 60000u);
        for (const Mesh& m : room.draft.meshes) {
            EXPECT_EQ(m.uv.size(), m.p.size());
            EXPECT_EQ(m.n.size(), m.smooth ? m.p.size() : 0);
            ASSERT_FALSE(m.indices.empty());
            EXPECT_LT(*std::max_element(m.indices.begin(), m.indices.end()), static_cast<int>(m.p.size()));
            for (const Vec3& n : m.n) EXPECT_NEAR(length(n), 1, 1e-3f);
        }
    }
}

// The balance of light assumes that the mean above the horizon is 1.
TEST(InteriorGenerator, SkiesAreNormalised) {
    for (const Interior& room : rooms()) {
        const SkyImage& image = room.draft.skyImage;
        ASSERT_EQ(image.radiance.size(), size_t(image.width) * size_t(image.height));
        if (image.radiance.empty()) continue;
        double sum = 0, weights = 0;
        for (int y = 0; y < image.height / 2; ++y) {
            const double weight = std::sin((y + 0.5) * double(kPi) / image.height);
            for (int x = 0; x < image.width; ++x) {
                sum += weight * luminance(image.radiance[size_t(y * image.width + x)]);
                weights += weight;
            }
        }
        EXPECT_NEAR(sum / weights, 1, 1e-4);
    }
}

// Normals must agree with the winding of shapes, otherwise glass would take its inside for its outside.
TEST(InteriorGenerator, NormalsAgreeWithTheWinding) {
    for (const Interior& room : rooms()) {
        for (const Mesh& m : room.draft.meshes) {
            for (size_t i = 0; m.smooth && i < m.indices.size(); i += 3) {
                const auto at = [&](size_t k) { return static_cast<size_t>(m.indices[i + k]); };
                const Vec3 g = cross(m.p[at(1)] - m.p[at(0)], m.p[at(2)] - m.p[at(0)]);
                if (length(g) < 1e-7f) continue;
                EXPECT_GT(dot(g, m.n[at(0)] + m.n[at(1)] + m.n[at(2)]), 0);
            }
        }
    }
}

TEST(InteriorGenerator, SomethingShines) {
    for (const Interior& room : rooms()) {
        EXPECT_GT(room.draft.flux(), 0);
        for (const Emitter& e : room.draft.emitters) {
            EXPECT_GT(luminance(e.radiance), 0);
            EXPECT_GT(e.area(), 0);
        }
    }
}

TEST(InteriorGenerator, LightsFaceFreeSpace) {
    for (const Interior& room : rooms()) {
        for (const Emitter& e : room.draft.emitters) {
            const Vec3 front = e.shape == EmitterShape::Sphere ? e.center : e.center + e.normal * 0.01f;
            EXPECT_TRUE(room.draft.inFreeSpace(front)) << room.draft.summary;
        }
    }
}

// pbrt takes the emitting side of a quad from the order of its corners.
TEST(InteriorGenerator, QuadLightsAreWoundTowardsTheirNormal) {
    for (const Interior& room : rooms()) {
        for (const Emitter& e : room.draft.emitters) {
            if (e.shape != EmitterShape::Quad) continue;
            const World& w = room.world;
            const Vec3 a = w.point(e.center - e.u - e.v), b = w.point(e.center + e.u - e.v),
                       c = w.point(e.center + e.u + e.v);
            EXPECT_GT(dot(normalize(cross(b - a, c - a)), w.vector(e.normal)), 0.99f);
        }
    }
}

TEST(InteriorGenerator, CameraStandsInTheRoomAndInNothing) {
    for (const Interior& room : rooms()) {
        EXPECT_TRUE(room.draft.inFreeSpace(room.draft.eye));
        for (const OrientedBox& b : room.draft.footprints) EXPECT_FALSE(b.contains(room.draft.eye));
    }
}

TEST(InteriorGenerator, RoomsVary) {
    int sky = 0, paintedSky = 0, yUp = 0, interiorLight = 0;
    std::set<std::string> materials, shapes;
    const auto quoted = [](const std::string& parameters, size_t from) {
        return parameters.substr(from, parameters.find('"', from) - from);
    };
    for (const Interior& room : rooms()) {
        sky += !isBlack(room.draft.sky);
        yUp += room.world.yUp;
        interiorLight += !room.draft.emitters.empty();
        for (const Material& m : room.draft.materials) {
            materials.insert(quoted(m.parameters, m.parameters.find("[ \"") + 3));
        }
        for (const Shape& s : room.draft.shapes) shapes.insert(quoted(s.parameters, 1));
        paintedSky += !room.draft.skyImage.radiance.empty();
    }
    EXPECT_GT(sky, 2);
    EXPECT_LT(sky, kRooms - 2);
    EXPECT_GT(yUp, 4);
    EXPECT_LT(yUp, kRooms - 4);
    EXPECT_GT(interiorLight, kRooms / 2);
    EXPECT_THAT(materials, testing::UnorderedElementsAre("matte", "plastic", "metal", "mirror", "glass", "uber",
                                                         "substrate", "disney", "translucent", "mix"));
    EXPECT_THAT(shapes, testing::UnorderedElementsAre("sphere", "cylinder", "cone", "paraboloid", "hyperboloid",
                                                      "loopsubdiv", "curve"));
    EXPECT_GT(paintedSky, 1);
    EXPECT_LT(paintedSky, sky);
}

TEST(InteriorGenerator, WritesTheSceneAndItsTextures) {
    const std::filesystem::path directory = std::filesystem::path(testing::TempDir()) / "drc_rooms";
    const Interior room = writeInterior(directory, 7, 1, kFilm);
    std::ifstream file(directory / "room-0001" / "scene.pbrt", std::ios::binary);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), room.pbrt);
    for (const Texture& t : room.draft.textures) {
        if (t.file.empty()) continue;
        EXPECT_EQ(std::filesystem::file_size(directory / "room-0001" / t.file), 18u + t.rgb.size());
    }
    std::filesystem::remove_all(directory);
}

}  // namespace
}  // namespace drc::interior
