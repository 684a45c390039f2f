// Invariants 2 and 3 for what invariants_test.cpp does not cover: the materials of pbrt-v4, materials that are tables,
// and lights of every type.
#include <gtest/gtest.h>

#include "light_cases.h"
#include "pipeline.h"
#include "tabulated_materials.h"
#include "test_scenes.h"

namespace drc {
namespace {

using test::Estimate;
using test::Pipeline;

constexpr int kWidth = 6, kHeight = 6, kBlock = 3, kSamples = 4096, kGroup = 64, kPasses = 3;

// Means over blocks of pixels, which are independent. With few samples of rare bright paths, single pixels are far from
// normally distributed, but block means nearly are.
Estimate blocks(const Estimate& pixels) {
    constexpr size_t kBlocks = kWidth / kBlock * (kHeight / kBlock), kPerBlock = kBlock * kBlock;
    Estimate e{std::vector<double>(kBlocks * 3), std::vector<double>(kBlocks * 3), std::vector<double>(kBlocks * 3)};
    for (size_t y = 0; y < kHeight; ++y)
        for (size_t x = 0; x < kWidth; ++x)
            for (size_t c = 0; c < 3; ++c) {
                const size_t pixel = (y * kWidth + x) * 3 + c;
                const size_t block = (y / kBlock * (kWidth / kBlock) + x / kBlock) * 3 + c;
                const double variance = pixels.variance[pixel] / (kPerBlock * kPerBlock);
                e.mean[block] += pixels.mean[pixel] / kPerBlock;
                e.variance[block] += variance;
                e.freedom[block] += variance * variance / pixels.freedom[pixel];
            }
    for (size_t i = 0; i < e.freedom.size(); ++i)
        e.freedom[i] = e.freedom[i] > 0 ? e.variance[i] * e.variance[i] / e.freedom[i] : 1e9;
    return e;
}

// slack: tolerated difference, as a share of b.
void expectSameBlocks(const Estimate& a, const Estimate& b, const std::string& what, double slack = 0) {
    const test::ZResult z = test::zTest(test::allowing(slack, a, b), b);
    EXPECT_EQ(z.tests, int(a.mean.size())) << what;
    EXPECT_LT(z.worst, z.bound) << what;
    EXPECT_LT(z.meanDifference, 4) << what;
    EXPECT_LT(z.meanSquare, 3) << what;
}

// Direct light plus indirect light, either path-traced in one of two ways or from a map at each pixel, must be the
// path-traced result.
void checkSplit(const Pipeline& pipeline) {
    const auto of = [&](Rgb (Pipeline::*way)(int, int) const) {
        return blocks(pipeline.estimate(way, kSamples, kGroup));
    };
    const Estimate path = of(&Pipeline::path), direct = of(&Pipeline::direct);
    expectSameBlocks(direct + of(&Pipeline::tracedIndirect), path, "direct and traced");
    expectSameBlocks(direct + of(&Pipeline::indirectAlong), path, "direct and along with it");
    // The texels of a map blur a lamp seen through a thin sheet. With twice as many along a side, that error vanishes.
    IndirectSettings settings;
    settings.gatherSamples = 32;
    settings.primarySamples = 1;
    const Estimate maps = blocks(pipeline.cachedIndirect(settings, 1, kPasses));
    expectSameBlocks(direct + of(&Pipeline::glossyIndirect) + maps, path, "direct and maps at every pixel", 0.005);
}

class MaterialsOfV4 : public testing::TestWithParam<size_t> {};
INSTANTIATE_TEST_SUITE_P(Split, MaterialsOfV4, testing::Range<size_t>(0, test::materialsOfV4().size()),
                         [](const auto& i) { return test::materialsOfV4()[i.param].first; });

// Close enough for the material to fill the picture.
std::string near(const std::string& room) { return test::respelt(room, "\"float fov\" 70", "\"float fov\" 30"); }

TEST_P(MaterialsOfV4, IsExact) {
    const std::string material = test::materialsOfV4()[GetParam()].second;
    checkSplit(Pipeline(test::inWordsOfV4(near(test::room(material, kWidth, kHeight)))));
}

class TablesOfMaterials : public testing::TestWithParam<test::TabulatedMaterial> {};
INSTANTIATE_TEST_SUITE_P(Split, TablesOfMaterials, testing::ValuesIn(test::kTabulatedMaterials),
                         [](const auto& i) { return i.param.name; });

TEST_P(TablesOfMaterials, IsExact) {
    const TemporaryFolder folder;
    checkSplit(Pipeline(near(test::roomWith(GetParam(), GetParam().write(folder), kWidth, kHeight))));
}

class LightsOfEveryType : public testing::TestWithParam<test::LightCase> {};
INSTANTIATE_TEST_SUITE_P(Split, LightsOfEveryType, testing::ValuesIn(test::kLightCases),
                         [](const auto& i) { return i.param.name; });

TEST_P(LightsOfEveryType, IsExact) {
    const TemporaryFolder folder;
    checkSplit(Pipeline(test::cornerWith(GetParam(), folder, kWidth, kHeight)));
}

}  // namespace
}  // namespace drc
