// Guiding an environment must not change the expected picture, and must reduce its noise.
#include <gtest/gtest.h>

#include "pipeline.h"
#include "test_scenes.h"

namespace drc {
namespace {

using test::Estimate;
using test::Pipeline;

// A room that sees the sky through one window. The sky also lights a glossy ball by BSDF samples.
std::string roomWithWindow() {
    using test::quad;
    return "LookAt 0 -1.9 1.5  0 0 1  0 0 1\nCamera \"perspective\" \"float fov\" 70\n"
           "Film \"image\" \"integer xresolution\" 12 \"integer yresolution\" 8\nIntegrator \"path\"\nWorldBegin\n"
           "LightSource \"infinite\" \"rgb L\" [3 4 5]\n"
           "Material \"matte\" \"rgb Kd\" [0.6 0.5 0.4]\n" +
           quad("-2 -2 0", "2 -2 0", "2 2 0", "-2 2 0") + quad("-2 -2 3", "-2 2 3", "2 2 3", "2 -2 3") +
           quad("-2 2 0", "2 2 0", "2 2 3", "-2 2 3") + quad("-2 -2 0", "-2 -2 3", "2 -2 3", "2 -2 0") +
           quad("-2 -2 0", "-2 2 0", "-2 2 3", "-2 -2 3") + quad("2 -2 0", "2 -2 3", "2 -1 3", "2 -1 0") +
           quad("2 0 0", "2 0 3", "2 2 3", "2 2 0") + quad("2 -1 0", "2 -1 1", "2 0 1", "2 0 0") +
           quad("2 -1 2", "2 -1 3", "2 0 3", "2 0 2") +
           "Material \"plastic\" \"rgb Kd\" [0.2 0.2 0.2] \"rgb Ks\" [0.5 0.5 0.5] \"float roughness\" 0.2\n"
           "Translate 0.3 0.3 0.6\nShape \"sphere\" \"float radius\" 0.5\nWorldEnd\n";
}

TEST(EnvironmentGuide, SamePictureLessNoise) {
    const Pipeline plain(roomWithWindow());
    Pipeline guided(roomWithWindow());
    EnvironmentGuide guide(*guided.lights.infiniteLights().front(), 1);
    guided.tracer.setGuide(&guide);
    for (int pass = 0; pass < 64; ++pass) {
        for (int p = 0; p < guided.pixels(); ++p)
            for (int i = 0; i < 4; ++i) guided.path(p, 1000000 + pass * 4 + i);
        guide.update();
    }
    const Estimate a = plain.estimate(&Pipeline::path, 2048, 32), b = guided.estimate(&Pipeline::path, 2048, 32);
    const test::ZResult z = test::zTest(a, b);
    EXPECT_LT(z.worst, z.bound);
    EXPECT_LT(z.meanDifference, z.bound);
    EXPECT_LT(z.meanSquare, 1.5);
    double before = 0, after = 0;
    for (const double v : a.variance) before += v;
    for (const double v : b.variance) after += v;
    EXPECT_LT(after, 0.8 * before);
    RecordProperty("variance ratio", std::to_string(after / before));
}

}  // namespace
}  // namespace drc
