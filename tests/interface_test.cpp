// Surfaces without a material (pbrt-v4's "interface", pbrt-v3's "none" and "") are as if they were not there, for rays
// of every kind and in every integrator.
#include <gtest/gtest.h>

#include "base/log.h"
#include "pictures.h"
#include "room_with_window.h"
#include "test_scenes.h"

namespace drc {
namespace {

using test::respelt;

constexpr int kWidth = 16, kHeight = 12;

// Panes and bubbles between the camera and all that it sees, around the lamp and the ball, touching nothing; within
// each other, as meshes, curves and instances, some of which move.
std::string nothings(const std::string& material) {
    const std::string shapes =
        test::quad("-1.9 -1.5 0.1", "1.9 -1.5 0.1", "1.9 -1.5 2.9", "-1.9 -1.5 2.9") +
        test::quad("-1.9 -1.9 2.5", "1.9 -1.9 2.5", "1.9 1.9 2.5", "-1.9 1.9 2.5") +
        test::quad("-1.9 -1.9 0.02", "1.9 -1.9 0.02", "1.9 1.9 0.02", "-1.9 1.9 0.02") +
        "AttributeBegin\nTranslate 0.5 -0.4 0.5\nShape \"sphere\" \"float radius\" 0.45\n"
        "Shape \"sphere\" \"float radius\" 0.6\nAttributeEnd\n"
        "AttributeBegin\nTranslate 0 0 2.15\nShape \"sphere\" \"float radius\" 0.8\n"
        "Shape \"cylinder\" \"float radius\" 0.9 \"float zmin\" 0.2 \"float zmax\" 0.8\nAttributeEnd\n"
        "AttributeBegin\nTranslate 0 0 1.5\nShape \"curve\" \"float width\" 0.4 \"point P\" [-1 -1 0  -0.5 -1 0.5  0.5 "
        "-1 "
        "-0.5  1 -1 0]\nAttributeEnd\n";
    const std::string object = "ObjectBegin \"bubble\"\nShape \"sphere\" \"float radius\" 0.5\n" +
                               test::quad("-1 -1 0", "1 -1 0", "1 1 0", "-1 1 0") + "ObjectEnd\n";
    return "AttributeBegin\n" + material + "\n" + shapes + object +
           "AttributeBegin\nTranslate 0.5 -0.4 0.5\nObjectInstance \"bubble\"\nAttributeEnd\n"
           "AttributeBegin\nTranslate -0.8 0 1.2\nRotate 40 1 1 0\nObjectInstance \"bubble\"\nAttributeEnd\n"
           "AttributeBegin\nActiveTransform EndTime\nTranslate 0.3 0 0\nActiveTransform All\nTranslate 0 -0.5 1\n"
           "ObjectInstance \"bubble\"\nShape \"sphere\" \"float radius\" 0.3\nAttributeEnd\nAttributeEnd\n";
}

// A room with a lamp, a mirror, a pane of glass and a glossy ball; and its own sky, which shines in where the ceiling
// is taken away.
std::string room(bool v4, const std::string& what) {
    const std::string glass = v4 ? "Material \"dielectric\"" : "Material \"glass\"";
    std::string text = test::room(glass, kWidth, kHeight);
    text =
        respelt(text, test::quad("-2 -2 3", "-2 2 3", "2 2 3", "2 -2 3"),
                "LightSource \"infinite\" \"rgb L\" [0.5 0.6 0.8]\nLightSource \"distant\" \"rgb L\" [1 1 1] \"point "
                "from\" [0.3 -0.2 1]\n");
    if (v4) text = respelt(text, "\"point from\"", "\"point3 from\"");
    text = respelt(text, "Integrator \"path\"\n", "Integrator \"path\" \"integer maxdepth\" 5\n");
    text = respelt(text, "WorldEnd", what + "WorldEnd");
    return v4 ? respelt(test::inWordsOfV4(text), "\"point P\"", "\"point3 P\"") : text;
}

struct Case {
    const char *integrator, *material;
    bool v4;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.integrator << " " << c.material; }

class SurfacesWithoutAMaterial : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(
    Every, SurfacesWithoutAMaterial,
    testing::Values(Case{"path", "Material \"interface\"", true}, Case{"bdpt", "Material \"interface\"", true},
                    Case{"drc", "Material \"interface\"", true}, Case{"drc-maps", "Material \"interface\"", true},
                    Case{"direct", "Material \"interface\"", true}, Case{"path", "Material \"none\"", false},
                    Case{"bdpt", "Material \"none\"", false}, Case{"drc", "Material \"\"", false},
                    Case{"drc-maps", "Material \"\"", false}, Case{"direct", "Material \"none\"", false},
                    Case{"path", "MakeNamedMaterial \"air\" \"string type\" \"interface\"\nNamedMaterial \"air\"",
                         true}),
    [](const auto& i) { return respelt(i.param.integrator, "-", "_") + "_" + std::to_string(i.index); });

std::vector<std::vector<Rgb>> picturesOf(const std::string& text, const char* integrator, int count, int spp, int block,
                                         bool guide = true) {
    const auto scene = pbrt::loadPbrtString(text);
    const auto change = [&](RenderParams& params) {
        params.cellSize = 0.1f;
        params.guide = guide;
    };
    return test::pictures(*scene,
                          {.integrator = integrator, .count = count, .spp = spp, .block = block, .change = change});
}

// The means of blocks of pixels are the same within the noise of the differences.
TEST_P(SurfacesWithoutAMaterial, AreNotThere) {
    const Case& c = GetParam();
    const auto seen = picturesOf(room(c.v4, nothings(c.material)), c.integrator, 24, 32, test::kBlock);
    auto differences = picturesOf(room(c.v4, ""), c.integrator, 24, 32, test::kBlock);
    const test::Estimate expected = test::estimateOfMeans(differences);
    for (size_t i = 0; i < seen.size(); ++i)
        for (size_t k = 0; k < seen[i].size(); ++k) differences[i][k] = seen[i][k] - differences[i][k];
    const test::Estimate zero = test::constantEstimate(seen[0].size() * 3, 0);
    const test::ZResult z = test::zTest(test::estimateOf(differences), zero);
    EXPECT_LT(z.worst, z.bound);
    const test::Estimate mean = test::estimateOfMeans(differences);
    for (size_t k = 0; k < 3; ++k) {
        EXPECT_LT(std::abs(mean.mean[k]), 4 * std::sqrt(mean.variance[k]) + 1e-4 * expected.mean[k]);
        EXPECT_LT(std::sqrt(mean.variance[k]), 0.005 * expected.mean[k]) << "too noisy to tell";
    }
}

// For camera paths, the same random numbers give the same picture, but for the rounding of rays that start anew at each
// surface, which may decide otherwise at an edge. Without the guide: the corners of the windows that it finds are where
// rays happen to hit, and move by a little, and with them all light samples.
TEST_P(SurfacesWithoutAMaterial, LeavePathsAsTheyAre) {
    const Case& c = GetParam();
    const std::string integrator = c.integrator;
    if (integrator != "path" && integrator != "direct") return;
    const std::vector<Rgb> seen = picturesOf(room(c.v4, nothings(c.material)), c.integrator, 1, 16, 1, false)[0];
    const std::vector<Rgb> expected = picturesOf(room(c.v4, ""), c.integrator, 1, 16, 1, false)[0];
    int different = 0, lit = 0;
    for (size_t i = 0; i < seen.size(); ++i) {
        different += length(seen[i] - expected[i]) > 2e-3f * length(expected[i]);
        lit += !isBlack(expected[i]);
    }
    EXPECT_GT(lit, kWidth * kHeight * 3 / 4);
    EXPECT_LT(different, kWidth * kHeight / 8);
}

// Panes in the window of a room, inside and outside of a portal.
TEST(NoMaterial, DoNotCloseAWindow) {
    const std::string panes =
        "AttributeBegin\nMaterial \"interface\"\n" +
        test::inWordsOfV4(test::quad("1.9 -1.5 0.5", "1.9 0.5 0.5", "1.9 0.5 2.5", "1.9 -1.5 2.5")) +
        test::inWordsOfV4(test::quad("2.3 -1.5 0.5", "2.3 0.5 0.5", "2.3 0.5 2.5", "2.3 -1.5 2.5")) + "AttributeEnd\n";
    for (const std::string portal : {"", " \"point3 portal\" [2 -1 1  2 -1 2  2 0 2  2 0 1]"}) {
        const std::string open = respelt(respelt(test::inWordsOfV4(test::roomWithWindow()),
                                                 "\"plastic\" \"rgb Kd\" [0.2 0.2 0.2] \"rgb Ks\" [0.5 0.5 0.5]",
                                                 "\"coateddiffuse\" \"rgb reflectance\" [0.2 0.2 0.2]"),
                                         "[3 4 5]", "[3 4 5]" + portal);
        const std::string paned = respelt(open, "Material \"coateddiffuse\"", panes + "Material \"coateddiffuse\"");
        for (const char* integrator : {"path", "bdpt", "drc"}) {
            const auto mean = [&](const std::string& text) {
                return test::estimateOfMeans(test::pictures(text, integrator, 1, 64)).mean;
            };
            const std::vector<double> seen = mean(paned), expected = mean(open);
            for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(seen[c] / expected[c], 1, 0.01) << integrator << portal;
        }
    }
}

// As in pbrt-v4, which warns of it. In pbrt-v3 such surfaces do emit.
TEST(NoMaterial, DoNotEmitInV4) {
    const auto lights = [](bool v4) {
        forgetWarnings();
        const std::string body = "AreaLightSource \"diffuse\"\nMaterial \"none\"\nShape \"sphere\"\n";
        return pbrt::loadPbrtString(v4 ? "Film \"rgb\"\nWorldBegin\n" + body : "WorldBegin\n" + body + "WorldEnd\n")
            ->lights.size();
    };
    EXPECT_EQ(lights(true), 0U);
    EXPECT_EQ(warningCount(), 1);
    EXPECT_EQ(lights(false), 1U);
    EXPECT_EQ(warningCount(), 0);
}

}  // namespace
}  // namespace drc
