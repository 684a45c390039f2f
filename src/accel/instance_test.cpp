// Compares instances with copies of their objects, and moving objects with static ones placed where the moving ones are
// at the ray's time.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "accel/accel.h"
#include "base/log.h"
#include "pbrt/scene_file.h"
#include "scene/ray_testing.h"

namespace drc {
namespace {

// A scene and its acceleration structure.
struct Traced {
    explicit Traced(const std::string& world, const std::string& options = "")
        : scene(pbrt::loadPbrtString(options + "WorldBegin\n" + world + "\nWorldEnd\n")), accel(*scene) {}
    bool hit(const Ray& ray, SurfaceInteraction& result) const { return accel.intersect(ray, result); }

    std::unique_ptr<Scene> scene;
    Accel accel;
};

// A bent sheet of triangles with normals and texture coordinates.
std::string sheet(int n, const std::string& parameters = "") {
    std::string p, normals, uv, indices;
    for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x) {
            const float u = float(x) / float(n), v = float(y) / float(n);
            const Vec3 normal = normalize(Vec3(-std::cos(3 * u), 0.2f, 1));
            p += fmt::format("{} {} {} ", 2 * u - 1, 2 * v - 1, 0.3f * std::sin(3 * u) - 0.1f * v);
            normals += fmt::format("{} {} {} ", normal.x, normal.y, normal.z);
            uv += fmt::format("{} {} ", u, v);
        }
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const int a = y * (n + 1) + x, b = a + n + 1;
            indices += fmt::format("{} {} {} {} {} {} ", a, a + 1, b, a + 1, b + 1, b);
        }
    return "Shape \"trianglemesh\" \"point P\" [" + p + "] \"normal N\" [" + normals + "] \"float uv\" [" + uv +
           "] \"integer indices\" [" + indices + "] " + parameters + "\n";
}

const std::string kCurve = "\"point P\" [-1 0 0  -0.5 1 0.4  0.5 -0.6 0.8  1 0.3 -0.2] \"float width\" 0.3 ";

struct Shaped {
    const char* name;
    std::string text;
    bool sided =
        false;  // pbrt flips normals of quadrics and ribbons when their own transform mirrors, not an instance's
    bool curve = false, placed = false;
};
std::vector<Shaped> shapes() {
    const std::string mask =
        "Texture \"m\" \"float\" \"checkerboard\" \"float uscale\" 6 \"float vscale\" 6 \"float tex1\" 0 "
        "\"float tex2\" 1\n";
    return {{"mesh", sheet(8)},
            {"mesh without normals",
             "Shape \"trianglemesh\" \"point P\" [-1 -1 0 1 -1 0.2 0 1 0.5] "
             "\"integer indices\" [0 1 2]\n"},
            {"reversed mesh", "ReverseOrientation\n" + sheet(4)},
            {"masked mesh", mask + sheet(6, "\"texture alpha\" \"m\"")},
            {"mesh without shadow", mask + sheet(6, "\"texture shadowalpha\" \"m\"")},
            {"placed within", "Translate 0.2 0 0.1 Rotate 20 0 1 0 Scale 1 0.5 1\n" + sheet(4), false, false, true},
            {"sphere", "Shape \"sphere\" \"float zmax\" 0.6 \"float phimax\" 300\n", true},
            {"reversed sphere", "ReverseOrientation Shape \"sphere\"\n", true},
            {"masked cylinder", mask + "Shape \"cylinder\" \"texture alpha\" \"m\"\n", true},
            {"disk", "Shape \"disk\"\n", true},
            {"cone", "Shape \"cone\"\n", true},
            {"flat curve", "Shape \"curve\" " + kCurve, false, true},
            {"round curve", "Shape \"curve\" \"string type\" \"cylinder\" " + kCurve, false, true},
            {"ribbon", "Shape \"curve\" \"string type\" \"ribbon\" \"normal N\" [0 0 1 0 1 1] " + kCurve, true, true}};
}

struct Placement {
    const char* name;
    std::string text;
    bool mirrors = false, stretches = false;
};
const std::vector<Placement>& placements() {
    static const std::vector<Placement> all = {
        {"turned", "Translate 0.3 0.2 -0.1 Rotate 40 1 1 0 Scale 1.2 1.2 1.2\n"},
        {"mirrored", "Translate 0.3 0.2 -0.1 Rotate 40 1 1 0 Scale -1 1 1\n", true},
        {"stretched", "Rotate 70 0 1 1 Scale 0.6 1.4 1 Rotate 30 1 0 0\n", false, true},
        {"mirrored and stretched", "Scale 0.6 -1.4 1 Rotate 30 1 0 0\n", true, true}};
    return all;
}

float relative(const Vec3& a, const Vec3& b) { return length(a - b) / std::max(1e-6f, length(a) + length(b)); }

TEST(Instances, AreCopies) {
    for (const Shaped& shape : shapes())
        for (const Placement& at : placements()) {
            if (shape.curve && at.stretches)
                continue;  // copies keep the widths of their curves, instances stretch them
            const std::string what = std::string(shape.name) + ", " + at.name;
            const Traced instance("ObjectBegin \"o\"\n" + shape.text + "ObjectEnd\n" + at.text +
                                  "ObjectInstance \"o\"");
            const Traced copy(at.text + shape.text);
            ASSERT_EQ(instance.scene->instances.size(), 1u);
            const bool sideIsOpen = shape.sided && at.mirrors;
            int hits = 0, missed = 0, different = 0;
            forManyRays(600, [&](const Ray& ray) {
                SurfaceInteraction a, b;
                const bool met = instance.hit(ray, a), expected = copy.hit(ray, b);
                EXPECT_TRUE(!met || (!a.moves && a.time == ray.time));
                const bool shadow = instance.accel.occluded(ray.o, ray.d, kInfinity, ray.time) ==
                                    copy.accel.occluded(ray.o, ray.d, kInfinity, ray.time);
                hits += met;
                missed += met != expected;
                if (!met && !expected && shadow) return;
                const float side = sideIsOpen && dot(a.ng, b.ng) < 0 ? -1.f : 1.f;
                const float tolerance = shape.curve ? 0.03f : 2e-3f;
                // Rounding may put rays at silhouettes and mask edges on either side.
                different += met != expected || !shadow || std::abs(a.t - b.t) > tolerance ||
                             length(a.p - b.p) > tolerance || std::abs(a.uv.x - b.uv.x) > tolerance ||
                             std::abs(a.uv.y - b.uv.y) > tolerance + (shape.curve ? 0.2f : 0.f) ||
                             dot(a.ng * side, b.ng) < 1 - tolerance || dot(a.ns * side, b.ns) < 1 - tolerance ||
                             relative(a.dpdu, b.dpdu) > tolerance || relative(a.dpdv, b.dpdv) > 5 * tolerance ||
                             std::abs(a.footprint - b.footprint) > tolerance;
            });
            EXPECT_GT(hits, shape.curve ? 10 : 30) << what;
            EXPECT_LE(missed, hits / 100 + 1) << what;
            EXPECT_LE(different, 2 + hits / 50) << what;
        }
}

TEST(Instances, NormalsArePerpendicularToWhatIsSeenUnderAnyPlacement) {
    for (const Placement& at : placements()) {
        const Traced scene("ObjectBegin \"o\"\nShape \"sphere\"\n" + sheet(12) + "ObjectEnd\n" + at.text +
                           "ObjectInstance \"o\"");
        int checked = 0;
        forManyRays(400, [&](const Ray& ray) {
            SurfaceInteraction hit;
            if (!scene.hit(ray, hit)) return;
            EXPECT_NEAR(length(hit.ng), 1, 1e-5);
            EXPECT_NEAR(length(hit.ns), 1, 1e-5);
            EXPECT_NEAR(dot(hit.ng, hit.dpdu) / length(hit.dpdu), 0, 1e-4) << at.name;
            EXPECT_NEAR(dot(hit.ng, hit.dpdv) / length(hit.dpdv), 0, 1e-4) << at.name;
            EXPECT_GT(dot(hit.ng, hit.ns), 0) << at.name;
            ++checked;
        });
        EXPECT_GT(checked, 100);
    }
}

// Resident memory of this process, in bytes.
size_t residentMemory() {
    std::ifstream file("/proc/self/statm");
    size_t total = 0, resident = 0;
    file >> total >> resident;
    return resident * size_t(sysconf(_SC_PAGESIZE));
}

TEST(Instances, ShareTheirMesh) {
    const std::string object = "ObjectBegin \"o\"\n" + sheet(70) + "ObjectEnd\n";  // 9800 triangles
    std::string many = object;
    constexpr int kCount = 10000;
    for (int i = 0; i < kCount; ++i)
        many += fmt::format("AttributeBegin Translate {} {} 0 ObjectInstance \"o\" AttributeEnd\n", 3 * (i % 100),
                            3 * (i / 100));
    const size_t before = residentMemory();
    const Traced scene(many);
    const size_t after = residentMemory();
    EXPECT_EQ(scene.scene->triangleCount(), size_t(kCount) * 9800);
    // Copies would take more than a hundred bytes per triangle, 10 GB in all.
    EXPECT_LT(double(after) - double(before), 60e6);
    SurfaceInteraction hit;
    ASSERT_TRUE(scene.hit(rayFrom(Vec3(150.1f, 60.2f, 5), Vec3(0, 0, -1)), hit));
    EXPECT_NEAR(hit.uv.x, 0.55f, 1e-4);
    EXPECT_NEAR(hit.uv.y, 0.6f, 1e-4);
    const Bounds bounds = scene.scene->bounds();
    EXPECT_NEAR(bounds.max.x, 298, 1e-3);
    EXPECT_NEAR(bounds.min.y, -1, 1e-3);
}

// A motion that rotates, translates and scales, written so that an object's own placement equals that of a static
// shape.
const std::string kMotion =
    "ActiveTransform StartTime Translate -1 0 0.2 Rotate 10 0 1 0\n"
    "ActiveTransform EndTime Translate 1 0.3 0 Rotate 130 1 1 0 Scale 1 1.5 1\nActiveTransform All\n";

TEST(MovingShapes, AreWhereTheyAreAtTheTime) {
    for (const Shaped& shape : shapes()) {
        if (shape.placed) continue;
        const Traced moving(kMotion + shape.text);
        const Traced still(shape.text);
        ASSERT_EQ(moving.scene->instances.size(), 1u);
        EXPECT_TRUE(moving.accel.anythingMoves());
        EXPECT_FALSE(still.accel.anythingMoves());
        const AnimatedTransform& motion = moving.scene->instances[0].objectToWorld;
        int hits = 0, missed = 0, different = 0;
        forManyRays(600, [&](const Ray& local) {
            // The same ray in the space of the moving object.
            const Transform toWorld = motion.at(local.time);
            const Vec3 d = toWorld.vector(local.d);
            const Ray ray = rayFrom(toWorld.point(local.o), normalize(d), local.time);
            SurfaceInteraction a, b;
            const bool met = moving.hit(ray, a), expected = still.hit(local, b);
            const bool shadow = moving.accel.occluded(ray.o, ray.d, kInfinity, ray.time) ==
                                still.accel.occluded(local.o, local.d, kInfinity, local.time);
            hits += met;
            missed += met != expected;
            if (!met && !expected && shadow) return;
            EXPECT_TRUE(!met || (a.moves && a.time == ray.time));
            const float tolerance = shape.curve ? 0.05f : 0.01f;  // allows for the error of Embree's interpolation
            different += met != expected || !shadow || std::abs(a.t - b.t * length(d)) > tolerance ||
                         length(a.p - toWorld.point(b.p)) > tolerance || std::abs(a.uv.x - b.uv.x) > tolerance ||
                         dot(a.ng, normalize(toWorld.normal(b.ng))) < 1 - tolerance ||
                         relative(a.dpdu, toWorld.vector(b.dpdu)) > tolerance;
        });
        EXPECT_GT(hits, shape.curve ? 10 : 30) << shape.name;
        EXPECT_LE(missed, hits / 100 + 1) << shape.name;
        EXPECT_LE(different, 3 + hits / 20) << shape.name;
    }
}

TEST(MovingShapes, HitsLieOnTheSurfaceThatRaysMeet) {
    // A ray that leaves a point on a plane must neither hit the plane again nor start behind it.
    const Traced scene(
        kMotion +
        "Shape \"trianglemesh\" \"point P\" [-3 -3 0 3 -3 0 3 3 0 -3 3 0] \"integer indices\" [0 1 2 0 2 3]\n");
    int hits = 0;
    forManyRays(2000, [&](const Ray& ray) {
        SurfaceInteraction hit, again;
        if (!scene.hit(ray, hit)) return;
        ++hits;
        const Vec3 n = faceForward(hit.ng, hit.wo);
        EXPECT_FALSE(scene.hit(hit.spawnRay(n), again));
        EXPECT_FALSE(scene.hit(hit.spawnRay(-n), again));
        EXPECT_FALSE(scene.hit(hit.spawnRay(normalize(n * 0.05f + normalize(hit.dpdu))), again));
        EXPECT_EQ(hit.spawnRay(n).time, ray.time);
    });
    EXPECT_GT(hits, 500);
}

TEST(MovingShapes, BoundsHoldTheWholeMotion) {
    // Rotations by 90 degrees and more, in which objects move far outside the bounds of their end positions.
    for (const std::string& motion :
         {kMotion, std::string("ActiveTransform EndTime Rotate 170 0 0 1 ActiveTransform All Translate 4 0 0\n")}) {
        const Traced scene(motion + "Shape \"sphere\"");
        const Bounds bounds = scene.scene->bounds();
        const AnimatedTransform& toWorld = scene.scene->instances[0].objectToWorld;
        for (int i = 0; i <= 1000; ++i) {
            const Vec3 p = toWorld.at(float(i) / 1000).point(Vec3(0, 0, 1));
            for (int c = 0; c < 3; ++c) EXPECT_TRUE(p[c] >= bounds.min[c] && p[c] <= bounds.max[c]);
        }
        EXPECT_LT(bounds.radius(), 10);
    }
}

TEST(MovingShapes, MoveWithinTheirObject) {
    // A part that rotates within an object whose instance moves, and a part that is static in both.
    const std::string world =
        "ObjectBegin \"o\"\n"
        "AttributeBegin Translate 0 0 -2 Shape \"sphere\" \"float radius\" 0.2\nAttributeEnd\n"
        "AttributeBegin ActiveTransform EndTime Rotate 90 0 0 1 ActiveTransform All Translate 1 0 0\n"
        "Shape \"sphere\" \"float radius\" 0.2\nAttributeEnd\nObjectEnd\n"
        "ActiveTransform EndTime Translate 0 0 3 ActiveTransform All ObjectInstance \"o\"";
    const Traced scene(world);
    ASSERT_EQ(scene.scene->instances.size(), 2u);
    for (const float time : {0.f, 0.25f, 0.5f, 1.f}) {
        // The rotation is about a point off the object's centre; translation is interpolated separately, so the path is
        // straight.
        for (const Vec3& center : {Vec3(0, 0, -2 + 3 * time), Vec3(1 - time, time, 3 * time)}) {
            SurfaceInteraction hit;
            ASSERT_TRUE(scene.hit(rayFrom(center + Vec3(0, 5, 0), Vec3(0, -1, 0), time), hit)) << time;
            EXPECT_LT(length(hit.p - center - Vec3(0, 0.2f, 0)), 0.01f) << time;
        }
    }
}

TEST(MovingShapes, ShareOneInstanceWhereTheyMoveAlike) {
    const std::string shape = "Shape \"sphere\"\n";
    const auto scene =
        pbrt::loadPbrtString("WorldBegin\nAttributeBegin\n" + kMotion + shape + shape + "AttributeEnd\n" + shape +
                             kMotion + shape + "Translate 1 0 0\n" + shape + "WorldEnd");
    EXPECT_EQ(scene->primitives.size(), 1u);
    EXPECT_EQ(scene->instances.size(), 2u);
    EXPECT_EQ(scene->objects.at(0).primitives.size(), 3u);
    EXPECT_EQ(scene->objects.at(1).primitives.size(), 1u);
}

}  // namespace
}  // namespace drc
