// Pictures of homogeneous media, by path tracing and by final gather: closed forms, quadratures and invariants.
#include <gtest/gtest.h>

#include <cmath>

#include "base/log.h"
#include "gathered_pictures.h"
#include "pictures.h"
#include "test_scenes.h"

namespace drc {
namespace {

using test::respelt;

constexpr double kPiD = std::numbers::pi;

// A scene that is seen along the z axis, from -5, in a picture so narrow that all of its rays are the axis.
std::string alongTheAxis(const std::string& before, const std::string& world, int maxDepth = 100) {
    return "LookAt 0 0 -5  0 0 0  0 1 0\n" + before +
           "\nCamera \"perspective\" \"float fov\" 0.01\n"
           "Film \"image\" \"integer xresolution\" 8 \"integer yresolution\" 8\n"
           "Integrator \"volpath\" \"integer maxdepth\" " +
           std::to_string(maxDepth) + "\nWorldBegin\n" + world + "WorldEnd\n";
}
std::string medium(const std::string& parameters) {
    return "MakeNamedMedium \"m\" \"string type\" \"homogeneous\" " + parameters + "\n";
}
std::string within(const std::string& shape, const std::string& material = "Material \"\"") {
    return "AttributeBegin\nMediumInterface \"m\" \"\"\n" + material + "\n" + shape + "\nAttributeEnd\n";
}
const std::string kBall = "Shape \"sphere\" \"float radius\" 1";
const std::string kWhiteSky = "LightSource \"infinite\" \"rgb L\" [1 1 1]\n";

// The means of pictures; the worst distance from what is expected, in standard errors, is below 4.5, or the difference
// below a share that rounding explains.
void expectMean(const std::string& text, const Rgb& expected, int spp, double most = 0.02) {
    for (const char* integrator : {"path", "drc"}) {
        const test::Estimate mean = test::estimateOfMeans(test::pictures(text, integrator, 16, spp));
        for (size_t c = 0; c < 3; ++c) {
            const double error = std::sqrt(mean.variance[c]), value = double(expected[int(c)]);
            EXPECT_LT(std::abs(mean.mean[c] - value), 4.5 * error + 2e-4 * value)
                << integrator << " " << c << ": " << mean.mean[c] << " in place of " << value;
            EXPECT_LT(error, most * value) << integrator << " " << c << ": too noisy to tell";
        }
    }
}

// Tinted glass, tea: what is behind it, seen through its whole length; and through two such balls.
TEST(Media, AbsorbAsBeerSays) {
    const std::string tea = medium("\"rgb sigma_a\" [0.1 0.4 1.5] \"rgb sigma_s\" [0 0 0]");
    expectMean(alongTheAxis("", kWhiteSky + tea + within(kBall)), Rgb(std::exp(-0.2f), std::exp(-0.8f), std::exp(-3.f)),
               1);
    expectMean(alongTheAxis("", kWhiteSky + tea + within(kBall) + "Translate 0 0 3\n" + within(kBall)),
               Rgb(std::exp(-0.4f), std::exp(-1.6f), std::exp(-6.f)), 1);
}

// A camera within the medium: its end is where the surface is, or where pbrt ends it, as far away as the scene is wide.
TEST(Media, SurroundTheCamera) {
    const std::string before =
        medium("\"rgb sigma_a\" [0.1 0.4 0.2] \"rgb sigma_s\" [0 0 0]") + "MediumInterface \"\" \"m\"";
    const std::string emitter =
        "AreaLightSource \"diffuse\" \"rgb L\" [1 2 3]\nTranslate 0 0 3\nReverseOrientation\n"
        "Shape \"disk\" \"float radius\" 2\n";
    expectMean(alongTheAxis(before, emitter), Rgb(std::exp(-0.8f), 2 * std::exp(-3.2f), 3 * std::exp(-1.6f)), 1);
    const std::string aside = "MediumInterface \"\" \"\"\nTranslate 3 0 0\nMaterial \"matte\"\n" + kBall + "\n";
    const float reach = 2 * std::sqrt(3.f);
    expectMean(alongTheAxis(before, kWhiteSky + aside),
               Rgb(std::exp(-0.1f * reach), std::exp(-0.4f * reach), std::exp(-0.2f * reach)), 1);
}

// Light that a medium emits and absorbs itself: Le sigma_a / sigma_t (1 - exp(-sigma_t d)).
TEST(Media, Emit) {
    std::string text =
        alongTheAxis("", medium("\"rgb sigma_a\" [1 0.5 0.1] \"rgb sigma_s\" [0 0 0] \"rgb Le\" [1 2 3]") +
                             within(kBall, "Material \"interface\""));
    text = test::inWordsOfV4(text);
    expectMean(text, Rgb(1 - std::exp(-2.f), 2 - 2 * std::exp(-1.f), 3 - 3 * std::exp(-0.2f)), 1);
    // Scattering deflects light, but what is scattered away comes from elsewhere: in a closed room whose walls are as
    // bright as the medium is where it is thick, all is equally bright.
    const std::string hot =
        alongTheAxis("", medium("\"rgb sigma_a\" [0.5 0.5 0.5] \"rgb sigma_s\" [1 1 1] \"rgb Le\" [2 2 2]") +
                             within(kBall, "Material \"interface\"") + "LightSource \"infinite\" \"rgb L\" [2 2 2]\n");
    expectMean(test::inWordsOfV4(hot), Rgb(2.f), 64);
}

// Light that is scattered once on the axis of a ball, from a light straight aside: by quadrature. The shadow rays leave
// the medium through its surface.
TEST(Media, ScatterOnceAsQuadratureSays) {
    const double sigmaA[3] = {0.1, 0.2, 0}, sigmaS[3] = {0.5, 1, 3};
    for (const double g : {0.0, 0.6, -0.4}) {
        const std::string fog =
            medium("\"rgb sigma_a\" [0.1 0.2 0] \"rgb sigma_s\" [0.5 1 3] \"float g\" " + std::to_string(g));
        struct Lamp {
            std::string text;
            double x;  // its distance from the axis; 0: far away
        };
        for (const Lamp& lamp :
             {Lamp{"LightSource \"distant\" \"rgb L\" [2 2 2] \"point from\" [1 0 0] \"point to\" [0 0 0]\n", 0},
              Lamp{"LightSource \"point\" \"rgb I\" [2 2 2] \"point from\" [3 0 0]\n", 3},
              Lamp{"LightSource \"point\" \"rgb I\" [2 2 2] \"point from\" [0.5 0 0]\n", 0.5}}) {
            Rgb expected;
            for (int c = 0; c < 3; ++c) {
                const double sigma = sigmaA[c] + sigmaS[c];
                double sum = 0;
                constexpr int kSteps = 20'000;
                for (int i = 0; i < kSteps; ++i) {
                    const double z = -1 + (i + 0.5) * 2 / kSteps;
                    const double distance = lamp.x > 0 ? std::hypot(lamp.x, z) : 1;
                    // Where the shadow ray leaves the ball.
                    const double dz = lamp.x > 0 ? -z / distance : 0;
                    const double out = -z * dz + std::sqrt(z * z * dz * dz + 1 - z * z);
                    const double inside = lamp.x > 0 ? std::min(distance, out) : out;
                    const double arriving = lamp.x > 0 ? 2 / (distance * distance) : 2;
                    // wo is -z.
                    const double phase = (1 - g * g) / (4 * kPiD * std::pow(1 + g * g - 2 * g * dz, 1.5));
                    sum += std::exp(-sigma * (z + 1 + inside)) * sigmaS[c] * phase * arriving * 2 / kSteps;
                }
                expected[c] = float(sum);
            }
            expectMean(alongTheAxis("", lamp.text + fog + within(kBall), 1), expected, 64);
        }
    }
}

// A medium that fills the scene and that no surface ends, with a lamp in it and a black wall behind: the same
// quadrature. The sun reaches through as much of it as in pbrt.
TEST(Media, ScatterOnceWithoutAnEnd) {
    const std::string before =
        medium("\"rgb sigma_a\" [0.02 0.02 0.02] \"rgb sigma_s\" [0.05 0.1 0.2]") + "MediumInterface \"\" \"m\"";
    const std::string wall =
        "Material \"matte\" \"rgb Kd\" [0 0 0]\nTranslate 0 0 4\nShape \"disk\" \"float radius\" 5\n";
    const auto expected = [](const auto& arriving) {
        Rgb result;
        for (int c = 0; c < 3; ++c) {
            const double sigmaS[3] = {0.05, 0.1, 0.2}, sigma = sigmaS[c] + 0.02;
            double sum = 0;
            constexpr int kSteps = 100'000;
            for (int i = 0; i < kSteps; ++i) {
                const double t = (i + 0.5) * 9 / kSteps;
                sum += std::exp(-sigma * t) * sigmaS[c] / (4 * kPiD) * arriving(t - 5, sigma) * 9 / kSteps;
            }
            result[c] = float(sum);
        }
        return result;
    };
    expectMean(alongTheAxis(before, "LightSource \"point\" \"rgb I\" [5 5 5] \"point from\" [2 0 0]\n" + wall, 1),
               expected([](double z, double sigma) {
                   const double distance = std::hypot(2, z);
                   return 5 / (distance * distance) * std::exp(-sigma * distance);
               }),
               256);
    expectMean(alongTheAxis(
                   before,
                   "LightSource \"distant\" \"rgb L\" [5 5 5] \"point from\" [1 0 0] \"point to\" [0 0 0]\n" + wall, 1),
               expected([](double, double sigma) { return 5 * std::exp(-sigma * std::sqrt(200.0)); }), 256);
}

// An area light, which both techniques of sampling find, in the middle of fog: from far away it is a point light.
TEST(Media, WeighPhaseFunctionAgainstLights) {
    const std::string fog = medium("\"rgb sigma_a\" [0.1 0.1 0.1] \"rgb sigma_s\" [0.4 0.4 0.4] \"float g\" 0.7");
    // L pi r^2 = I = 2
    const std::string lamp =
        "AttributeBegin\nTranslate 3 0 3\nMaterial \"matte\" \"rgb Kd\" [0 0 0]\n"
        "AreaLightSource \"diffuse\" \"rgb L\" [15.915494 15.915494 15.915494]\n"
        "Shape \"sphere\" \"float radius\" 0.2\nAttributeEnd\n";
    const auto bright = [&](const std::string& light) {
        return test::estimateOfMeans(test::pictures(alongTheAxis("", fog + within(kBall) + light, 1), "path", 16, 256));
    };
    const test::Estimate area = bright(lamp);
    const test::Estimate point = bright("LightSource \"point\" \"rgb I\" [2 2 2] \"point from\" [3 0 3]\n");
    const test::ZResult z = test::zTest(test::allowing(0.003, area, point), point);
    EXPECT_LT(z.worst, z.bound);
    EXPECT_LT(std::sqrt(area.variance[0]), 0.01 * point.mean[0]);
}

// Where nothing is absorbed, everything is as bright as the sky, whatever scatters how often in which direction.
TEST(Media, OfAlbedoOneAreNotSeenInAFurnace) {
    for (const char* g : {"0", "0.8", "-0.6"}) {
        const std::string milk =
            medium("\"rgb sigma_a\" [0 0 0] \"rgb sigma_s\" [0.3 2 6] \"float g\" " + std::string(g));
        expectMean(alongTheAxis("", kWhiteSky + milk + within(kBall), 1000), Rgb(1.f), 64);
    }
    // Below glass, around a white ball, and as instances.
    const std::string milk = medium("\"rgb sigma_a\" [0 0 0] \"rgb sigma_s\" [0.5 1 2]");
    const std::string white =
        "AttributeBegin\nMediumInterface \"m\"\nMaterial \"matte\" \"rgb Kd\" [1 1 1]\n"
        "Shape \"sphere\" \"float radius\" 0.5\nAttributeEnd\n";
    expectMean(alongTheAxis("", kWhiteSky + milk + within(kBall, "Material \"glass\""), 1000), Rgb(1.f), 128);
    expectMean(alongTheAxis("", kWhiteSky + milk + within(kBall) + white, 1000), Rgb(1.f), 128);
    const std::string object = "ObjectBegin \"o\"\n" + within(kBall) + white +
                               "ObjectEnd\nTranslate 0 0 1\nRotate 40 1 2 0\nScale -0.5 1 2\nObjectInstance \"o\"\n";
    expectMean(alongTheAxis("", kWhiteSky + milk + object, 1000), Rgb(1.f), 128);
}

// The brightness of an infinitely deep medium below a white sky: 1 - sqrt(1 - albedo) H(mu), where H solves
// Chandrasekhar's equation for isotropic scattering (Radiative Transfer, 1950, chapter V).
TEST(Media, ReflectAsChandrasekharSays) {
    const auto h = [](double albedo) {
        constexpr int kNodes = 400;
        std::vector<double> values(kNodes, 1);
        const auto next = [&](double mu) {
            double sum = 0;
            for (int i = 0; i < kNodes; ++i) {
                const double other = (i + 0.5) / kNodes;
                sum += other * values[size_t(i)] / (mu + other) / kNodes;
            }
            return 1 / (std::sqrt(1 - albedo) + albedo / 2 * sum);
        };
        for (int round = 0; round < 400; ++round) {
            std::vector<double> improved(kNodes);
            for (int i = 0; i < kNodes; ++i) improved[size_t(i)] = next((i + 0.5) / kNodes);
            values = improved;
        }
        return next(1);
    };
    const auto bright = [&](double albedo) { return float(1 - std::sqrt(1 - albedo) * h(albedo)); };
    // Looked at straight from above.
    const std::string deep = medium("\"rgb sigma_a\" [0.5 0.2 0.05] \"rgb sigma_s\" [0.5 0.8 0.95]");
    const std::string slab = "AttributeBegin\nTranslate 0 0 500\nScale 1000 1000 500\n" +
                             within(
                                 "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3 4 6 5 4 7 6 0 4 5 0 5 1 "
                                 "1 5 6 1 6 2 2 6 7 2 7 3 3 7 4 3 4 0] \"point P\" [-1 -1 -1  -1 1 -1  1 1 -1  "
                                 "1 -1 -1  -1 -1 1  -1 1 1  1 1 1  1 -1 1]") +
                             "AttributeEnd\n";
    expectMean(alongTheAxis("", kWhiteSky + deep + slab, 1000), Rgb(bright(0.5), bright(0.8), bright(0.95)), 256);
}

// A ball of coloured glass on its axis: both faces reflect R, and each passage absorbs a. Everything that comes out
// sees the same sky: R + (1 - R)^2 a / (1 - R a).
TEST(Media, ColourGlass) {
    const std::string tint = medium("\"rgb sigma_a\" [0.1 0.4 1] \"rgb sigma_s\" [0 0 0]");
    const auto seen = [](double sigma) {
        const double r = 0.04, a = std::exp(-2 * sigma);
        return float(r + (1 - r) * (1 - r) * a / (1 - r * a));
    };
    expectMean(alongTheAxis("", kWhiteSky + tint + within(kBall, "Material \"glass\" \"float eta\" 1.5")),
               Rgb(seen(0.1), seen(0.4), seen(1)), 256);
}

// A room full of fog, with a lamp, a mirror, a ball of coloured glass and a box of smoke: the radiance cells give what
// the path tracer gives. They do answer.
TEST(Media, OfARoomAreTheSameByFinalGather) {
    std::string text = test::room("Material \"plastic\" \"rgb Kd\" [0.2 0.4 0.5]", 64, 48);
    text = respelt(text, "LookAt",
                   "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [0.01 0.01 0.01] \"rgb "
                   "sigma_s\" [0.06 0.08 0.1] \"float g\" 0.4\nMakeNamedMedium \"smoke\" \"string type\" "
                   "\"homogeneous\" \"rgb sigma_a\" [0.2 0.3 0.4] \"rgb sigma_s\" [1 1 1]\nMediumInterface \"\" "
                   "\"fog\"\nLookAt");
    text = respelt(text, "WorldEnd",
                   "AttributeBegin\nMediumInterface \"smoke\" \"fog\"\nMaterial \"\"\nTranslate -0.8 0 0.6\n"
                   "Shape \"sphere\" \"float radius\" 0.5\nAttributeEnd\nWorldEnd");
    text = respelt(text, "Integrator \"path\"\n", "Integrator \"volpath\" \"integer maxdepth\" 8\n");
    const auto scene = pbrt::loadPbrtString(text);
    const test::Gathered g = test::gather(*scene, {.cellSize = 0.1f});
    test::record(g);
    EXPECT_GT(g.answered, 0.5);
    EXPECT_LT(g.worstError(), 0.03) << "too noisy to tell";
    EXPECT_LT(g.meanError(), 0.005);
    for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(g.means.mean[c] / g.pathMeans.mean[c], 1, 0.01);
    const test::ZResult z = g.differencesBeyond(0.02);
    EXPECT_LT(z.worst, z.bound);
}

// What is recorded for the denoiser hardly depends on where paths are scattered.
TEST(Media, LeaveTheGBufferAlmostWithoutNoise) {
    const std::string before =
        medium("\"rgb sigma_a\" [0.1 0.1 0.1] \"rgb sigma_s\" [0.1 0.2 0.3]") + "MediumInterface \"\" \"m\"";
    const std::string wall =
        "Material \"matte\" \"rgb Kd\" [0.5 0.6 0.7]\nTranslate 0 0 -3\nShape \"disk\" \"float radius\" 5\n";
    const auto scene = pbrt::loadPbrtString(alongTheAxis(before, kWhiteSky + wall));
    for (const char* integrator : {"path", "drc"}) {
        RenderParams params;
        params.integrator = integrator;
        params.spp = 4;
        params.gBuffer = true;
        Session session(*scene, params);
        while (session.step()) {
        }
        const LayeredPicture picture = session.picture();
        ASSERT_TRUE(picture.gBuffer);
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x)
                for (int c = 0; c < 3; ++c) {
                    const double sigmaS = 0.1 * (c + 1), sigma = 0.1 + sigmaS, through = std::exp(-2 * sigma);
                    const double expected = (0.5 + 0.1 * c) * through + sigmaS / sigma * (1 - through);
                    EXPECT_NEAR(picture.gBuffer->albedo.rgb(x, y)[c], expected, 1e-3) << integrator;
                    EXPECT_NEAR(std::abs(picture.gBuffer->normal.rgb(x, y)[2]), 1, 1e-3) << integrator;
                }
    }
}

// Integrators that do not render media say so, and render the scene without.
TEST(Media, AreLeftOutWithAWarningByOthers) {
    const std::string tea = medium("\"rgb sigma_a\" [1 1 1] \"rgb sigma_s\" [1 1 1]");
    for (const char* integrator : {"bdpt", "direct", "drc-maps"}) {
        forgetWarnings();
        const auto seen = test::pictures(alongTheAxis("", kWhiteSky + tea + within(kBall)), integrator, 1, 1);
        EXPECT_EQ(warningCount(), 1) << integrator;
        for (const Rgb& value : seen[0]) EXPECT_LT(length(value - Rgb(1.f)), 1e-4f) << integrator;
    }
}

}  // namespace
}  // namespace drc
