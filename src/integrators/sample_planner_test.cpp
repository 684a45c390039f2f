#include "integrators/sample_planner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "base/error.h"
#include "math/rng.h"

namespace drc {
namespace {

constexpr int kBlock = SampleDensity::kBlock;
// Blocks side by side, the last of which is cut off by the end of the picture.
constexpr PixelRegion kRegion{100, 40, 100 + 11 * kBlock + 3, 40 + 2 * kBlock};

// Camera samples of radiance 1, with more noise in the first columns of blocks than elsewhere.
class Samples {
  public:
    explicit Samples(SamplePlanner& planner) : planner_(planner), taken_(kRegion.count()) {}
    // A pass.
    void take() {
        for (int y = kRegion.y0; y < kRegion.y1; ++y)
            for (int x = kRegion.x0; x < kRegion.x1; ++x)
                for (int i = 0; i < planner_.samples(x, y).count; ++i) {
                    const float deviation = x < kRegion.x0 + 2 * kBlock ? 0.6f : 0.1f;
                    const float value = 1 + (random_.nextFloat() - 0.5f) * std::sqrt(12.f) * deviation;
                    planner_.add(x, y, int(random_.nextUint(2)), value, {});
                    ++taken_[kRegion.index(x, y)];
                }
        planner_.update(++passes_, true);
    }
    // The samples that a pixel has had.
    float of(int x, int y) const { return taken_[kRegion.index(x, y)]; }
    float total() const {
        float sum = 0;
        for (const float pixel : taken_) sum += pixel;
        return sum;
    }

  private:
    SamplePlanner& planner_;
    std::vector<float> taken_;
    Pcg32 random_{7};
    int passes_ = 0;
};

SamplePlanner planner(uint32_t firstSample = 0) { return {kRegion, 1, firstSample}; }
constexpr int xOf(int block) { return kRegion.x0 + block * kBlock; }

// As SampleDensity says. Pixels with more samples train less often, so that all have as many training paths.
TEST(SamplePlanner, TakesMoreCameraSamplesWhereThePictureIsNoisier) {
    SamplePlanner p = planner();
    Samples samples(p);
    for (int i = 0; i < 66; ++i) samples.take();
    EXPECT_NEAR(samples.total() / float(kRegion.count()), 66, 2);
    const float most = samples.of(xOf(0), kRegion.y0), least = samples.of(xOf(6), kRegion.y0);
    EXPECT_GT(most, 2 * least);
    EXPECT_GE(least, SampleDensity::kLeast * 66 - 1);
    EXPECT_LE(most, SamplePlanner::kMostSamples * 66);
    const float often = p.training(xOf(6), kRegion.y0), rarely = p.training(xOf(0), kRegion.y0);
    EXPECT_NEAR(rarely * most, often * least, 0.2f * least);
    EXPECT_LT(rarely, 0.5f * often);
}

TEST(SamplePlanner, GoesOnInTheSequencesWhereTheLastPassEnded) {
    SamplePlanner p = planner();
    Samples samples(p);
    int most = 0;
    for (int i = 0; i < 24; ++i) {
        const PixelSamples before = p.samples(kRegion.x0, kRegion.y0);
        most = std::max(most, before.count);
        samples.take();
        EXPECT_EQ(p.samples(kRegion.x0, kRegion.y0).first, before.first + uint32_t(before.count));
    }
    EXPECT_GT(most, 1);
}

TEST(SamplePlanner, GivesShardsSequencesThatDoNotMeet) {
    // A shard of 8 samples, all of which may be as many as there can be.
    const SamplePlanner first = planner(0), second = planner(8);
    EXPECT_GE(second.samples(kRegion.x0, kRegion.y0).first,
              first.samples(kRegion.x0, kRegion.y0).first + 8 * SamplePlanner::kMostSamples);
}

TEST(SamplePlanner, PartsOfASampleDoNotEndIt) {
    SamplePlanner p = planner();
    p.update(0, false);
    EXPECT_EQ(p.samples(kRegion.x0, kRegion.y0).first, 0u);
    p.update(1, true);
    EXPECT_EQ(p.samples(kRegion.x0, kRegion.y0).first, 1u);
}

class SavedSamplePlanner : public testing::Test {
  protected:
    void TearDown() override { std::filesystem::remove(path_); }
    void save(const SamplePlanner& p) {
        StateWriter file(path_, "plans 1");
        p.save(file);
        file.commit();
    }
    void load(SamplePlanner& p) {
        StateReader file(path_, "plans", "plans 1");
        p.load(file);
    }
    const std::string path_ = (std::filesystem::temp_directory_path() /
                               ("drc-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name())))
                                  .string();
};

TEST_F(SavedSamplePlanner, GoesOnAsIfItHadNotBeenSaved) {
    SamplePlanner whole = planner();
    Samples samples(whole);
    for (int i = 0; i < 3; ++i) samples.take();
    // In the middle of a pass.
    whole.add(kRegion.x0, kRegion.y0, 0, 2, {});
    save(whole);
    SamplePlanner loaded = planner();
    load(loaded);
    for (SamplePlanner* p : {&whole, &loaded}) p->update(4, true);
    for (int block = 0; block < 12; ++block) {
        const int x = xOf(block);
        EXPECT_EQ(whole.samples(x, kRegion.y0).first, loaded.samples(x, kRegion.y0).first);
        EXPECT_EQ(whole.samples(x, kRegion.y0).count, loaded.samples(x, kRegion.y0).count);
        EXPECT_EQ(whole.training(x, kRegion.y0), loaded.training(x, kRegion.y0));
    }
    EXPECT_NE(whole.training(xOf(0), kRegion.y0), whole.training(xOf(6), kRegion.y0));
}

TEST_F(SavedSamplePlanner, RefusesPlansThatCannotBe) {
    StateWriter file(path_, "plans 1");
    for (int i = 0; i < 10000; ++i) file.value(int32_t(0));
    file.commit();
    SamplePlanner p = planner();
    EXPECT_THROW(load(p), Error);
}

}  // namespace
}  // namespace drc
