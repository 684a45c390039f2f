// Guiding an environment must not change the expected picture, and must reduce its noise.
#include <gtest/gtest.h>

#include "pipeline.h"
#include "room_with_window.h"

namespace drc {
namespace {

using test::Estimate;
using test::Pipeline;

TEST(EnvironmentGuide, SamePictureLessNoise) {
    const Pipeline plain(test::roomWithWindow());
    Pipeline guided(test::roomWithWindow());
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
