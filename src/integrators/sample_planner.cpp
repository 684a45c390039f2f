#include "integrators/sample_planner.h"

#include <cmath>

namespace drc {

SamplePlanner::SamplePlanner(const PixelRegion& region, float displayScale, uint32_t firstSample)
    : density_(region, displayScale), parts_(density_.blocks()) {
    // Shards of a picture use different parts of the sample sequences.
    for (Part& part : parts_) part.samples = {firstSample * uint32_t(kMostSamples), 1};
}

void SamplePlanner::update(int samples, bool wholeSample) {
    if (!wholeSample) return;
    density_.update(samples);
    for (size_t i = 0; i < parts_.size(); ++i) {
        Part& part = parts_[i];
        const double before = std::floor(part.wanted);
        part.wanted += density_.density(i);
        part.training = float(1 / density_.density(i));
        part.samples = {part.samples.first + uint32_t(part.samples.count), int(std::floor(part.wanted) - before)};
    }
}

void SamplePlanner::save(StateWriter& to) const {
    density_.save(to);
    for (const Part& part : parts_) {
        to.value(part.samples.first);
        to.value(int32_t(part.samples.count));
        to.value(part.wanted);
        to.value(part.training);
    }
}

void SamplePlanner::load(StateReader& from) {
    density_.load(from);
    for (Part& part : parts_) {
        part.samples.first = from.value<uint32_t>();
        part.samples.count = from.value<int32_t>();
        part.wanted = from.value<double>();
        if (part.samples.count < 0 || part.samples.count > kMostSamples + 1 || !std::isfinite(part.wanted))
            from.fail("there cannot be so many camera samples");
        part.training = from.value<float>();
        if (!(part.training > 0 && part.training <= 1 / SampleDensity::kLeast))
            from.fail("there cannot be such a probability");
    }
}

}  // namespace drc
