// Invariants 2 and 3 with what the scenes of pbrt-v3's materials and a lamp do not show: pbrt-v4's materials, and
// lights of every type.
#include <gtest/gtest.h>

#include "base/folder_testing.h"
#include "image/image_io.h"
#include "pipeline.h"
#include "test_scenes.h"

namespace drc {
namespace {

using test::Estimate;
using test::Pipeline;

constexpr int kWidth = 6, kHeight = 6, kBlock = 3, kSamples = 1024, kGroup = 32, kPasses = 3;

// Of blocks of pixels, which are independent of each other: few samples of rare bright paths are no normal deviate, and
// those of many pixels together nearly are.
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

// slack: a share of b that is forgiven.
void expectSameBlocks(Estimate a, const Estimate& b, const std::string& what, double slack = 0) {
    for (size_t i = 0; i < a.mean.size(); ++i) {
        const double most = slack * b.mean[i];
        a.mean[i] += std::clamp(b.mean[i] - a.mean[i], -most, most);
    }
    const test::ZResult z = test::zTest(a, b);
    EXPECT_EQ(z.tests, int(a.mean.size())) << what;
    EXPECT_LT(z.worst, z.bound) << what;
    EXPECT_LT(z.meanDifference, 4) << what;
    EXPECT_LT(z.meanSquare, 3) << what;
}

// Direct light plus indirect light, traced in either way or from a map at each pixel, is what paths bring.
void checkSplit(const Pipeline& pipeline) {
    const auto of = [&](Rgb (Pipeline::*way)(int, int) const) {
        return blocks(pipeline.estimate(way, kSamples, kGroup));
    };
    const Estimate path = of(&Pipeline::path), direct = of(&Pipeline::direct);
    expectSameBlocks(direct + of(&Pipeline::tracedIndirect), path, "direct and traced");
    expectSameBlocks(direct + of(&Pipeline::indirectAlong), path, "direct and along with it");
    // Texels blur a lamp that is seen through a thin sheet: of twice as many to a side nothing is left of that.
    IndirectSettings settings;
    settings.gatherSamples = 32;
    settings.primarySamples = 1;
    const Estimate maps = blocks(pipeline.cachedIndirect(*makeIdentityEnhancer(), settings, 1, kPasses));
    expectSameBlocks(direct + of(&Pipeline::narrowIndirect) + maps, path, "direct and maps at every pixel", 0.005);
}

class MaterialsOfV4 : public testing::TestWithParam<size_t> {};
INSTANTIATE_TEST_SUITE_P(Split, MaterialsOfV4, testing::Range<size_t>(0, test::materialsOfV4().size()),
                         [](const auto& i) { return test::materialsOfV4()[i.param].first; });

TEST_P(MaterialsOfV4, IsExact) {
    const std::string material = test::materialsOfV4()[GetParam()].second;
    // Near enough that all of the picture is of the material.
    const std::string near =
        test::respelt(test::room(material, kWidth, kHeight), "\"float fov\" 70", "\"float fov\" 30");
    checkSplit(Pipeline(test::inWordsOfV4(near)));
}

// A corner of a room that is open to the sky, with a mirror on a wall, a ball that shines, and a light.
std::string corner(const std::string& light) {
    return "LookAt 0 -1.9 1.5  0 0 1  0 0 1\nCamera \"perspective\" \"float fov\" 70\nFilm \"image\" "
           "\"integer xresolution\" " +
           std::to_string(kWidth) + " \"integer yresolution\" " + std::to_string(kHeight) +
           "\nWorldBegin\n"
           "Material \"matte\" \"rgb Kd\" [0.7 0.6 0.5]\n" +
           test::quad("-2 -2 0", "2 -2 0", "2 2 0", "-2 2 0") + test::quad("-2 2 0", "2 2 0", "2 2 3", "-2 2 3") +
           "Material \"matte\" \"rgb Kd\" [0.7 0.2 0.1]\n" + test::quad("-2 -2 0", "-2 2 0", "-2 2 3", "-2 -2 3") +
           "Material \"mirror\" \"rgb Kr\" [0.8 0.8 0.8]\n" +
           test::quad("-1.9 0 0", "-1.9 0 2", "-1.9 1 2", "-1.9 1 0") +
           "Material \"plastic\" \"rgb Kd\" [0.3 0.4 0.5] \"rgb Ks\" [0.4 0.4 0.4] \"float roughness\" 0.3\n"
           "AttributeBegin\nTranslate 0.5 0.2 0.6\nShape \"sphere\" \"float radius\" 0.6\nAttributeEnd\n" +
           light + "WorldEnd\n";
}

// `map`: a picture for those that have one.
struct LightCase {
    const char *name, *light;
};
void PrintTo(const LightCase& c, std::ostream* out) { *out << c.name; }
const LightCase kLights[] = {
    {"Point", "LightSource \"point\" \"rgb I\" [9 8 7] \"point from\" [-0.5 -0.8 2]\n"},
    {"Spot",
     "LightSource \"spot\" \"rgb I\" [40 30 20] \"point from\" [-0.5 -1 2.5] \"point to\" [0.4 0.3 0.2] "
     "\"float coneangle\" 40 \"float conedeltaangle\" 15\n"},
    {"Goniometric",
     "AttributeBegin\nTranslate -0.4 -0.6 2\nRotate 90 1 0 0\n"
     "LightSource \"goniometric\" \"rgb I\" [20 20 20] \"string mapname\" \"map.exr\"\nAttributeEnd\n"},
    {"Projection",
     "AttributeBegin\nTranslate -0.4 -1 2.5\nRotate -140 1 0 0\n"
     "LightSource \"projection\" \"rgb I\" [50 50 50] \"float fov\" 70 \"string mapname\" \"map.exr\"\nAttributeEnd\n"},
    {"Distant", "LightSource \"distant\" \"rgb L\" [3 2 2] \"point from\" [1 -2 3] \"point to\" [0 0 0]\n"},
    {"Infinite", "LightSource \"infinite\" \"rgb L\" [0.6 0.7 0.9]\n"},
    {"InfiniteMap",
     "AttributeBegin\nRotate 60 1 2 0\nLightSource \"infinite\" \"string mapname\" \"map.exr\"\nAttributeEnd\n"},
    {"Area",
     "AttributeBegin\nMaterial \"matte\" \"rgb Kd\" [0 0 0]\nAreaLightSource \"diffuse\" \"rgb L\" [8 7 6]\n"
     "Translate 0.3 -0.6 2.2\nRotate 180 1 0 0\nShape \"disk\" \"float radius\" 0.5\nAttributeEnd\n"},
    {"TwoSidedSphere",
     "AttributeBegin\nMaterial \"matte\" \"rgb Kd\" [0.5 0.5 0.5]\n"
     "AreaLightSource \"diffuse\" \"rgb L\" [4 5 6] \"bool twosided\" \"true\"\n"
     "Translate -0.7 0.1 1.4\nShape \"sphere\" \"float radius\" 0.4 \"float zmax\" 0.2\nAttributeEnd\n"},
    {"AreaWithoutAMaterial",
     "AttributeBegin\nMaterial \"\"\nAreaLightSource \"diffuse\" \"rgb L\" [4 5 6]\n"
     "Translate -0.7 0.1 1.4\nShape \"sphere\" \"float radius\" 0.4\nAttributeEnd\n"},
    {"ManyAtOnce",
     "LightSource \"infinite\" \"rgb L\" [0.2 0.2 0.3]\nLightSource \"distant\" \"rgb L\" [1 1 1] \"point from\" "
     "[1 -2 3]\nLightSource \"point\" \"rgb I\" [3 3 3] \"point from\" [-0.5 -0.8 2]\n"
     "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [4 3 2]\nTranslate 0.3 -0.6 2.2\nRotate 180 1 0 0\n"
     "Shape \"disk\" \"float radius\" 0.4\nAttributeEnd\n"},
};

class LightsOfEveryType : public testing::TestWithParam<LightCase> {};
INSTANTIATE_TEST_SUITE_P(Split, LightsOfEveryType, testing::ValuesIn(kLights),
                         [](const auto& i) { return i.param.name; });

TEST_P(LightsOfEveryType, IsExact) {
    const TemporaryFolder folder;
    Image map(16, 8);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 16; ++x) map.setRgb(x, y, Rgb((x / 2 + y) % 3 == 0 ? 2.f : 0.1f, 0.5f, 0.1f * float(y)));
    writeExr(folder.path("map.exr"), map);
    const std::string text = test::respelt(corner(GetParam().light), "map.exr", folder.path("map.exr"));
    checkSplit(Pipeline(text));
}

}  // namespace
}  // namespace drc
