// Invariant 7 of docs/README.md, through the whole pipeline: without cells, final gather is the path tracer; with
// cells, its pictures have the path tracer's block means, up to half a per cent.
#include <gtest/gtest.h>

#include "camera_cases.h"
#include "gathered_pictures.h"
#include "light_cases.h"
#include "room_of_one_material.h"
#include "test_scenes.h"

namespace drc {
namespace {

constexpr int kWidth = 32, kHeight = 16;
constexpr double kAllowed = 0.005;

void expectSameAsPaths(Scene& scene, const test::Comparison& comparison = {}) {
    const test::Gathered result = test::gather(scene, comparison);
    const test::ZResult blocks = result.differencesBeyond(kAllowed);
    const test::ZResult means = test::zTest(test::allowing(kAllowed, result.means, result.pathMeans), result.pathMeans);
    test::record(result);
    EXPECT_LT(blocks.worst, blocks.bound) << "a block is off by " << result.worstDifference();
    EXPECT_LT(means.worst, means.bound) << "the mean is off by " << result.meanDifference();
    EXPECT_LT(result.meanError(), 0.02) << "too noisy to tell";
    EXPECT_GT(result.answered, 0.05) << "the cells are hardly asked";
}

void expectSameAsPaths(const std::string& text, const test::Comparison& comparison = {}) {
    expectSameAsPaths(*pbrt::loadPbrtString(text), comparison);
}

// The room with a material, in the words of either dialect.
std::string roomWith(size_t material) {
    const auto v3 = test::allMaterials(), v4 = test::materialsOfV4();
    if (material < v3.size()) return test::room(v3[material].second, kWidth, kHeight);
    return test::inWordsOfV4(test::room(v4[material - v3.size()].second, kWidth, kHeight));
}
std::string materialName(size_t material) {
    const auto v3 = test::allMaterials(), v4 = test::materialsOfV4();
    return material < v3.size() ? v3[material].first : v4[material - v3.size()].first;
}

// To the bit. With cells that never answer, too, the path tracer's numbers come out, where a hit has one light sample
// and one ray (FinalGather.WithoutAnswersItIsThePathTracer); with more of them, its means
// (SplitItHasThePathTracersMeans).
void expectThePathTracersPicture(const std::string& text) {
    const auto scene = pbrt::loadPbrtString(text);
    const auto picture = [&](const char* integrator) {
        const auto change = [](RenderParams& params) { params.cells = false; };
        return test::pictures(*scene, {.integrator = integrator, .spp = 8, .block = 1, .change = change})[0];
    };
    EXPECT_EQ(picture("drc"), picture("path"));
}

class FinalGatherOfMaterials : public testing::TestWithParam<size_t> {};
INSTANTIATE_TEST_SUITE_P(Invariant7, FinalGatherOfMaterials,
                         testing::Range<size_t>(0, test::allMaterials().size() + test::materialsOfV4().size()),
                         [](const auto& i) { return materialName(i.param); });

TEST_P(FinalGatherOfMaterials, IsThePathTracerWithoutCells) { expectThePathTracersPicture(roomWith(GetParam())); }

TEST_P(FinalGatherOfMaterials, HasThePathTracersMeans) { expectSameAsPaths(roomWith(GetParam())); }

// Where all walls have the material, blocks beside corners, the window and the lamp are within 2 %, the mean within .5
// %, at any size of cells.
class FinalGatherInRoomsOf : public testing::TestWithParam<test::RoomMaterial> {};
INSTANTIATE_TEST_SUITE_P(Invariant7, FinalGatherInRoomsOf, testing::ValuesIn(test::roomMaterials()),
                         [](const auto& i) { return i.param.name; });

TEST_P(FinalGatherInRoomsOf, HasThePathTracersMeans) {
    constexpr double kAllowedBesideWalls = 0.02;
    const auto scene = pbrt::loadPbrtString(GetParam().room(64, 48));
    test::Comparison comparison{.gatherSpp = 12, .pathSpp = 12};
    const test::PathPictures paths = test::pathPictures(*scene, comparison);
    for (const float cellSize : {0.03f, 0.12f}) {
        SCOPED_TRACE(cellSize);
        comparison.cellSize = cellSize;
        const test::Gathered result = test::gather(*scene, comparison, paths);
        test::record(result);
        const test::ZResult blocks = result.differencesBeyond(kAllowedBesideWalls);
        const test::ZResult means =
            test::zTest(test::allowing(kAllowed, result.means, result.pathMeans), result.pathMeans);
        EXPECT_LT(blocks.worst, blocks.bound) << "a block is off by " << result.worstDifference();
        EXPECT_LT(means.worst, means.bound) << "the mean is off by " << result.meanDifference();
        EXPECT_LT(result.worstError(), kAllowedBesideWalls) << "too noisy to tell";
        if (GetParam().isSeparable) {
            EXPECT_GT(result.answered, 0.04) << "the cells are hardly asked";
        }
    }
}

class FinalGatherOfLights : public testing::TestWithParam<test::LightCase> {
  protected:
    std::string text() const { return test::cornerWith(GetParam(), folder_, kWidth, kHeight); }

  private:
    const TemporaryFolder folder_;
};
INSTANTIATE_TEST_SUITE_P(Invariant7, FinalGatherOfLights, testing::ValuesIn(test::kLightCases),
                         [](const auto& i) { return i.param.name; });

TEST_P(FinalGatherOfLights, IsThePathTracerWithoutCells) { expectThePathTracersPicture(text()); }

TEST_P(FinalGatherOfLights, HasThePathTracersMeans) { expectSameAsPaths(text(), {.gatherSpp = 64}); }

class FinalGatherOfCameras : public testing::TestWithParam<test::CameraCase> {};
INSTANTIATE_TEST_SUITE_P(Invariant7, FinalGatherOfCameras, testing::ValuesIn(test::kCameraCases),
                         [](const auto& i) { return i.param.name; });

TEST_P(FinalGatherOfCameras, HasThePathTracersMeans) {
    expectSameAsPaths(test::roomSeenBy(GetParam(), R"(Material "matte" "rgb Kd" [0.5 0.6 0.3])", kWidth, kHeight),
                      {.gatherSpp = 96});
}

TEST(FinalGather, HasThePathTracersMeansAmongLampsOfEveryShape) {
    expectSameAsPaths(test::room("AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [3 2 1]\n" +
                                     test::everyShape() + "AttributeEnd\nMaterial \"matte\" \"rgb Kd\" [0.7 0.4 0.3]",
                                 kWidth, kHeight));
}

// What the view factor of a lobe is, is no matter, as long as it is the same for deposits and look-ups.
TEST(FinalGather, HasThePathTracersMeansBesideSurfacesBrighterThanWhite) {
    expectSameAsPaths(test::room("Material \"matte\" \"rgb Kd\" [1.6 1.3 2]", kWidth, kHeight),
                      {.gatherSpp = 96, .pathSpp = 96});
}

// A screen with holes, before the lamp and before the camera, over a floor with bumps.
TEST(FinalGather, HasThePathTracersMeansThroughHolesAndOnBumps) {
    const std::string holes =
        "Texture \"holes\" \"float\" \"checkerboard\" \"float uscale\" 6 \"float vscale\" 6 \"float tex1\" 0 \"float "
        "tex2\" 1\n";
    const std::string screen =
        test::respelt(test::quad("-1.5 -0.6 0.4", "1.5 -0.6 0.4", "1.5 -0.6 2.6", "-1.5 -0.6 2.6"), "\"point P\"",
                      "\"texture alpha\" \"holes\" \"float uv\" [0 0 1 0 1 1 0 1] \"point P\"");
    const std::string bumps =
        "Texture \"bumps\" \"float\" \"wrinkled\"\nTexture \"low\" \"float\" \"scale\" \"texture tex1\" \"bumps\" "
        "\"float "
        "tex2\" 0.1\nMaterial \"matte\" \"rgb Kd\" [0.6 0.5 0.4] \"texture bumpmap\" \"low\"\n";
    expectSameAsPaths(
        test::room(holes + "Material \"matte\" \"rgb Kd\" [0.5 0.5 0.5]\n" + screen + bumps, kWidth, kHeight));
}

// Hair: thin curves, between which most paths go short distances.
TEST(FinalGather, HasThePathTracersMeansInHair) {
    std::string hair = "Material \"hair\" \"float eumelanin\" 0.4 \"float beta_n\" 0.3\n";
    for (int i = 0; i < 60; ++i) {
        const auto at = [&](double x, double y, double z) {
            return std::to_string(x + 0.04 * i - 1.2) + " " + std::to_string(y + 0.02 * (i % 7)) + " " +
                   std::to_string(z) + " ";
        };
        hair += "Shape \"curve\" \"float width0\" 0.03 \"float width1\" 0.01 \"point P\" [" + at(0, 0, 0.1) +
                at(0.1, -0.1, 0.6) + at(-0.1, 0.1, 1.2) + at(0.2, 0, 1.7) + "]\n";
    }
    expectSameAsPaths(test::room(hair + "Material \"matte\" \"rgb Kd\" [0.6 0.6 0.6]", kWidth, kHeight));
}

// The scenes that DRC comes with.
class FinalGatherOfScenes : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Invariant7, FinalGatherOfScenes,
                         testing::Values("cornell", "quickstart", "bathroom", "coloured-cubes", "glossy-sphere"),
                         [](const auto& i) { return test::respelt(i.param, "-", "_"); });

TEST_P(FinalGatherOfScenes, HasThePathTracersMeans) {
    pbrt::LoadOptions options;
    options.overrides = {"film.xresolution=48", "film.yresolution=48"};
    const auto scene = pbrt::loadPbrtFile(std::string(DRC_SOURCE_DIR "/scenes/") + GetParam() + "/scene.pbrt", options);
    // Its frosted panes light the bathroom by paths that only chance finds.
    const int spp = std::string(GetParam()) == "bathroom" ? 112 : 48;
    expectSameAsPaths(*scene, {.gatherSpp = spp, .pathSpp = spp});
}

}  // namespace
}  // namespace drc
