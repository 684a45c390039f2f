#include "render/schedule.h"

#include <algorithm>
#include <cmath>

#include "film/sample_pass.h"
#include "integrators/integrator.h"
#include "maps/map_grid.h"

namespace drc {
namespace {

// The share of the time that sample passes get, if there are map passes too.
constexpr double kSampleShare = 0.7;
// Finest map spacing with a time budget, in pixels. Beyond it, further map passes reduce the error more than more maps
// in one pass.
constexpr float kFinestInTime = 3;
// If the first map pass would take more than this share of the budget, it lights only a lattice of pixels.
constexpr double kFirstMapShare = 0.25;
// The cost of a pixel in a map pass, in units of a camera sample of direct light. Measured at 1280x720: 2.0 in
// living-room, 3.8 in cornell-box.
constexpr double kGatherInSamples = 3;
// The time to finish the picture is measured again after this share of the time for passes.
constexpr double kMeasureAgainAt = 0.6;

double seconds(std::chrono::steady_clock::duration d) { return std::chrono::duration<double>(d).count(); }

}  // namespace

Schedule::Schedule(const RenderParams& params, Clock::time_point start, int filmHeight, size_t pixels)
    : params_(params),
      maps_(traitsOf(params.integrator).maps),
      start_(start),
      filmHeight_(filmHeight),
      pixels_(double(pixels)) {
    if (params.seconds > 0)
        end_ = start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(params.seconds));
}

std::optional<Schedule::Clock::time_point> Schedule::deadline() const {
    if (!end_) return std::nullopt;
    return *end_ - std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(reserved_));
}

double Schedule::budget() const { return end_ ? params_.seconds : kInfinity; }
double Schedule::secondsLeft() const { return end_ ? seconds(*end_ - Clock::now()) : kInfinity; }

bool Schedule::wantsReserve(int samplePasses, int mapPasses) const {
    if (!end_ || !hasPicture(samplePasses, mapPasses)) return false;
    if (measured_ == 0) return true;
    return measured_ == 1 && seconds(Clock::now() - start_) > kMeasureAgainAt * (params_.seconds - reserved_);
}

std::optional<Schedule::Work> Schedule::next(int samplePasses, int mapPasses) const {
    const Work samples{Work::Kind::Samples, samplePasses};
    Work maps{Work::Kind::Maps, mapPasses, passSpacing(mapPasses, filmHeight_, params_.firstSpacing)};
    const int wanted = *params_.spp, wantedMaps = maps_ ? *params_.mapPasses : 0;
    if (!end_) {
        const int taken = SamplePass::wholeSamples(samplePasses);
        // Alternates between the two kinds, so that an interrupted render has both in proportion.
        if (mapPasses < wantedMaps && (taken >= wanted || double(mapPasses) / wantedMaps <= double(taken) / wanted))
            return maps;
        if (taken < wanted) return samples;
        return std::nullopt;
    }
    if (hasPicture(samplePasses, mapPasses) && Clock::now() >= *deadline()) return std::nullopt;
    const bool samplesLeft = SamplePass::wholeSamples(samplePasses) < wanted, mapsLeft = mapPasses < wantedMaps;
    if (!mapsLeft) return samplesLeft ? std::optional(samples) : std::nullopt;
    if (samplePasses == 0) return samples;
    if (mapPasses == 0) {
        const double gather = gatherSeconds();
        while (maps.stride < 4 && gather / sqr(double(maps.stride)) > kFirstMapShare * params_.seconds)
            maps.stride *= 2;
        return maps;
    }
    if (SamplePass::wholeSamples(samplePasses) == 0) return samples;
    maps.spacing = spacingInTime(mapPasses);
    if (!samplesLeft) return maps.spacing > 0 ? std::optional(maps) : std::nullopt;
    const double total = sampleSeconds_ + mapSeconds_;
    return maps.spacing > 0 && sampleSeconds_ > kSampleShare * total ? maps : samples;
}

double Schedule::gatherSeconds() const { return pixels_ * kGatherInSamples * secondsPerSample_; }

float Schedule::spacingInTime(int mapPasses) const {
    const double left = seconds(*deadline() - Clock::now());
    // The first pass is cheap and completes the picture. The second is made so fine that four passes, each with the
    // usual 1.26 times as many maps as the one before, fill the rest of the map passes' time.
    constexpr double kPassesInTime = 4;
    const double growth = 1 / sqr(double(kSpacingFactor));
    double cost = lastMapSeconds_ * growth;
    if (mapPasses == 1) {
        const double sum = (std::pow(growth, kPassesInTime) - 1) / (growth - 1);
        cost = std::max(cost, (1 - kSampleShare) * left / sum);
    }
    // A pass must end before the deadline: it gets fewer maps if need be, and is left out if it would be much coarser
    // than the last one.
    if (cost > 0.9 * left) {
        if (0.5 * lastMapSeconds_ > left) return 0;
        cost = 0.9 * left;
    }
    return std::max(kFinestInTime, float(lastSpacing_ * std::sqrt(lastMapSeconds_ / cost)));
}

void Schedule::finished(const Work& work, Clock::duration duration, bool whole) {
    const double took = seconds(duration);
    if (work.kind == Work::Kind::Samples) {
        sampleSeconds_ += took;
        if (work.index == 0 && whole) secondsPerSample_ = took / std::max(1.0, pixels_ / 16);
        return;
    }
    mapSeconds_ += took;
    // The time for all pixels, extrapolated from the lattice.
    lastMapSeconds_ = took + gatherSeconds() * (1 - 1 / sqr(double(work.stride)));
    lastSpacing_ = work.spacing;
}

double Schedule::progress(int samplePasses, int mapPasses) const {
    const double timed =
        end_ ? std::clamp(seconds(Clock::now() - start_) / std::max(1e-9, params_.seconds - reserved_), 0.0, 1.0) : 0;
    const double samples = std::min(1.0, double(SamplePass::wholeSamples(samplePasses)) / std::max(1, *params_.spp));
    if (!maps_) return std::max(timed, samples);
    // Later passes cost more, in proportion to their number of maps.
    const auto mapsOf = [](int n) { return std::pow(double(kSpacingFactor), -2.0 * n) - 1; };
    const double passes = *params_.mapPasses > 0 ? mapsOf(mapPasses) / mapsOf(*params_.mapPasses) : 1;
    return std::max(timed, kSampleShare * samples + (1 - kSampleShare) * std::min(1.0, passes));
}

}  // namespace drc
