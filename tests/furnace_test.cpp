// Furnaces with a known solution, rendered with every integrator and filter.
#include <gtest/gtest.h>

#include "base/folder_testing.h"
#include "image/image_io.h"
#include "pictures.h"
#include "test_scenes.h"

namespace drc {
namespace {

using test::constantEstimate;
using test::Estimate;
using test::pictures;

constexpr int kWidth = 12, kHeight = 8;

// A closed box whose walls emit 0.5 and reflect 0.5, and a shape of `material` in front of the camera that, if `emits`,
// emits the same.
std::string inFurnace(const std::string& shape, const std::string& material, bool emits, bool v4) {
    std::string text = test::furnace(0.5f, kWidth, kHeight);
    text = test::respelt(text, "\"float fov\" 80", "\"float fov\" 26");
    text = test::respelt(
        text, "Shape \"sphere\" \"float radius\" 0.8\n",
        "AttributeEnd\nAttributeBegin\n" + material + "\n" +
            (emits ? "AreaLightSource \"diffuse\" \"rgb L\" [0.5 0.5 0.5] \"bool twosided\" \"true\"\n" : "") + shape);
    text = test::respelt(text, "WorldBegin\n", "WorldBegin\nAttributeBegin\n");
    text = test::respelt(text, "WorldEnd", "AttributeEnd\nWorldEnd");
    return v4 ? test::inWordsOfV4(text) : text;
}
std::string ballInFurnace(const std::string& material, bool emits, bool v4) {
    return inFurnace("Shape \"sphere\" \"float radius\" 0.8\n", material, emits, v4);
}

// slack: allowed error of radiance caches whose values vary with position.
void expectConstant(const std::vector<std::vector<Rgb>>& seen, double value, double slack = 0) {
    const Estimate blocks = test::estimateOf(seen), mean = test::estimateOfMeans(seen);
    for (size_t c = 0; c < 3; ++c) {
        const double sigma = std::sqrt(mean.variance[c]);
        EXPECT_NEAR(mean.mean[c], value, 4.5 * sigma + 1e-4 + slack);
        EXPECT_LT(sigma, 0.007) << "too noisy to tell";
    }
    if (slack > 0) return;
    const test::ZResult z = test::zTest(blocks, constantEstimate(blocks.mean.size(), value));
    EXPECT_LT(z.worst, z.bound);
}

// Pictures by final gather, with cells so large that they know enough soon after so small a picture has begun. Fails if
// they hardly answer any look-ups.
std::vector<std::vector<Rgb>> gathered(Scene& scene, int count, int spp) {
    Stats stats;
    auto result = pictures(scene, {.integrator = "drc",
                                   .count = count,
                                   .spp = spp,
                                   .change = [](RenderParams& params) { params.cellSize = 0.1f; },
                                   .stats = &stats});
    const int64_t unknown = stats.count("cells/look-ups/refused: too little is known");
    // Paths of a single bounce end before they could ask.
    if (scene.sensor.settings.maxDepth > 1) {
        EXPECT_GT(stats.count("cells/look-ups/answered"), unknown / 10);
    }
    return result;
}
std::vector<std::vector<Rgb>> gathered(const std::string& text, int count, int spp) {
    return gathered(*pbrt::loadPbrtString(text), count, spp);
}

constexpr const char* kDeep = "Integrator \"path\" \"integer maxdepth\" 64\n";

// A ball whose albedo is the same from every direction: either 0.5, and it emits 0.5, or 1.
struct Ball {
    const char* name;
    bool v4;
    const char* material;
    bool emits;
    double direct;  // Le seen through its specular lobes, plus one bounce off its other lobes; for emissive balls
};
void PrintTo(const Ball& ball, std::ostream* out) { *out << ball.name; }
const Ball kBalls[] = {
    {"Matte", false, R"(Material "matte" "rgb Kd" [0.5 0.5 0.5])", true, 0.75},
    {"Mirror", false, R"(Material "mirror" "rgb Kr" [0.5 0.5 0.5])", true, 0.5 + 0.5 * 0.75},
    {"Translucent", false,
     R"(Material "translucent" "rgb Kd" [0.5 0.5 0.5] "rgb Ks" [0 0 0] "rgb reflect" [0.6 0.6 0.6]
        "rgb transmit" [0.4 0.4 0.4])",
     true, 0.75},
    // 0.3 is reflected; 0.2 goes straight through this side, and then through the other.
    {"UberInPart", false,
     R"(Material "uber" "rgb Kd" [0.375 0.375 0.375] "rgb Ks" [0 0 0] "rgb opacity" [0.8 0.8 0.8])", true,
     0.65 + 0.2 * (0.65 + 0.2 * 0.75)},
    {"Mix", false,
     R"(MakeNamedMaterial "a" "string type" "mirror" "rgb Kr" [0.4 0.4 0.4]
        MakeNamedMaterial "b" "string type" "matte" "rgb Kd" [0.6 0.6 0.6]
        Material "mix" "string namedmaterial1" "a" "string namedmaterial2" "b" "rgb amount" [0.5 0.5 0.5])",
     true, 0.5 + 0.3 * 0.5 + 0.2 * 0.75},
    {"Diffuse", true, R"(Material "diffuse" "rgb reflectance" [0.5 0.5 0.5])", true, 0.75},
    {"DiffuseTransmission", true,
     R"(Material "diffusetransmission" "rgb reflectance" [0.1 0.1 0.1] "rgb transmittance" [0.4 0.4 0.4])", true, 0.75},
    {"WhiteMatte", false, R"(Material "matte" "rgb Kd" [1 1 1])", false, 0},
    {"Glass", false, R"(Material "glass")", false, 0},
    {"ClearHair", false, R"(Material "hair" "rgb sigma_a" [0 0 0])", false, 0},
    {"WhiteCoated", true,
     R"(Material "coateddiffuse" "rgb reflectance" [1 1 1] "float roughness" 0 "float thickness" 0)", false, 0},
    {"WhiteConductor", true, R"(Material "conductor" "rgb reflectance" [1 1 1])", false, 0},
    {"Dielectric", true, R"(Material "dielectric" "float eta" 1.4)", false, 0},
    {"ThinDielectric", true, R"(Material "thindielectric")", false, 0},
    {"WhiteTransmission", true,
     R"(Material "diffusetransmission" "rgb reflectance" [0.3 0.3 0.3] "rgb transmittance" [0.7 0.7 0.7])", false, 0},
};

const auto kEmissive = std::count_if(std::begin(kBalls), std::end(kBalls), [](const Ball& b) { return b.emits; });

class BallInFurnace : public testing::TestWithParam<Ball> {
  protected:
    std::string text() const { return kDeep + ballInFurnace(GetParam().material, GetParam().emits, GetParam().v4); }
};
INSTANTIATE_TEST_SUITE_P(Furnaces, BallInFurnace, testing::ValuesIn(kBalls),
                         [](const auto& i) { return i.param.name; });

TEST_P(BallInFurnace, IsNotSeenByPaths) { expectConstant(pictures(text(), "path", 16, 16), 1); }

TEST_P(BallInFurnace, IsNotSeenByBidirectionalPaths) { expectConstant(pictures(text(), "bdpt", 16, 16), 1); }

TEST_P(BallInFurnace, IsNotSeenByRadianceMaps) {
    expectConstant(pictures(text(), "drc-maps", 8, 16), 1, GetParam().emits ? 0 : 0.01);
}

// Cells hold the light that is reflected, divided by the albedo: 1 in the mean on every surface that emits what it does
// not reflect.
TEST_P(BallInFurnace, IsNotSeenByFinalGather) { expectConstant(gathered(text(), 16, 64), 1); }

// For balls that do not emit, direct light is not uniform, so they are left out here.
class EmissiveBallInFurnace : public BallInFurnace {};
INSTANTIATE_TEST_SUITE_P(Furnaces, EmissiveBallInFurnace, testing::ValuesIn(kBalls, kBalls + kEmissive),
                         [](const auto& i) { return i.param.name; });

TEST_P(EmissiveBallInFurnace, HasTheDirectLightThatFollows) {
    expectConstant(pictures(text(), "direct", 16, 16), GetParam().direct);
}

// Curves of all types, which absorb nothing. Light paths are of no use on those that turn towards each ray.
class CurvesInFurnace : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Furnaces, CurvesInFurnace, testing::Values("flat", "ribbon", "cylinder", "tube"),
                         [](const auto& i) { return i.param; });

TEST_P(CurvesInFurnace, AreNotSeen) {
    for (const char* material : {R"(Material "matte" "rgb Kd" [1 1 1])", R"(Material "hair" "rgb sigma_a" [0 0 0])"}) {
        SCOPED_TRACE(material);
        const std::string text = kDeep + inFurnace(test::bentCurves(GetParam(), 0.25f), material, false, false);
        expectConstant(pictures(text, "path", 16, 16), 1);
        expectConstant(pictures(text, "bdpt", 16, 16), 1);
        expectConstant(gathered(text, 16, 64), 1);
    }
    const std::string lit = kDeep + inFurnace(test::bentCurves(GetParam(), 0.25f),
                                              R"(Material "matte" "rgb Kd" [0.5 0.5 0.5])", true, false);
    expectConstant(pictures(lit, "path", 16, 16), 1);
    expectConstant(pictures(lit, "bdpt", 16, 16), 1);
}

TEST_P(CurvesInFurnace, AreNotSeenUnderAUniformSky) {
    for (const char* material : {R"(Material "matte" "rgb Kd" [1 1 1])", R"(Material "hair" "rgb sigma_a" [0 0 0])"}) {
        SCOPED_TRACE(material);
        const std::string text = kDeep + ("LookAt 0 -3 0  0 0 0  0 0 1\nCamera \"perspective\" \"float fov\" 30\n"
                                          "Film \"image\" \"integer xresolution\" 12 \"integer yresolution\" 8\n"
                                          "WorldBegin\nLightSource \"infinite\" \"rgb L\" [1 1 1]\n" +
                                          (material + ("\n" + test::bentCurves(GetParam(), 0.25f))) + "WorldEnd\n");
        expectConstant(pictures(text, "path", 16, 16), 1);
        expectConstant(pictures(text, "bdpt", 16, 16), 1);
    }
}

// Shading normals lose the light that they send below the surface, but add none. Where the view is below their horizon
// they are bent, so that little is lost: half of the glossy lobe at most, which is then about the surface's own
// horizon.
TEST(LeaningNormalsInFurnace, LoseLittle) {
    const std::pair<const char*, float> cases[] = {
        {R"(Material "matte" "rgb Kd" [1 1 1])", 0.94f},
        {R"(Material "mirror" "rgb Kr" [1 1 1])", 0.99f},
        {R"(Material "metal" "rgb eta" [0.01 0.01 0.01] "rgb k" [100 100 100] "float roughness" 0.05)", 0.5f}};
    for (const auto& [material, least] : cases) {
        SCOPED_TRACE(material);
        const std::string text =
            kDeep + inFurnace("Translate 0 0 -0.15\n" + test::leaningFloor(), material, false, false);
        for (const char* integrator : {"path", "bdpt", "drc", "drc-maps"}) {
            SCOPED_TRACE(integrator);
            const auto seen = pictures(text, integrator, 1, 256);
            for (const Rgb& block : seen[0]) {
                EXPECT_GT(block.x, least);
                EXPECT_LT(block.x, 1.02);
            }
        }
    }
}

// Walls and a ball that reflect one picture, and emit another, its complement.
TEST(FurnaceOfPictures, IsConstant) {
    const TemporaryFolder folder;
    Image reflected(8, 8), emitted(8, 8);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            const Rgb albedo(0.2f + 0.08f * float(x), 0.8f - 0.07f * float(y), 0.1f + 0.05f * float(x + y));
            reflected.setRgb(x, y, albedo);
            emitted.setRgb(x, y, Rgb(1.f) - albedo);
        }
    writeExr(folder.path("reflected.exr"), reflected);
    writeExr(folder.path("emitted.exr"), emitted);
    const std::string material = "Texture \"picture\" \"spectrum\" \"imagemap\" \"string filename\" \"" +
                                 folder.path("reflected.exr") +
                                 "\" \"string wrap\" \"clamp\"\n"
                                 "Material \"diffuse\" \"texture reflectance\" \"picture\"\n"
                                 "AreaLightSource \"diffuse\" \"bool twosided\" true \"string filename\" \"" +
                                 folder.path("emitted.exr") + "\"\n";
    std::string text = test::inWordsOfV4(test::furnace(0.5f, kWidth, kHeight));
    const size_t from = text.find("Material"), to = text.find("Shape");
    text = kDeep + text.substr(0, from) + material + text.substr(to);
    // Coordinates for the walls, each of which shows the whole picture.
    text = test::respelt(text, "\"point3 P\"", "\"point2 uv\" [0 0 1 0 1 1 0 1] \"point3 P\"");
    expectConstant(pictures(text, "path", 16, 16), 1);
    expectConstant(pictures(text, "bdpt", 16, 16), 1);
    expectConstant(pictures(text, "drc-maps", 8, 16), 1);
    expectConstant(gathered(text, 16, 64), 1);
}

// After n bounces with an albedo of 0.5, radiance is 1 - 0.5^(n + 1). Direct lighting is the result for one bounce,
// whatever depth the file asks for.
class DepthOfFurnace : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Furnaces, DepthOfFurnace, testing::Values(1, 2, 3, 5));

TEST_P(DepthOfFurnace, IsTheSeriesCutShort) {
    const int depth = GetParam();
    const std::string text = "Integrator \"path\" \"integer maxdepth\" " + std::to_string(depth) + "\n" +
                             test::furnace(0.5f, kWidth, kHeight);
    const double expected = 1 - std::pow(0.5, depth + 1);
    // Enough pictures to estimate the standard deviation that the bound is based on.
    expectConstant(pictures(text, "path", 64, 16), expected);
    expectConstant(pictures(text, "bdpt", 64, 16), expected);
    expectConstant(gathered(text, 24, 64), expected);
    expectConstant(pictures(text, "drc-maps", 32, 16), expected);
    expectConstant(pictures(text, "direct", 64, 16), 0.75);
}

// Filters with negative lobes have weights of both signs.
class FilterOfFurnace : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Furnaces, FilterOfFurnace, testing::Values("box", "triangle", "gaussian", "mitchell", "sinc"),
                         [](const auto& i) { return i.param; });

TEST_P(FilterOfFurnace, ChangesNothing) {
    const std::string text =
        kDeep + ("PixelFilter \"" + std::string(GetParam()) + "\"\n") + test::furnace(0.5f, kWidth, kHeight);
    expectConstant(pictures(text, "path", 16, 64), 1);
    expectConstant(pictures(text, "bdpt", 16, 64), 1);
    expectConstant(gathered(text, 12, 64), 1);
}

// Where all radiance is 1, every pixel is, however few samples it has.
TEST_P(FilterOfFurnace, MakesNoPixelDark) {
    const std::string text = "LookAt 0 0 0  0 1 0  0 0 1\nCamera \"perspective\"\nPixelFilter \"" +
                             std::string(GetParam()) +
                             "\"\nFilm \"image\" \"integer xresolution\" 32 \"integer yresolution\" 32\n"
                             "WorldBegin\nLightSource \"infinite\" \"rgb L\" [1 1 1]\nWorldEnd\n";
    const auto scene = pbrt::loadPbrtString(text);
    for (const char* integrator : {"path", "direct", "bdpt", "drc", "drc-maps"})
        for (const int spp : {1, 2, 3, 4, 5, 7, 8, 13, 16, 32, 61}) {
            const auto seen = pictures(*scene, {.integrator = integrator, .count = 1, .spp = spp, .block = 1});
            for (const Rgb& pixel : seen[0]) ASSERT_LT(length(pixel - Rgb(1.f)), 1e-5f) << integrator << " " << spp;
        }
}

// The furnace among the scenes that DRC comes with: surfaces that absorb nothing under a uniform sky.
TEST(FurnaceOfFinalGather, IsExactUnderAUniformSky) {
    const auto scene = pbrt::loadPbrtFile(DRC_SOURCE_DIR "/scenes/furnace/scene.pbrt",
                                          {.overrides = {"film.xresolution=24", "film.yresolution=16"}});
    expectConstant(gathered(*scene, 12, 128), 1);
}

}  // namespace
}  // namespace drc
