#include "image/pair_metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/folder_testing.h"
#include "image/flip.h"
#include "image/noise_testing.h"
#include "image/ssim.h"

namespace drc {
namespace {

using namespace noise_testing;
using testing::AllOf;
using testing::HasSubstr;

class PairMetricsTest : public testing::Test {
  protected:
    Image reference(float deviation) { return noisy(truth_, gaussian(deviation), rng_); }
    Rng rng_{5};
    const Image truth_ = scene(96, 64);
};

TEST_F(PairMetricsTest, DisplayedMetricsAreAgainstTheMean) {
    const ReferencePair pair(reference(0.01f), reference(0.01f));
    const Image test = noisy(truth_, gaussian(0.1f), rng_);
    const PairMetrics m = pair.compare(test);
    EXPECT_EQ(m.ssim, ssim(pair.mean(), test));
    EXPECT_EQ(m.flip, flip(pair.mean(), test));
    EXPECT_GT(m.pngKb[1], m.pngKb[0]);
    EXPECT_FALSE(m.ssimIsNoisy || m.flipIsNoisy);
    EXPECT_NEAR(m.errors.error.mean, 0.01, 0.002);
}

// What the noise of the mean alone does is known from what both references differ by.
TEST_F(PairMetricsTest, SaysHowFarTheNoiseOfTheReferencesCounts) {
    for (const float deviation : {0.01f, 0.02f, 0.04f}) {
        const ReferencePair pair(reference(deviation), reference(deviation));
        const PairMetrics perfect = pair.compare(truth_);
        EXPECT_NEAR(pair.ssimNoise(), 1 - perfect.ssim, 0.4 * (1 - perfect.ssim)) << deviation;
        EXPECT_NEAR(pair.flipNoise(), perfect.flip, 0.4 * perfect.flip) << deviation;
        EXPECT_TRUE(perfect.ssimIsNoisy && perfect.flipIsNoisy);
    }
}

TEST_F(PairMetricsTest, RefusesWhatCannotBeMeasured) {
    const Image a = reference(0.1f), b = reference(0.1f);
    EXPECT_THAT(errorOf([&] { ReferencePair(a, a, 0, "a.exr", "b.exr"); }),
                AllOf(HasSubstr("a.exr and b.exr are the same picture"), HasSubstr("different seeds")));
    EXPECT_THAT(errorOf([&] { ReferencePair(a, Image(8, 8), 0, "a.exr", "b.exr"); }),
                AllOf(HasSubstr("a.exr is 96x64"), HasSubstr("b.exr is 8x8")));
    const ReferencePair pair(a, b, 0, "a.exr", "b.exr");
    EXPECT_THAT(errorOf([&] { pair.compare(b, "t.exr"); }), HasSubstr("t.exr is the same picture as b.exr"));
    EXPECT_THAT(errorOf([&] { pair.compare(Image(9, 9), "t.exr"); }), HasSubstr("t.exr is 9x9"));
}

TEST_F(PairMetricsTest, ExposureChangesOnlyWhatIsDisplayed) {
    const Image a = reference(0.1f), b = reference(0.1f), test = reference(0.1f);
    const PairMetrics plain = ReferencePair(a, b).compare(test), dark = ReferencePair(a, b, -2).compare(test);
    EXPECT_EQ(plain.errors.error.mean, dark.errors.error.mean);
    EXPECT_GT(plain.flip, dark.flip);
}

}  // namespace
}  // namespace drc
