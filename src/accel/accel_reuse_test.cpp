// An Accel that takes over geometries from an earlier frame must find what one finds that was built from nothing.
#include <gtest/gtest.h>

#include "accel/accel.h"
#include "base/memory_use.h"
#include "pbrt/kept_contents.h"
#include "pbrt/scene_file.h"
#include "scene/ray_testing.h"

namespace drc {
namespace {

// A frame: the boxes and balls of `world`, in a room of fixed ones.
std::string frameOf(const std::string& world) {
    std::string text = R"(
LookAt 0 0 -5  0 0 0  0 1 0
Camera "perspective"
WorldBegin
Texture "holes" "float" "checkerboard" "float uscale" 5 "float vscale" 5 "float tex1" 0 "float tex2" 1
ObjectBegin "pair"
  Shape "sphere" "float radius" 0.3
  Shape "trianglemesh" "point P" [0 0 0  1 0 0  0 1 0] "integer indices" [0 1 2]
ObjectEnd
)";
    for (int i = 0; i < 12; ++i)
        text += fmt::format(
            "Shape \"trianglemesh\" \"point P\" [{0} -2 -2  {0} 2 -2  {0} 2 2  {0} -2 2] \"integer indices\" "
            "[0 1 2 0 2 3] \"texture alpha\" \"holes\"\n",
            -2 + 0.37 * i);
    return text + world + "WorldEnd\n";
}

struct Frame {
    std::unique_ptr<Scene> scene;
    std::unique_ptr<Accel> accel;
};

bool sameHits(const Accel& a, const Accel& b) {
    int different = 0, hits = 0;
    forManyRays(4000, [&](const Ray& ray) {
        SurfaceInteraction one, other;
        const bool found = a.intersect(ray, one);
        if (found != b.intersect(ray, other) || a.occluded(ray.o, ray.d, 3, 0) != b.occluded(ray.o, ray.d, 3, 0))
            ++different;
        else if (found && (one.p != other.p || one.ng != other.ng || one.uv != other.uv || one.t != other.t))
            ++different;
        hits += found;
    });
    EXPECT_GT(hits, 500);
    return different == 0;
}

TEST(AccelReuse, FindsTheSameAsBuiltFromNothing) {
    const std::string moved =
        "AttributeBegin Translate {} 0.2 0 Rotate 30 0 1 0 Shape \"sphere\" \"float radius\" 0.5\n"
        "Shape \"trianglemesh\" \"point P\" [0 0 0  1 0 0  0 1 1] \"integer indices\" [0 1 2] "
        "AttributeEnd\n";
    const std::string placed = "AttributeBegin Translate 0 {} 0.4 ObjectInstance \"pair\" AttributeEnd\n";
    const std::vector<std::string> worlds = {
        fmt::format(fmt::runtime(moved + placed), -0.5, 0.3),
        fmt::format(fmt::runtime(moved + placed), -0.5, 0.3),  // the same once more
        fmt::format(fmt::runtime(moved + placed), -0.2, 0.3),  // a shape moves
        fmt::format(fmt::runtime(moved + placed), 0.1, 0.3),   // and goes on
        fmt::format(fmt::runtime(moved + placed), 0.1, -0.8),  // an instance moves
        fmt::format(fmt::runtime(moved), 0.1),                 // it is gone
        "Material \"mirror\"\n" + fmt::format(fmt::runtime(moved + placed + placed), 0.1, 0.3, 1.2),
        "Shape \"sphere\" \"float radius\" 0.2\nShape \"sphere\" \"float radius\" 0.2\n",  // twice at the same place
        "Shape \"sphere\" \"float radius\" 0.2\n",
    };
    pbrt::KeptContents kept;
    Frame last;
    for (const std::string& world : worlds) {
        SCOPED_TRACE(world);
        Frame frame;
        frame.scene = pbrt::loadPbrtString(frameOf(world), ".", {.kept = &kept});
        frame.accel = std::make_unique<Accel>(*frame.scene, std::move(last.accel));
        last = std::move(frame);  // frees the scene of the frame before
        const std::unique_ptr<Scene> scene = pbrt::loadPbrtString(frameOf(world));
        const Accel fresh(*scene);
        EXPECT_TRUE(sameHits(*last.accel, fresh));
    }
}

// Primitives of the new frame decide about visibility and masks, also where the geometry is an old one.
TEST(AccelReuse, TakesAllButGeometryFromTheNewScene) {
    pbrt::KeptContents kept;
    const std::string ball = "Shape \"sphere\" \"float radius\" 0.5 ";
    const auto load = [&](const std::string& world) {
        return pbrt::loadPbrtString("WorldBegin\n" + world + "\nWorldEnd\n", ".", {.kept = &kept});
    };
    const auto first = load("Material \"matte\" " + ball);
    auto accel = std::make_unique<Accel>(*first);
    const auto second = load("Material \"none\" " + ball);
    EXPECT_EQ(first->primitives[0].shape, second->primitives[0].shape);
    EXPECT_TRUE(accel->occluded(Vec3(0, 0, -3), Vec3(0, 0, 1), 9, 0));
    accel = std::make_unique<Accel>(*second, std::move(accel));
    EXPECT_FALSE(accel->occluded(Vec3(0, 0, -3), Vec3(0, 0, 1), 9, 0));
    SurfaceInteraction hit;
    ASSERT_TRUE(accel->intersect(rayFrom(Vec3(0, 0, -3), Vec3(0, 0, 1)), hit));
    EXPECT_EQ(hit.primitive, &second->primitives[0]);
}

TEST(AccelReuse, MemoryDoesNotGrowWithFrames) {
    pbrt::KeptContents kept;
    Frame last;
    std::vector<int64_t> bytes;
    for (int i = 0; i < 12; ++i) {
        Frame frame;
        frame.scene = pbrt::loadPbrtString(
            frameOf(fmt::format("Translate {} 0 0 Shape \"loopsubdiv\" \"integer nlevels\" 5 \"point P\" [0 0 0 1 0 0 "
                                "0 1 0 0 0 1] \"integer indices\" [0 2 1 0 1 3 1 2 3 2 0 3]\n",
                                0.1 * i)),
            ".", {.kept = &kept});
        frame.accel = std::make_unique<Accel>(*frame.scene, std::move(last.accel));
        last = std::move(frame);
        bytes.push_back(memoryUse(MemoryUse::Accelerator));
    }
    EXPECT_NEAR(double(bytes[11]), double(bytes[3]), 0.05 * double(bytes[3]));
}

}  // namespace
}  // namespace drc
