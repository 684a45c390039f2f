#include "render/sample_planner.h"

#include <algorithm>
#include <cmath>

#include "image/relative_norm.h"

namespace drc {
namespace {

// The costs of a gather ray and of a light sample, in units of a camera hit without them. Measured at 1280x720 in
// living-room, bathroom2, staircase2 and iispt-court2 they are .9 to 1.3, and .3. They count twice, because a denoised
// picture profits more from camera hits, which find its edges, than the variance of pixels tells.
constexpr double kRayCost = 2, kLightCost = 0.6;
// The least share of the variance that is taken for the camera hit's own.
constexpr double kLeastShare = 0.02;

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
    split += other.split;
    squares += other.squares;
}

void SamplePlanner::Sums::save(StateWriter& to) const {
    for (const double v : {lights, rays, lightHits, rayHits, value, values, square, split, squares}) to.value(v);
}

void SamplePlanner::Sums::load(StateReader& from) {
    for (double* v : {&lights, &rays, &lightHits, &rayHits, &value, &values, &square, &split, &squares})
        *v = from.value<double>();
}

SamplePlanner::SamplePlanner(const PixelRegion& region, float displayScale, uint32_t firstSample)
    : region_(region), scale_(displayScale > 0 ? displayScale : 1), density_(region, displayScale) {
    const int rows = (region.height() + kBlock - 1) / kBlock;
    blocks_.resize(size_t(rows) * size_t(columns()));
    rows_.resize(size_t(region.height()) * size_t(columns()));
    parts_.resize(density_.blocks());
    // Shards of a picture take their numbers from different parts of the sequences.
    const uint32_t first = firstSample * uint32_t(kMostSamples);
    for (Part& part : parts_) {
        part.samples = {first, 1};
        for (const int measuring : {0, 1}) {
            part.firstLight[measuring] = first * uint32_t(kMostLights);
            part.firstRay[measuring] = first * uint32_t(kMostRays);
        }
    }
}

const SamplePlanner::Block& SamplePlanner::blockOfPart(size_t part) const {
    constexpr size_t kParts = kBlock / SampleDensity::kBlock;
    const auto width = size_t(density_.columns());
    return blocks_[part / width / kParts * size_t(columns()) + part % width / kParts];
}

FinalGather::Splitting SamplePlanner::splitting(int x, int y, uint32_t index) const {
    const Block& block = blocks_[blockOf(x, y)];
    const Part& part = parts_[density_.blockOf(x, y)];
    const bool measuring = measures(x, y);
    const int lights = block.lightsAt(measuring), rays = block.raysAt(measuring);
    const uint32_t before = index - part.samples.first;
    return {.lights = lights,
            .rays = rays,
            .firstLight = part.firstLight[measuring] + before * uint32_t(lights),
            .firstRay = part.firstRay[measuring] + before * uint32_t(rays),
            .training = part.training};
}

void SamplePlanner::add(int x, int y, const Taken& sample) {
    density_.add(x, y, sample.half, sample.value, sample.surface);
    const FinalGather::Noise& noise = sample.noise;
    Sums& sums = rows_[size_t(y - region_.y0) * size_t(columns()) + size_t((x - region_.x0) / kBlock)];
    if (noise.lights >= 0) {
        sums.lights += double(noise.lights);
        ++sums.lightHits;
    }
    if (noise.rays >= 0) {
        sums.rays += double(noise.rays);
        ++sums.rayHits;
    }
    sums.value += double(sample.value);
    ++sums.values;
    if (!(sample.samples > 0) || !measures(x, y)) return;
    const double difference = double(sample.value - sample.mean);
    // Samples that have met no surface to split at have noise below 0.
    const auto share = [](float variance, int count) { return double(std::max(0.f, variance)) / count; };
    const Block& block = blocks_[blockOf(x, y)];
    // The mean has an error of its own.
    sums.square += difference * difference * sample.samples / (sample.samples + 1);
    sums.split += share(noise.lights, block.lightsAt(true)) + share(noise.rays, block.raysAt(true));
    ++sums.squares;
}

double SamplePlanner::relative(const Block& block, double variance) const {
    const double value = ratio(block.sums.value, block.sums.values), scale2 = double(scale_) * double(scale_);
    return variance * scale2 / (value * value * scale2 + kRelativeNormOffset);
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
    // Before the plans change.
    for (size_t i = 0; i < parts_.size(); ++i) {
        Part& part = parts_[i];
        const Block& block = blockOfPart(i);
        for (const bool measuring : {false, true}) {
            part.firstLight[measuring] += uint32_t(part.samples.count * block.lightsAt(measuring));
            part.firstRay[measuring] += uint32_t(part.samples.count * block.raysAt(measuring));
        }
    }
    for (Block& block : blocks_) {
        if (!(variance > 0)) break;
        // Few at first: a picture of two or three camera samples has more need of a fourth.
        const auto best = [&](double ofOne, double cost, int limit) {
            const double n = std::sqrt(relative(block, ofOne) / (variance * cost));
            return int(std::lrint(std::clamp(n, 1.0, double(std::min(limit, std::max(1, samples))))));
        };
        block.lights = best(ratio(block.sums.lights, block.sums.lightHits), kLightCost, kMostLights);
        block.rays = best(ratio(block.sums.rays, block.sums.rayHits), kRayCost, kMostRays);
    }
    density_.update(samples);
    planSamples();
}

void SamplePlanner::planSamples() {
    for (size_t i = 0; i < parts_.size(); ++i) {
        Part& part = parts_[i];
        const double before = std::floor(part.wanted);
        part.wanted += density_.density(i);
        // Where pixels have more samples, each counts less in the picture, and what it deposits shall count less.
        part.training = float(1 / density_.density(i));
        part.samples = {part.samples.first + uint32_t(part.samples.count), int(std::floor(part.wanted) - before)};
    }
}

void SamplePlanner::save(StateWriter& to) const {
    density_.save(to);
    for (const Block& block : blocks_) {
        block.sums.save(to);
        to.value(int32_t(block.lights));
        to.value(int32_t(block.rays));
    }
    for (const Part& part : parts_) {
        to.value(part.samples.first);
        to.value(int32_t(part.samples.count));
        to.value(part.wanted);
        to.values(std::span(part.firstLight));
        to.values(std::span(part.firstRay));
        to.value(part.training);
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
    density_.load(from);
    for (Block& block : blocks_) {
        block.sums.load(from);
        block.lights = from.value<int32_t>();
        block.rays = from.value<int32_t>();
        if (block.lights < 1 || block.lights > kMostLights || block.rays < 1 || block.rays > kMostRays)
            from.fail("there cannot be so many rays for a camera sample");
    }
    for (Part& part : parts_) {
        part.samples.first = from.value<uint32_t>();
        part.samples.count = from.value<int32_t>();
        part.wanted = from.value<double>();
        if (part.samples.count < 0 || part.samples.count > kMostSamples + 1 || !std::isfinite(part.wanted))
            from.fail("there cannot be so many camera samples");
        from.values(std::span(part.firstLight));
        from.values(std::span(part.firstRay));
        part.training = from.value<float>();
        if (!(part.training > 0 && part.training <= 1 / SampleDensity::kLeast))
            from.fail("there cannot be such a probability");
    }
    std::ranges::fill(rows_, Sums{});
    for (auto left = from.value<uint64_t>(); left > 0; --left) {
        const auto i = from.value<uint64_t>();
        if (i >= rows_.size()) from.fail("there cannot be so many rows of pixels");
        rows_[i].load(from);
    }
}

}  // namespace drc
