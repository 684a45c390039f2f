// Windows of a room through which an environment is sampled, given, found or wrong, must not change the expected
// picture. The right ones must reduce its noise.
#include <gtest/gtest.h>

#include "pictures.h"
#include "pipeline.h"
#include "room_with_window.h"

namespace drc {
namespace {

using test::besideTheWindow;
using test::Estimate;
using test::kConstantSky;
using test::pictures;
using test::Pipeline;
using test::roomUnder;
using test::total;

const Portal kWindow({Vec3(2, -1, 1), Vec3(2, -1, 2), Vec3(2, 0, 2), Vec3(2, 0, 1)});

std::vector<std::string> skies(const TemporaryFolder& folder) { return {kConstantSky, test::sky(folder)}; }

struct Guided {
    Pipeline pipeline;
    EnvironmentGuide guide;

    Guided(const std::string& text, const std::vector<Portal>& windows, int passes)
        : pipeline(text), guide(EnvironmentWindows(*pipeline.lights.infiniteLights().front(), windows), 1) {
        pipeline.tracer.setGuide(&guide);
        for (int pass = 0; pass < passes; ++pass) {
            for (int p = 0; p < pipeline.pixels(); ++p)
                for (int i = 0; i < 4; ++i) pipeline.path(p, 1000000 + pass * 4 + i);
            guide.update();
        }
    }
};

void expectSame(const Estimate& a, const Estimate& b, const char* what) {
    const test::ZResult z = test::zTest(a, b);
    EXPECT_EQ(z.tests, 27);
    EXPECT_LT(z.worst, z.bound) << what;
    EXPECT_LT(z.meanDifference, z.bound) << what;
}

TEST(EnvironmentWindows, SamePictureLessNoise) {
    const TemporaryFolder folder;
    for (const std::string& sky : skies(folder)) {
        constexpr int kSamples = 2048, kPlainSamples = 8 * kSamples;
        const Pipeline plain(roomUnder(sky));
        Guided guided(roomUnder(sky), {}, 32), windows(roomUnder(sky), {kWindow}, 32);
        for (const auto way : {&Pipeline::path, &Pipeline::direct}) {
            const char* name = way == &Pipeline::path ? "paths" : "direct light";
            const Estimate a = besideTheWindow(plain.estimate(way, kPlainSamples, 256));
            const Estimate b = besideTheWindow(guided.pipeline.estimate(way, kSamples, 32));
            const Estimate c = besideTheWindow(windows.pipeline.estimate(way, kSamples, 32));
            expectSame(a, c, name);
            std::printf("variance over that with the window, %s: %.1f with a guide, %.1f without\n", name,
                        total(b.variance) / total(c.variance),
                        total(a.variance) * (kPlainSamples / kSamples) / total(c.variance));
            EXPECT_GT(total(b.variance), 4 * total(c.variance));
        }
    }
}

// One in the middle of the room, one that is half of the right one, one in a closed wall, and one that looks inwards.
TEST(EnvironmentWindows, ThatAreWrongDoNoHarm) {
    const std::vector<Portal> wrong = {
        Portal({Vec3(0.5f, -1, 0.5f), Vec3(0.5f, -1, 2), Vec3(0.5f, 1, 2), Vec3(0.5f, 1, 0.5f)}),
        Portal({Vec3(2, -1, 1), Vec3(2, -1, 1.5f), Vec3(2, 0, 1.5f), Vec3(2, 0, 1)}),
        Portal({Vec3(-2, 0, 1), Vec3(-2, 0, 2), Vec3(-2, -1, 2), Vec3(-2, -1, 1)}),
        Portal({Vec3(2, 0, 1), Vec3(2, 0, 2), Vec3(2, -1, 2), Vec3(2, -1, 1)})};
    const TemporaryFolder folder;
    for (const std::string& sky : skies(folder)) {
        const Pipeline plain(roomUnder(sky));
        for (const auto way : {&Pipeline::path, &Pipeline::direct}) {
            const Estimate expected = besideTheWindow(plain.estimate(way, 16384, 256));
            for (const int passes : {0, 16}) {
                Guided windows(roomUnder(sky), wrong, passes);
                expectSame(expected, besideTheWindow(windows.pipeline.estimate(way, 4096, 64)),
                           way == &Pipeline::path ? "paths" : "direct light");
            }
        }
    }
}

// What a rendering finds by itself is as good as a portal in the same place, and gives what bdpt does, which knows
// neither.
class WindowsFoundBy : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(EnvironmentWindows, WindowsFoundBy, testing::Values("path", "drc"),
                         [](const auto& i) { return i.param; });

TEST_P(WindowsFoundBy, AreAsGoodAsAPortal) {
    const std::string portal = " \"point3 portal\" [2 -1 1  2 -1 2  2 0 2  2 0 1] ";
    const TemporaryFolder folder;
    for (const std::string& sky : skies(folder)) {
        const Estimate found = test::estimateOfMeans(pictures(roomUnder(sky), GetParam(), 24, 64));
        const Estimate given = test::estimateOfMeans(pictures(roomUnder(sky + portal), GetParam(), 24, 64));
        const Estimate expected = test::estimateOfMeans(pictures(roomUnder(sky), "bdpt", 24, 128));
        const test::ZResult z = test::zTest(test::allowing(0.002, found, expected), expected);
        EXPECT_LT(z.worst, z.bound);
        std::printf("variance over that with a portal: %.2f\n", total(found.variance) / total(given.variance));
        EXPECT_LT(total(found.variance), 4 * total(given.variance));
    }
}

}  // namespace
}  // namespace drc
