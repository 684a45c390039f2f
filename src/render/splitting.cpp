#include "render/splitting.h"

#include <algorithm>
#include <cmath>

namespace drc {
namespace {

// The costs of a gather ray and of a light sample, in units of a camera hit without them. Measured at 1280x720 in
// living-room, bathroom2, staircase2 and iispt-court2 they are .9 to 1.3, and .3. They count twice, because a denoised
// picture profits more from camera hits, which find its edges, than the variance of pixels tells.
constexpr double kRayCost = 2, kLightCost = 0.6;
// All blocks begin with this, so that variances can be measured.
constexpr int kFirstLights = 2, kFirstRays = 2;
// Squared radiance that is displayed with this is not told from black.
constexpr double kDarkest = 0.01;
// The least share of the variance that is taken for the camera hit's own.
constexpr double kLeastShare = 0.02;

// The mean without the least and the greatest tenth.
double trimmedMean(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const size_t cut = values.size() / 10;
    double sum = 0;
    for (size_t i = cut; i + cut < values.size(); ++i) sum += values[i];
    return values.empty() ? 0 : sum / double(values.size() - 2 * cut);
}

}  // namespace

void SplitPlanner::Sums::add(const Sums& other) {
    lights += other.lights;
    rays += other.rays;
    lightHits += other.lightHits;
    rayHits += other.rayHits;
    value += other.value;
    values += other.values;
    square += other.square;
    splitSquare += other.splitSquare;
    squares += other.squares;
}

void SplitPlanner::Sums::save(StateWriter& to) const {
    for (const double v : {lights, rays, lightHits, rayHits, value, values, square, splitSquare, squares}) to.value(v);
}

void SplitPlanner::Sums::load(StateReader& from) {
    for (double* v : {&lights, &rays, &lightHits, &rayHits, &value, &values, &square, &splitSquare, &squares})
        *v = from.value<double>();
}

SplitPlanner::SplitPlanner(const PixelRegion& region, float displayScale, uint32_t firstSample)
    : region_(region), scale_(displayScale > 0 ? displayScale : 1) {
    const int rows = (region.height() + kBlock - 1) / kBlock;
    blocks_.resize(size_t(rows) * size_t(columns()));
    rows_.resize(size_t(region.height()) * size_t(columns()));
    // Shards of a picture take their numbers from different parts of the sequences.
    for (Block& block : blocks_)
        block.plan = {kFirstLights, kFirstRays, firstSample * uint32_t(kMostLights), firstSample * uint32_t(kMostRays)};
}

void SplitPlanner::add(int x, int y, const FinalGather::Noise& noise, float value, float mean, double samples) {
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
    if (!(samples > 0) || !wantsMean(y)) return;
    const FinalGather::Splitting& plan = at(x, y);
    if (plan.lights == 1 || plan.rays == 1) return;
    // The mean has an error of its own.
    sums.square += double(value - mean) * double(value - mean) * samples / (samples + 1);
    // Samples that have met no surface to split at have noise below 0.
    const auto share = [](float variance, int count) { return double(std::max(0.f, variance)) / count; };
    sums.splitSquare += share(noise.lights, plan.lights) + share(noise.rays, plan.rays);
    ++sums.squares;
}

void SplitPlanner::update(int samples, bool wholeSample) {
    for (int row = 0; row < region_.height(); ++row)
        for (int column = 0; column < columns(); ++column) {
            Sums& sums = rows_[size_t(row) * size_t(columns()) + size_t(column)];
            blocks_[size_t(row / kBlock) * size_t(columns()) + size_t(column)].sums.add(sums);
            sums = {};
        }
    if (!wholeSample) return;
    const auto mean = [](double sum, double count) { return count > 0 ? sum / count : 0; };
    const double scale2 = double(scale_) * double(scale_);
    const auto relative = [&](const Block& block, double variance) {
        const double value = mean(block.sums.value, block.sums.values);
        return variance * scale2 / (value * value * scale2 + kDarkest);
    };
    // Means over the blocks without those that stand out most, which would have few samples everywhere else.
    std::vector<double> all, own;
    for (const Block& block : blocks_) {
        const Sums& sums = block.sums;
        if (sums.squares == 0) continue;
        all.push_back(relative(block, sums.square / sums.squares));
        own.push_back(relative(block, (sums.square - sums.splitSquare) / sums.squares));
    }
    // The variance of a camera sample with infinitely many light samples and rays. An underestimate, because stratified
    // samples have less noise than their variance tells, and may be none at all.
    const double variance = std::max(trimmedMean(own), kLeastShare * trimmedMean(all));
    for (Block& block : blocks_) {
        FinalGather::Splitting& plan = block.plan;
        plan.firstLight += uint32_t(plan.lights);
        plan.firstRay += uint32_t(plan.rays);
        if (!(variance > 0)) continue;
        // Few at first, so that the first pictures are not late.
        const auto best = [&](double ofOne, double cost, int limit) {
            const double n = std::sqrt(relative(block, ofOne) / (variance * cost));
            return int(std::lrint(std::clamp(n, 1.0, double(std::min(limit, kFirstRays + 2 * samples)))));
        };
        plan.lights = best(mean(block.sums.lights, block.sums.lightHits), kLightCost, kMostLights);
        plan.rays = best(mean(block.sums.rays, block.sums.rayHits), kRayCost, kMostRays);
    }
}

void SplitPlanner::save(StateWriter& to) const {
    for (const Block& block : blocks_) {
        block.sums.save(to);
        to.value(int32_t(block.plan.lights));
        to.value(int32_t(block.plan.rays));
        to.value(block.plan.firstLight);
        to.value(block.plan.firstRay);
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

void SplitPlanner::load(StateReader& from) {
    for (Block& block : blocks_) {
        block.sums.load(from);
        block.plan.lights = from.value<int32_t>();
        block.plan.rays = from.value<int32_t>();
        block.plan.firstLight = from.value<uint32_t>();
        block.plan.firstRay = from.value<uint32_t>();
        if (block.plan.lights < 1 || block.plan.lights > kMostLights || block.plan.rays < 1 ||
            block.plan.rays > kMostRays)
            from.fail("there cannot be so many rays for a camera sample");
    }
    std::ranges::fill(rows_, Sums{});
    for (auto left = from.value<uint64_t>(); left > 0; --left) {
        const auto i = from.value<uint64_t>();
        if (i >= rows_.size()) from.fail("there cannot be so many rows of pixels");
        rows_[i].load(from);
    }
}

}  // namespace drc
