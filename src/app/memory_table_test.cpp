#include "app/memory_table.h"

#include <gtest/gtest.h>

#include "pbrt/scene_file.h"
#include "render/session.h"

namespace drc {
namespace {

// Two meshes of two triangles, one of them an object with two instances.
const char* const kScene = R"(
    Film "image" "integer xresolution" 512 "integer yresolution" 512
    Camera "perspective"
    WorldBegin
    ObjectBegin "o"
    Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "point P" [0 0 5  1 0 5  1 1 5  0 1 5]
    ObjectEnd
    ObjectInstance "o" ObjectInstance "o"
    Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "point P" [0 0 5  1 0 5  1 1 5  0 1 5]
        "normal N" [0 0 1 0 0 1 0 0 1 0 0 1] "float uv" [0 0 1 0 1 1 0 1]
    WorldEnd)";

TEST(MemoryTable, CountsEachMeshOnce) {
    const auto scene = pbrt::loadPbrtString(kScene, ".");
    EXPECT_EQ(meshBytes(*scene), 2 * (4 * 12 + 6 * 4) + 4 * 12 + 4 * 8);
}

TEST(MemoryTable, TheRowsAddUpToThePeak) {
    MemoryTable table;
    const auto scene = pbrt::loadPbrtString(kScene, ".");
    Stats stats;
    RenderParams params;
    params.integrator = "path";
    params.spp = 1;
    params = resolved(params, scene->sensor.settings);
    Session session(*scene, params, &stats);
    table.afterBuilding(*scene);
    while (session.step(nullptr)) {
    }
    table.afterRendering(session, stats);
    session.endSampling();
    table.beforeFinishing();
    {
        // What finishing takes, which makes it the largest stage.
        const std::vector<char> buffer(size_t(processMemory().peak - processMemory().resident) + (size_t(96) << 20), 1);
        table.afterFinishing();
        EXPECT_EQ(buffer.back(), 1);
    }
    table.report(stats);
    const auto row = [&](const std::string& name) { return stats.count("memory, MB/" + name); };
    const int64_t total = row("total, at the peak");
    EXPECT_NEAR(double(total), double(processMemory().peak) * 1e-6, 2);
    EXPECT_NEAR(double(row("program and libraries") + row("geometry") + row("accelerator") + row("textures") +
                       row("film") + row("finishing the picture") + row("other")),
                double(total), 4);
    EXPECT_GE(row("finishing the picture"), 96);
    const double film = double(session.film().bytesPerPixel()) * 512 * 512 * 1e-6;
    EXPECT_NEAR(double(row("film")), film, 1);
    EXPECT_GE(row("film"), 3);
}

}  // namespace
}  // namespace drc
