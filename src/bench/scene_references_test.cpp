#include "bench/scene_references.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/folder_testing.h"
#include "image/image_io.h"
#include "image/metrics.h"
#include "image/noise_testing.h"

namespace drc {
namespace {

using namespace noise_testing;
using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

class SceneReferencesTest : public FolderTest {
  protected:
    SceneReferencesTest() {
        for (const char* name : {"hall-1.exr", "hall-2.exr", "room.exr"})
            writeExr(path(name), noisy(truth_, gaussian(0.1f), rng_));
        writeExr(path("test.exr"), noisy(truth_, gaussian(0.05f), rng_));
    }
    Rng rng_{3};
    const Image truth_ = scene(64, 48);
};

TEST_F(SceneReferencesTest, PairsComeBeforeSingleOnes) {
    EXPECT_THAT(givenReferences(dir_.string(), "room"), ElementsAre(EndsWith("/room.exr")));
    EXPECT_THAT(givenReferences(dir_.string(), "hall"), ElementsAre(EndsWith("/hall-1.exr"), EndsWith("/hall-2.exr")));
    writeExr(path("hall.exr"), truth_);
    EXPECT_EQ(givenReferences(dir_.string(), "hall").size(), 2u);
    std::filesystem::remove(path("hall-1.exr"));
    EXPECT_THAT(errorOf([&] { givenReferences(dir_.string(), "hall"); }), HasSubstr("hall-2.exr is there"));
    EXPECT_THAT(errorOf([&] { givenReferences(dir_.string(), "yard"); }),
                AllOf(HasSubstr("yard.exr"), HasSubstr("yard-1.exr")));
}

TEST_F(SceneReferencesTest, MeasureByAPairOrByOne) {
    BenchRun run;
    SceneReferences(givenReferences(dir_.string(), "hall")).measure(path("test.exr"), run);
    EXPECT_NEAR(run.error, 0.05 * 0.05 * 0.9, 0.001);
    EXPECT_GT(run.errorSe, 0);
    EXPECT_GT(run.trimmedErrorSe, 0);
    EXPECT_GT(run.blockErrorSe, 0);
    BenchRun single;
    SceneReferences(givenReferences(dir_.string(), "room")).measure(path("test.exr"), single);
    const Metrics m = compare(readLinearRgb(path("room.exr")), readLinearRgb(path("test.exr")));
    EXPECT_EQ(single.error, m.relmse);
    EXPECT_EQ(single.blockError, m.blockRelmse);
    EXPECT_EQ(single.ssim, m.ssim);
    EXPECT_TRUE(std::isnan(single.errorSe) && std::isnan(single.trimmedError));
}

TEST_F(SceneReferencesTest, DescribeTheNoiseOfAPair) {
    BenchScene scene;
    SceneReferences(givenReferences(dir_.string(), "hall")).describe(scene);
    EXPECT_NEAR(scene.referenceNoise, 0.009, 0.002);
    EXPECT_GT(scene.ssimNoise, 0);
    EXPECT_GT(scene.flipNoise, 0);
    EXPECT_GT(scene.referencePngKb, 0);
    BenchScene single;
    SceneReferences(givenReferences(dir_.string(), "room")).describe(single);
    EXPECT_TRUE(std::isnan(single.referenceNoise) && std::isnan(single.ssimNoise));
    EXPECT_GT(single.referencePngKb, 0);
}

}  // namespace
}  // namespace drc
