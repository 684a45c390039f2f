// Direct light that integrators keep apart (RenderParams::parts) is what paths of a single vertex see: the same samples
// that make the picture, cut off.
#include <gtest/gtest.h>

#include "pbrt/scene_file.h"
#include "render/session.h"
#include "room_with_window.h"
#include "test_scenes.h"

namespace drc {
namespace {

LayeredPicture pictureOf(Scene& scene, const std::string& integrator, bool parts, int maxDepth) {
    RenderParams params;
    params.integrator = integrator;
    params.spp = 8;
    params.parts = parts;
    params.maxDepth = maxDepth;
    params.gBuffer = true;
    // It learns from all vertices, and longer paths have more of them.
    params.guide = false;
    Session session(scene, params);
    while (session.step()) {
    }
    return session.snapshot();
}

void expectEqual(const Image& a, const Image& b, const std::string& what) {
    ASSERT_EQ(a.data().size(), b.data().size());
    for (size_t i = 0; i < a.data().size(); ++i)
        ASSERT_NEAR(a.data()[i], b.data()[i], 1e-5f * std::max(1.f, std::abs(b.data()[i]))) << what << ", value " << i;
}

const std::string kFog =
    "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" \"rgb sigma_s\" [.2 .2 .2] \"rgb sigma_a\" [.05 .05 .05]\n"
    "MediumInterface \"\" \"fog\"\n";

TEST(DirectPart, IsThatOfPathsOfOneVertex) {
    // Lamps, mirrors and glass; and a room full of fog, whose first vertex may be in the air.
    const std::string glass = test::room("Material \"glass\"", 12, 8),
                      mirror = test::room("Material \"mirror\"", 12, 8);
    for (const std::string& text : {glass, mirror, test::roomWithWindow(), kFog + test::roomWithWindow()}) {
        const auto scene = pbrt::loadPbrtString(text, ".", {}, "room.pbrt");
        for (const char* integrator : {"path", "drc"}) {
            const LayeredPicture picture = pictureOf(*scene, integrator, true, 16);
            ASSERT_TRUE(picture.hasParts());
            const Image direct = picture.part("direct"), indirect = picture.part("indirect");
            const LayeredPicture one = pictureOf(*scene, "path", false, 1);
            expectEqual(direct, one.part(""), integrator);
            double light = 0;
            for (size_t i = 0; i < direct.data().size(); ++i) {
                light += indirect.data()[i];
                ASSERT_NEAR(direct.data()[i] + indirect.data()[i], picture.part("").data()[i], 1e-5f);
            }
            EXPECT_GT(light, 0) << integrator;
            // To keep it apart changes nothing.
            EXPECT_EQ(picture.beauty.data(), pictureOf(*scene, integrator, false, 16).beauty.data()) << integrator;
        }
    }
}

TEST(DirectPart, IsNotThereWithIntegratorsThatCannotTell) {
    const auto scene = pbrt::loadPbrtString(test::roomWithWindow(), ".", {}, "room.pbrt");
    for (const char* integrator : {"bdpt", "direct"})
        EXPECT_FALSE(pictureOf(*scene, integrator, true, 4).hasParts()) << integrator;
}

}  // namespace
}  // namespace drc
