// An environment with a portal in the only window of a room must give the same picture as without, with less noise, in
// every integrator.
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
using test::respelt;
using test::roomUnder;
using test::sky;
using test::total;

// In the window, outward along +x.
const std::string kPortal = " \"point3 portal\" [2 -1 1  2 -1 2  2 0 2  2 0 1] ";

void expectSamePictureLessNoise(const std::string& environment) {
    constexpr int kSamples = 2048, kPlainSamples = 8 * kSamples;
    const Pipeline plain(roomUnder(environment)), portal(roomUnder(environment + kPortal));
    for (const auto way : {&Pipeline::path, &Pipeline::direct}) {
        const Estimate a = besideTheWindow(plain.estimate(way, kPlainSamples, 256));
        const Estimate b = besideTheWindow(portal.estimate(way, kSamples, 32));
        const test::ZResult z = test::zTest(a, b);
        EXPECT_EQ(z.tests, 27);
        EXPECT_LT(z.worst, z.bound);
        EXPECT_LT(z.meanDifference, z.bound);
        const double ratio = total(a.variance) * (kPlainSamples / kSamples) / total(b.variance);
        std::printf("variance without a portal over that with one, %s: %.0f\n",
                    way == &Pipeline::path ? "paths" : "direct light", ratio);
        EXPECT_GT(ratio, 20);
    }
}

TEST(Portal, SamePictureLessNoiseOfAConstantSky) { expectSamePictureLessNoise(kConstantSky); }

TEST(Portal, SamePictureLessNoiseOfAMap) {
    const TemporaryFolder folder;
    expectSamePictureLessNoise(sky(folder));
}

class PortalOfIntegrator : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Portal, PortalOfIntegrator, testing::Values("path", "bdpt", "drc", "drc-maps"),
                         [](const auto& i) { return test::respelt(i.param, "-", "_"); });

TEST_P(PortalOfIntegrator, GivesThePictureOfPathsWithoutIt) {
    const TemporaryFolder folder;
    for (const std::string& environment : {kConstantSky, sky(folder)}) {
        const auto paths = pictures(roomUnder(environment), "path", 24, 256);
        const auto seen = pictures(roomUnder(environment + kPortal), GetParam(), 24, 64);
        const Estimate a = test::estimateOfMeans(seen), b = test::estimateOfMeans(paths);
        // Maps of few texels blur what comes through a window.
        const double slack = GetParam() == std::string("drc-maps") ? 0.02 : 0.002;
        const test::ZResult z = test::zTest(test::allowing(slack, a, b), b);
        EXPECT_LT(z.worst, z.bound);
        for (size_t c = 0; c < 3; ++c)
            EXPECT_LT(std::sqrt(a.variance[c] + b.variance[c]), 0.015 * b.mean[c]) << "too noisy to tell";
    }
}

// A guide learns which parts of the portal are open.
TEST(Portal, IsGuided) {
    const std::string blind = test::quad("2.02 -1 1.25", "2.02 0 1.25", "2.02 0 2.2", "2.02 -1 2.2");
    const std::string environment = kConstantSky + kPortal + "\nMaterial \"diffuse\"\n" + test::inWordsOfV4(blind);
    const Pipeline plain(roomUnder(environment));
    Pipeline guided(roomUnder(environment));
    EnvironmentGuide guide(*guided.lights.infiniteLights().front(), 1);
    guided.tracer.setGuide(&guide);
    for (int pass = 0; pass < 64; ++pass) {
        for (int p = 0; p < guided.pixels(); ++p)
            for (int i = 0; i < 16; ++i) guided.path(p, 1000000 + pass * 16 + i);
        guide.update();
    }
    const Estimate a = besideTheWindow(plain.estimate(&Pipeline::path, 4096, 32));
    const Estimate b = besideTheWindow(guided.estimate(&Pipeline::path, 4096, 32));
    const test::ZResult z = test::zTest(a, b);
    EXPECT_LT(z.worst, z.bound);
    EXPECT_LT(z.meanDifference, z.bound);
    EXPECT_LT(total(b.variance), 0.8 * total(a.variance));
}

// A second window lets nothing in, and what stands outside is black: as if a black card were before the window.
TEST(Portal, NothingComesAnotherWay) {
    const std::string wall = test::inWordsOfV4(test::quad("-2 -2 0", "-2 2 0", "-2 2 3", "-2 -2 3"));
    ASSERT_NE(roomUnder(kConstantSky).find(wall), std::string::npos);
    const std::string card = "Material \"diffuse\" \"rgb reflectance\" [0 0 0]\n" + wall +
                             "Material \"diffuse\" \"rgb reflectance\" [0.6 0.5 0.4]\n";
    const std::string milk =
        "Material \"diffusetransmission\" \"rgb reflectance\" [0 0 0] \"rgb transmittance\" [0.9 0.9 0.9]\n";
    const std::string outside =
        "AttributeBegin\n" + milk +
        test::inWordsOfV4(test::quad("2.2 -1.1 1.5", "2.2 0.1 1.5", "2.2 0.1 2.3", "2.2 -1.1 2.3")) + "AttributeEnd\n";
    const std::string open = respelt(roomUnder(kConstantSky + kPortal), wall, outside);
    const std::string closed = respelt(respelt(roomUnder(kConstantSky), wall, card + outside), milk,
                                       "Material \"diffuse\" \"rgb reflectance\" [0 0 0]\n");
    const auto expected = pictures(closed, "path", 24, 256);
    for (const char* integrator : {"path", "bdpt", "drc"}) {
        const auto seen = pictures(open, integrator, 24, 64);
        const Estimate a = test::estimateOfMeans(seen), b = test::estimateOfMeans(expected);
        const test::ZResult z = test::zTest(test::allowing(0.005, a, b), b);
        EXPECT_LT(z.worst, z.bound) << integrator;
        for (size_t c = 0; c < 3; ++c)
            EXPECT_LT(std::sqrt(a.variance[c] + b.variance[c]), 0.015 * b.mean[c]) << "too noisy to tell";
    }
}

// Walls that emit what they do not reflect, and a sky of the same radiance.
TEST(Portal, InAFurnaceIsNotSeen) {
    const std::string lamp =
        "\nAreaLightSource \"diffuse\" \"rgb L\" [0.5 0.5 0.5] \"bool twosided\" true\nMaterial \"diffuse\" \"rgb "
        "reflectance\" [0.5 0.5 0.5]\n";
    std::string text = roomUnder("LightSource \"infinite\" \"rgb L\" [1 1 1]" + kPortal + lamp);
    text = respelt(text, "Material \"diffuse\" \"rgb reflectance\" [0.6 0.5 0.4]\n", "");
    const size_t ball = text.find("Material \"coateddiffuse\"");
    ASSERT_NE(ball, std::string::npos);
    text = text.substr(0, ball) + text.substr(text.find('\n', ball));
    for (const char* integrator : {"path", "bdpt", "drc", "drc-maps"}) {
        const Estimate seen = test::estimateOfMeans(pictures(
            respelt(text, "Integrator \"path\"", "Integrator \"path\" \"integer maxdepth\" 64"), integrator, 16, 32));
        for (size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(seen.mean[c], 1, 4.5 * std::sqrt(seen.variance[c]) + 1e-3) << integrator;
    }
}

}  // namespace
}  // namespace drc
