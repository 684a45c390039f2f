#include "render/sample_planner.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/error.h"
#include "math/rng.h"

namespace drc {
namespace {

constexpr int kBlock = SamplePlanner::kBlock;
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
    Samples(SamplePlanner& planner, std::vector<Noise> blocks, Noise rest = {})
        : planner_(planner), blocks_(std::move(blocks)) {
        blocks_.resize(12, rest);
        pixels_.resize(kRegion.count());
    }
    // A pass.
    void take() {
        for (int y = kRegion.y0; y < kRegion.y1; ++y)
            for (int x = kRegion.x0; x < kRegion.x1; ++x)
                for (int i = 0; i < planner_.samples(x, y).count; ++i) take(x, y);
        planner_.update(++passes_, true);
    }
    // The samples that a pixel has had.
    float of(int x, int y) const { return pixels_[kRegion.index(x, y)].samples; }
    float total() const {
        float sum = 0;
        for (const Pixel& pixel : pixels_) sum += pixel.samples;
        return sum;
    }

  private:
    struct Pixel {
        float mean = 0, samples = 0;
    };
    void take(int x, int y) {
        Pixel& pixel = pixels_[kRegion.index(x, y)];
        const Noise& noise = blocks_[size_t((x - kRegion.x0) / kBlock)];
        const FinalGather::Splitting plan = planner_.splitting(x, y, planner_.samples(x, y).first);
        FinalGather::Noise found;
        float value = 1 + uniform(random_, noise.hit);
        value += part(plan.lights, noise.light, found.lights) + part(plan.rays, noise.ray, found.rays);
        planner_.add(x, y,
                     {.value = value,
                      .noise = found,
                      .half = int(random_.nextUint(2)),
                      .mean = pixel.mean,
                      .samples = double(pixel.samples)});
        pixel.mean += (value - pixel.mean) / ++pixel.samples;
    }
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

    SamplePlanner& planner_;
    std::vector<Noise> blocks_;
    std::vector<Pixel> pixels_;
    Pcg32 random_{7};
    int passes_ = 0;
};

// In a pixel that does not measure.
FinalGather::Splitting planOf(const SamplePlanner& planner, int block) {
    int x = kRegion.x0 + block * kBlock;
    while (SamplePlanner::measures(x, kRegion.y0)) ++x;
    return planner.splitting(x, kRegion.y0, planner.samples(x, kRegion.y0).first);
}

SamplePlanner planner(uint32_t firstSample = 0) { return {kRegion, 1, firstSample}; }

TEST(SamplePlanner, TakesMoreWhereLightSamplesOrRaysAreNoisier) {
    SamplePlanner p = planner();
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

TEST(SamplePlanner, TakesFewWhereHitsAreNoisierThanRays) {
    SamplePlanner p = planner();
    Samples samples(p, {{.hit = 1, .ray = 0.8f}}, {.hit = 1});
    for (int i = 0; i < 6; ++i) samples.take();
    EXPECT_EQ(planOf(p, 0).rays, 1);
}

TEST(SamplePlanner, IsBoundedAndSlowToBegin) {
    SamplePlanner p = planner();
    Samples samples(p, {{.light = 4, .ray = 4}});
    EXPECT_EQ(planOf(p, 0).rays, 1);
    for (int i = 0; i < 32; ++i) {
        samples.take();
        EXPECT_LE(planOf(p, 0).rays, i + 1);
    }
    EXPECT_EQ(planOf(p, 0).rays, SamplePlanner::kMostRays);
    EXPECT_EQ(planOf(p, 0).lights, SamplePlanner::kMostLights);
}

// As SampleDensity says. Pixels with more samples train less often, so that all have as many training paths.
TEST(SamplePlanner, TakesMoreCameraSamplesWhereThePictureIsNoisier) {
    SamplePlanner p = planner();
    Samples samples(p, {{.hit = 0.6f}});
    for (int i = 0; i < 66; ++i) samples.take();
    EXPECT_NEAR(samples.total() / float(kRegion.count()), 66, 2);
    const float most = samples.of(kRegion.x0, kRegion.y0), least = samples.of(kRegion.x0 + 3 * kBlock, kRegion.y0);
    EXPECT_GT(most, 2 * least);
    EXPECT_GE(least, SampleDensity::kLeast * 66 - 1);
    EXPECT_LE(most, SamplePlanner::kMostSamples * 66);
    EXPECT_NEAR(planOf(p, 0).training * most, planOf(p, 3).training * least, 0.2f * least);
    EXPECT_LT(planOf(p, 0).training, 0.5f * planOf(p, 3).training);
}

TEST(SamplePlanner, AlwaysMeasuresInAQuarterOfThePixels) {
    const SamplePlanner p = planner();
    int measuring = 0;
    for (int y = kRegion.y0; y < kRegion.y1; ++y)
        for (int x = kRegion.x0; x < kRegion.x0 + kBlock; ++x) {
            const FinalGather::Splitting plan = p.splitting(x, y, 0);
            EXPECT_EQ(plan.rays, SamplePlanner::measures(x, y) ? 2 : 1);
            EXPECT_EQ(plan.lights, plan.rays);
            measuring += plan.rays == 2;
        }
    EXPECT_EQ(measuring, kBlock * kBlock / 4);
}

TEST(SamplePlanner, GoesOnInTheSequencesWhereTheLastPassEnded) {
    SamplePlanner p = planner();
    Samples samples(p, {{.light = 0.4f, .ray = 0.8f}});
    const int y = kRegion.y0;
    int most = 0;
    // A pixel that measures, and one that does not.
    ASSERT_TRUE(SamplePlanner::measures(kRegion.x0, y));
    for (int i = 0; i < 24; ++i) {
        const int x = kRegion.x0 + i % 2;
        const PixelSamples before = p.samples(x, y);
        const FinalGather::Splitting last = p.splitting(x, y, before.first + uint32_t(before.count));
        most = std::max(most, before.count);
        samples.take();
        EXPECT_EQ(p.samples(x, y).first, before.first + uint32_t(before.count));
        const FinalGather::Splitting next = p.splitting(x, y, p.samples(x, y).first);
        EXPECT_EQ(next.firstRay, last.firstRay);
        EXPECT_EQ(next.firstLight, last.firstLight);
    }
    EXPECT_GT(most, 1);
}

TEST(SamplePlanner, GivesShardsSequencesThatDoNotMeet) {
    // A shard of 8 samples, all of which may have as many rays as there can be.
    constexpr uint32_t kSamples = 8 * SamplePlanner::kMostSamples;
    const SamplePlanner first = planner(0), second = planner(8);
    EXPECT_GE(second.samples(kRegion.x0, kRegion.y0).first, first.samples(kRegion.x0, kRegion.y0).first + kSamples);
    EXPECT_GE(planOf(second, 0).firstRay, planOf(first, 0).firstRay + kSamples * SamplePlanner::kMostRays);
    EXPECT_GE(planOf(second, 0).firstLight, planOf(first, 0).firstLight + kSamples * SamplePlanner::kMostLights);
}

TEST(SamplePlanner, PartsOfASampleDoNotEndIt) {
    SamplePlanner p = planner();
    p.update(0, false);
    EXPECT_EQ(planOf(p, 0).firstRay, 0u);
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
    Samples samples(whole, {{.light = 0.4f, .ray = 0.8f}, {.ray = 0.1f}});
    for (int i = 0; i < 3; ++i) samples.take();
    // In the middle of a pass.
    whole.add(kRegion.x0, kRegion.y0, {.value = 2, .noise = {3, 5}, .mean = 1, .samples = 3});
    save(whole);
    SamplePlanner loaded = planner();
    load(loaded);
    for (SamplePlanner* p : {&whole, &loaded}) p->update(4, true);
    for (int block = 0; block < 3; ++block) {
        EXPECT_EQ(planOf(whole, block).rays, planOf(loaded, block).rays);
        EXPECT_EQ(planOf(whole, block).lights, planOf(loaded, block).lights);
        EXPECT_EQ(planOf(whole, block).firstRay, planOf(loaded, block).firstRay);
        EXPECT_EQ(planOf(whole, block).firstLight, planOf(loaded, block).firstLight);
        const int x = kRegion.x0 + block * kBlock;
        EXPECT_EQ(whole.samples(x, kRegion.y0).first, loaded.samples(x, kRegion.y0).first);
        EXPECT_EQ(whole.samples(x, kRegion.y0).count, loaded.samples(x, kRegion.y0).count);
    }
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
