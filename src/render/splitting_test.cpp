#include "render/splitting.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/error.h"
#include "math/rng.h"

namespace drc {
namespace {

constexpr int kBlock = SplitPlanner::kBlock;
// Blocks side by side, the last of which is cut off by the end of the picture.
constexpr PixelRegion kRegion{100, 40, 100 + 11 * kBlock + 3, 40 + kBlock};

// The standard deviations of what a camera sample is made of.
struct Noise {
    float hit = 0.1f, light = 0, ray = 0;
};

float uniform(Pcg32& random, float deviation) { return (random.nextFloat() - 0.5f) * std::sqrt(12.f) * deviation; }

// Camera samples of radiance 1 as final gather would take them, each of whose parts has the noise of its block.
class Samples {
  public:
    // blocks: of the first ones. rest: of all others.
    Samples(SplitPlanner& planner, std::vector<Noise> blocks, Noise rest = {})
        : planner_(planner), blocks_(std::move(blocks)) {
        blocks_.resize(12, rest);
        means_.resize(kRegion.count());
    }
    // One more sample of each pixel.
    void take() {
        for (int y = kRegion.y0; y < kRegion.y1; ++y)
            for (int x = kRegion.x0; x < kRegion.x1; ++x) {
                const Noise& noise = blocks_[size_t((x - kRegion.x0) / kBlock)];
                const FinalGather::Splitting plan = planner_.at(x, y);
                FinalGather::Noise found;
                float value = 1 + uniform(random_, noise.hit);
                value += part(plan.lights, noise.light, found.lights) + part(plan.rays, noise.ray, found.rays);
                float& mean = means_[kRegion.index(x, y)];
                planner_.add(x, y, found, value, mean, samples_);
                mean += (value - mean) / float(samples_ + 1);
            }
        planner_.update(++samples_, true);
    }

  private:
    float part(int count, float deviation, float& variance) {
        float sum = 0, squares = 0;
        for (int i = 0; i < count; ++i) {
            const float value = uniform(random_, deviation);
            sum += value;
            squares += value * value;
        }
        if (count > 1) variance = std::max(0.f, (squares - sum * sum / float(count)) / float(count - 1));
        return sum / float(count);
    }

    SplitPlanner& planner_;
    std::vector<Noise> blocks_;
    std::vector<float> means_;
    Pcg32 random_{7};
    int samples_ = 0;
};

FinalGather::Splitting planOf(const SplitPlanner& planner, int block) {
    return planner.at(kRegion.x0 + block * kBlock, kRegion.y0);
}

SplitPlanner planner(uint32_t firstSample = 0) { return {kRegion, 1, firstSample}; }

TEST(SplitPlanner, TakesMoreWhereLightSamplesOrRaysAreNoisier) {
    SplitPlanner p = planner();
    Samples samples(p, {{.ray = 0.5f}, {.light = 0.3f, .ray = 0.2f}});
    for (int i = 0; i < 24; ++i) samples.take();
    // n = sqrt(variance / (cost * variance of a hit)): .25 / .02 and .09 / .006, .04 / .02, nothing.
    EXPECT_NEAR(planOf(p, 0).rays, 3.5f, 1);
    EXPECT_EQ(planOf(p, 0).lights, 1);
    EXPECT_NEAR(planOf(p, 1).lights, 3.9f, 1);
    EXPECT_NEAR(planOf(p, 1).rays, 1.4f, 0.6f);
    for (const int others : {2, 11}) {
        EXPECT_EQ(planOf(p, others).rays, 1);
        EXPECT_EQ(planOf(p, others).lights, 1);
    }
}

TEST(SplitPlanner, TakesFewWhereHitsAreNoisierThanRays) {
    SplitPlanner p = planner();
    Samples samples(p, {{.hit = 1, .ray = 0.8f}}, {.hit = 1});
    for (int i = 0; i < 6; ++i) samples.take();
    EXPECT_EQ(planOf(p, 0).rays, 1);
}

TEST(SplitPlanner, IsBoundedAndSlowToBegin) {
    SplitPlanner p = planner();
    Samples samples(p, {{.light = 4, .ray = 4}});
    EXPECT_EQ(planOf(p, 0).rays, 2);
    for (int i = 0; i < 12; ++i) {
        samples.take();
        EXPECT_LE(planOf(p, 0).rays, 2 + 2 * (i + 1));
    }
    EXPECT_EQ(planOf(p, 0).rays, SplitPlanner::kMostRays);
    EXPECT_EQ(planOf(p, 0).lights, SplitPlanner::kMostLights);
}

TEST(SplitPlanner, GoesOnInTheSequencesWhereTheLastSampleEnded) {
    SplitPlanner p = planner();
    Samples samples(p, {{.light = 0.4f, .ray = 0.8f}});
    for (int i = 0; i < 8; ++i) {
        const FinalGather::Splitting before = planOf(p, 0);
        samples.take();
        EXPECT_EQ(planOf(p, 0).firstRay, before.firstRay + uint32_t(before.rays));
        EXPECT_EQ(planOf(p, 0).firstLight, before.firstLight + uint32_t(before.lights));
    }
}

TEST(SplitPlanner, GivesShardsSequencesThatDoNotMeet) {
    // A shard of 8 samples, all of which may have as many rays as there can be.
    const SplitPlanner first = planner(0), second = planner(8);
    EXPECT_GE(planOf(second, 0).firstRay, planOf(first, 0).firstRay + 8 * SplitPlanner::kMostRays);
    EXPECT_GE(planOf(second, 0).firstLight, planOf(first, 0).firstLight + 8 * SplitPlanner::kMostLights);
}

TEST(SplitPlanner, PartsOfASampleDoNotEndIt) {
    SplitPlanner p = planner();
    p.update(0, false);
    EXPECT_EQ(planOf(p, 0).firstRay, 0u);
}

class SavedSplitPlanner : public testing::Test {
  protected:
    void TearDown() override { std::filesystem::remove(path_); }
    void save(const SplitPlanner& p) {
        StateWriter file(path_, "plans 1");
        p.save(file);
        file.commit();
    }
    void load(SplitPlanner& p) {
        StateReader file(path_, "plans", "plans 1");
        p.load(file);
    }
    const std::string path_ = (std::filesystem::temp_directory_path() /
                               ("drc-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name())))
                                  .string();
};

TEST_F(SavedSplitPlanner, GoesOnAsIfItHadNotBeenSaved) {
    SplitPlanner whole = planner();
    Samples samples(whole, {{.light = 0.4f, .ray = 0.8f}, {.ray = 0.1f}});
    for (int i = 0; i < 3; ++i) samples.take();
    // In the middle of a pass.
    whole.add(kRegion.x0, kRegion.y0, {3, 5}, 2, 1, 3);
    save(whole);
    SplitPlanner loaded = planner();
    load(loaded);
    for (SplitPlanner* p : {&whole, &loaded}) p->update(4, true);
    for (int block = 0; block < 3; ++block) {
        EXPECT_EQ(planOf(whole, block).rays, planOf(loaded, block).rays);
        EXPECT_EQ(planOf(whole, block).lights, planOf(loaded, block).lights);
        EXPECT_EQ(planOf(whole, block).firstRay, planOf(loaded, block).firstRay);
        EXPECT_EQ(planOf(whole, block).firstLight, planOf(loaded, block).firstLight);
    }
}

TEST_F(SavedSplitPlanner, RefusesPlansThatCannotBe) {
    StateWriter file(path_, "plans 1");
    for (int i = 0; i < 10000; ++i) file.value(int32_t(0));
    file.commit();
    SplitPlanner p = planner();
    EXPECT_THROW(load(p), Error);
}

}  // namespace
}  // namespace drc
