#include "render/sample_planner.h"

#include <algorithm>
#include <cmath>

namespace drc {
namespace {

// The costs of a gather ray and of a light sample, in units of a camera hit without them. Measured at 1280x720 in
// living-room, bathroom2, staircase2 and iispt-court2 they are .9 to 1.3, and .3. They count twice, because a denoised
// picture profits more from camera hits, which find its edges, than the variance of pixels tells.
constexpr double kRayCost = 2, kLightCost = 0.6;
// Added to squared displayed radiance, as in the error that pictures are measured by (docs/measuring.md).
constexpr double kDarkest = 0.01;
// The least share of the variance that is taken for the camera hit's own.
constexpr double kLeastShare = 0.02;

// The fewest camera samples of a pixel for each that it would have if all had the same number.
constexpr double kFewestSamples = 0.75;
// For an error that falls with the number of samples n as n^-p, the best share is as error^(1 / (1 + p)).
constexpr double kPowerOfVariance = 0.5;

// A sample's difference from its pixel's mean counts at most as so many times the mean of the block. A few more samples
// do not average a firefly away.
constexpr double kBrightest = 8;

double ratio(double sum, double count) { return count > 0 ? sum / count : 0; }

// The mean without the least and the greatest tenth.
double trimmedMean(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const size_t cut = values.size() / 10;
    double sum = 0;
    for (size_t i = cut; i + cut < values.size(); ++i) sum += values[i];
    return values.empty() ? 0 : sum / double(values.size() - 2 * cut);
}

}  // namespace

void SamplePlanner::Sums::add(const Sums& other) {
    lights += other.lights;
    rays += other.rays;
    lightHits += other.lightHits;
    rayHits += other.rayHits;
    value += other.value;
    values += other.values;
    square += other.square;
    bounded += other.bounded;
    split += other.split;
    squares += other.squares;
}

void SamplePlanner::Sums::save(StateWriter& to) const {
    for (const double v : {lights, rays, lightHits, rayHits, value, values, square, bounded, split, squares})
        to.value(v);
}

void SamplePlanner::Sums::load(StateReader& from) {
    for (double* v : {&lights, &rays, &lightHits, &rayHits, &value, &values, &square, &bounded, &split, &squares})
        *v = from.value<double>();
}

SamplePlanner::SamplePlanner(const PixelRegion& region, float displayScale, uint32_t firstSample)
    : region_(region), scale_(displayScale > 0 ? displayScale : 1) {
    const int rows = (region.height() + kBlock - 1) / kBlock;
    blocks_.resize(size_t(rows) * size_t(columns()));
    rows_.resize(size_t(region.height()) * size_t(columns()));
    // Shards of a picture take their numbers from different parts of the sequences.
    const uint32_t first = firstSample * uint32_t(kMostSamples);
    for (Block& block : blocks_) {
        block.plan = {1, 1, first * uint32_t(kMostLights), first * uint32_t(kMostRays)};
        block.measuringPlan = {2, 2, block.plan.firstLight, block.plan.firstRay};
        block.samples = {first, 1};
    }
}

FinalGather::Splitting SamplePlanner::splitting(int x, int y, uint32_t index) const {
    const Block& block = blocks_[blockOf(x, y)];
    FinalGather::Splitting plan = planFor(x, y, block);
    plan.firstLight += (index - block.samples.first) * uint32_t(plan.lights);
    plan.firstRay += (index - block.samples.first) * uint32_t(plan.rays);
    return plan;
}

void SamplePlanner::add(int x, int y, const FinalGather::Noise& noise, float value, float mean, double samples) {
    Sums& sums = rows_[size_t(y - region_.y0) * size_t(columns()) + size_t((x - region_.x0) / kBlock)];
    if (noise.lights >= 0) {
        sums.lights += double(noise.lights);
        ++sums.lightHits;
    }
    if (noise.rays >= 0) {
        sums.rays += double(noise.rays);
        ++sums.rayHits;
    }
    sums.value += double(value);
    ++sums.values;
    if (!(samples > 0) || !measures(x, y)) return;
    // The mean has an error of its own.
    const double square = double(value - mean) * double(value - mean) * samples / (samples + 1);
    const Block& block = blocks_[blockOf(x, y)];
    const double brightest = kBrightest * ratio(block.sums.value, block.sums.values);
    // Samples that have met no surface to split at have noise below 0.
    const auto share = [](float variance, int count) { return double(std::max(0.f, variance)) / count; };
    const FinalGather::Splitting& plan = planFor(x, y, block);
    sums.square += square;
    sums.bounded += std::min(square, brightest * brightest);
    sums.split += share(noise.lights, plan.lights) + share(noise.rays, plan.rays);
    ++sums.squares;
}

double SamplePlanner::relative(const Block& block, double variance) const {
    const double value = ratio(block.sums.value, block.sums.values), scale2 = double(scale_) * double(scale_);
    return variance * scale2 / (value * value * scale2 + kDarkest);
}

void SamplePlanner::update(int samples, bool wholeSample) {
    for (int row = 0; row < region_.height(); ++row)
        for (int column = 0; column < columns(); ++column) {
            Sums& sums = rows_[size_t(row) * size_t(columns()) + size_t(column)];
            blocks_[size_t(row / kBlock) * size_t(columns()) + size_t(column)].sums.add(sums);
            sums = {};
        }
    if (!wholeSample) return;
    // Trimmed, because a block with fireflies would else decide for the whole picture.
    std::vector<double> all, own;
    for (const Block& block : blocks_) {
        const Sums& sums = block.sums;
        if (sums.squares == 0) continue;
        all.push_back(relative(block, sums.square / sums.squares));
        own.push_back(relative(block, (sums.square - sums.split) / sums.squares));
    }
    // The variance of a camera sample with infinitely many light samples and rays. An underestimate, because stratified
    // samples have less noise than their variance tells, and may be none at all.
    const double variance = std::max(trimmedMean(own), kLeastShare * trimmedMean(all));
    for (Block& block : blocks_) {
        FinalGather::Splitting& plan = block.plan;
        FinalGather::Splitting& measuring = block.measuringPlan;
        for (FinalGather::Splitting* of : {&plan, &measuring}) {
            of->firstLight += uint32_t(block.samples.count * of->lights);
            of->firstRay += uint32_t(block.samples.count * of->rays);
        }
        if (!(variance > 0)) continue;
        // Few at first: a picture of two or three camera samples has more need of a fourth.
        const auto best = [&](double ofOne, double cost, int limit) {
            const double n = std::sqrt(relative(block, ofOne) / (variance * cost));
            return int(std::lrint(std::clamp(n, 1.0, double(std::min(limit, std::max(1, samples))))));
        };
        plan.lights = best(ratio(block.sums.lights, block.sums.lightHits), kLightCost, kMostLights);
        plan.rays = best(ratio(block.sums.rays, block.sums.rayHits), kRayCost, kMostRays);
        measuring.lights = std::max(plan.lights, 2);
        measuring.rays = std::max(plan.rays, 2);
    }
    planSamples();
}

void SamplePlanner::planSamples() {
    // A block's share of the samples: by its variance, between two bounds, so that the mean over all pixels is 1.
    std::vector<double> shares, pixels;
    double sum = 0;
    for (size_t i = 0; i < blocks_.size(); ++i) {
        const Block& block = blocks_[i];
        const int column = int(i) % columns(), row = int(i) / columns();
        pixels.push_back(double(std::min(kBlock, region_.width() - column * kBlock)) *
                         double(std::min(kBlock, region_.height() - row * kBlock)));
        shares.push_back(std::pow(relative(block, ratio(block.sums.bounded, block.sums.squares)), kPowerOfVariance));
        sum += shares[i] * pixels[i];
    }
    const auto all = double(region_.count());
    double scale = sum > 0 ? all / sum : 0;
    const auto share = [&](size_t i) {
        return sum > 0 ? std::clamp(scale * shares[i], kFewestSamples, double(kMostSamples)) : 1.;
    };
    constexpr int kRounds = 16;
    for (int round = 0; round < kRounds; ++round) {
        double bounded = 0;
        for (size_t i = 0; i < blocks_.size(); ++i) bounded += share(i) * pixels[i];
        scale *= all / bounded;
    }
    double least = kMostSamples;
    for (size_t i = 0; i < blocks_.size(); ++i) least = std::min(least, share(i));
    for (size_t i = 0; i < blocks_.size(); ++i) {
        Block& block = blocks_[i];
        const double before = std::floor(block.wanted);
        block.wanted += share(i);
        // Where pixels have more samples, each counts less in the picture, and what it deposits shall count less.
        block.plan.training = block.measuringPlan.training = float(least / share(i));
        block.samples = {block.samples.first + uint32_t(block.samples.count), int(std::floor(block.wanted) - before)};
    }
}

void SamplePlanner::save(StateWriter& to) const {
    for (const Block& block : blocks_) {
        block.sums.save(to);
        for (const FinalGather::Splitting* plan : {&block.plan, &block.measuringPlan}) {
            to.value(int32_t(plan->lights));
            to.value(int32_t(plan->rays));
            to.value(plan->firstLight);
            to.value(plan->firstRay);
            to.value(plan->training);
        }
        to.value(block.samples.first);
        to.value(int32_t(block.samples.count));
        to.value(block.wanted);
    }
    // Between passes there are none.
    const auto used = [](const Sums& sums) { return sums.values > 0; };
    to.value(uint64_t(std::ranges::count_if(rows_, used)));
    for (size_t i = 0; i < rows_.size(); ++i) {
        if (!used(rows_[i])) continue;
        to.value(uint64_t(i));
        rows_[i].save(to);
    }
}

void SamplePlanner::load(StateReader& from) {
    for (Block& block : blocks_) {
        block.sums.load(from);
        for (FinalGather::Splitting* plan : {&block.plan, &block.measuringPlan}) {
            plan->lights = from.value<int32_t>();
            plan->rays = from.value<int32_t>();
            plan->firstLight = from.value<uint32_t>();
            plan->firstRay = from.value<uint32_t>();
            plan->training = from.value<float>();
            if (!(plan->training > 0 && plan->training <= 1)) from.fail("there cannot be such a probability");
            if (plan->lights < 1 || plan->lights > kMostLights || plan->rays < 1 || plan->rays > kMostRays)
                from.fail("there cannot be so many rays for a camera sample");
        }
        block.samples.first = from.value<uint32_t>();
        block.samples.count = from.value<int32_t>();
        block.wanted = from.value<double>();
        if (block.samples.count < 0 || block.samples.count > kMostSamples + 1 || !std::isfinite(block.wanted))
            from.fail("there cannot be so many camera samples");
    }
    std::ranges::fill(rows_, Sums{});
    for (auto left = from.value<uint64_t>(); left > 0; --left) {
        const auto i = from.value<uint64_t>();
        if (i >= rows_.size()) from.fail("there cannot be so many rows of pixels");
        rows_[i].load(from);
    }
}

}  // namespace drc
