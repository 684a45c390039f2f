// Scenes are read on all cores, and are the same for any number of them.
#include <gmock/gmock.h>

#include "base/parallel.h"
#include "pbrt/scene_file.h"
#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::HasSubstr;

class LoadingThreads : public testing::Test {
  protected:
    ~LoadingThreads() override { setThreadCount(threads_); }

    // A file with a strip of `count` triangles, and a line of text that names it.
    std::string mesh(int index, int count) {
        const std::string name = "m" + std::to_string(index) + ".ply";
        std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count + 2) +
                           "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                           std::to_string(count) + "\nproperty list uchar int vertex_indices\nend_header\n";
        for (int i = 0; i < count + 2; ++i)
            text += std::to_string(i) + " " + std::to_string(i % 2) + " " + std::to_string(index) + "\n";
        for (int i = 0; i < count; ++i)
            text += "3 " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 2) + "\n";
        folder_.write(name, text);
        return shape(name);
    }
    static std::string shape(const std::string& file) {
        return "Shape \"plymesh\" \"string filename\" \"" + file + "\"\n";
    }

    const int threads_ = threadCount();
    TemporaryFolder folder_;
};

TEST_F(LoadingThreads, AnyNumberReadsTheSameScene) {
    std::string world;
    for (int i = 0; i < 40; ++i) {
        const bool emits = i % 5 == 0;
        if (emits) world += "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [1 2 3]\n";
        world += mesh(i, 3 + 7 * i % 90);
        if (emits) world += "AttributeEnd\n";
    }
    const auto loadedBy = [&](int threads) {
        setThreadCount(threads);
        return loadWorld(world, folder_.path());
    };
    const auto serial = loadedBy(1);
    ASSERT_EQ(serial->primitives.size(), 40u);
    EXPECT_EQ(serial->lights.size(), 8u);
    for (const int threads : {2, 4}) {
        const auto scene = loadedBy(threads);
        ASSERT_EQ(scene->primitives.size(), serial->primitives.size());
        for (size_t i = 0; i < scene->primitives.size(); ++i) {
            const Primitive &a = serial->primitives[i], &b = scene->primitives[i];
            EXPECT_EQ(a.mesh->positions, b.mesh->positions) << i;
            EXPECT_EQ(a.mesh->indices, b.mesh->indices) << i;
            EXPECT_EQ(a.areaLight != nullptr, b.areaLight != nullptr) << i;
        }
        ASSERT_EQ(scene->lights.size(), serial->lights.size());
        for (size_t i = 0; i < scene->lights.size(); ++i) {
            EXPECT_EQ(scene->lights[i]->power(1), serial->lights[i]->power(1)) << i;
            EXPECT_EQ(scene->lights[i], scene->primitives[5 * i].areaLight) << i;
        }
    }
}

TEST_F(LoadingThreads, TheFirstDamagedMeshIsReported) {
    std::string world;
    for (int i = 0; i < 30; ++i) world += mesh(i, 400);
    folder_.write("m11.ply", "ply\nformat ascii 1.0\nelement vertex 3\n");
    // Found long before the other, and later in the file.
    folder_.write("m25.ply", "no mesh");
    for (const int threads : {1, 2, 4}) {
        setThreadCount(threads);
        const std::string error = errorOfWorld(world, folder_.path());
        EXPECT_THAT(error, HasSubstr("s.pbrt:13:7: cannot load the mesh")) << threads;
        EXPECT_THAT(error, HasSubstr("m11.ply")) << threads;
    }
}

}  // namespace
}  // namespace drc::pbrt
