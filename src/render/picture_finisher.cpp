#include "render/picture_finisher.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/log.h"
#include "base/parallel.h"

namespace drc {
namespace {

using Clock = std::chrono::steady_clock;

// A filter is kept if its estimated time is at most this many times the time left: estimates from parts tend to be too
// long, and a noisy picture in time is worth less than a clean one that is a little late.
constexpr double kLateIsBetter = 1.3;
// Greatest share of the budget for measuring a larger part. If finishing takes less than kNegligible of the budget, no
// larger part is measured.
constexpr double kMostToMeasure = 0.03, kNegligible = 0.01;
// The side of the smallest part in pixels: no filter reaches farther.
constexpr int kLeastSide = 64;
// Open Image Denoise's networks pad pictures to multiples of this many pixels. At a few hundred pixels, padding would
// add 5 to 8 % to the measured part, and so to the estimate for the whole picture.
constexpr int kWholeSide = 16;
// The estimate is multiplied by this, because the speed of a machine varies.
constexpr double kMargin = 1.03;
// How much faster this machine may be than the one that PictureFilters::secondsPerPixel was measured on.
constexpr double kFasterMachine = 2;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// The central part of a region: each side divided by `divisor`, but at least kLeastSide, in multiples of kWholeSide.
PixelRegion middle(const PixelRegion& region, double divisor) {
    const auto side = [&](int length) {
        return std::min(length, std::max(kLeastSide, int(length / divisor) / kWholeSide * kWholeSide));
    };
    const int width = side(region.width()), height = side(region.height());
    const int x = region.x0 + (region.width() - width) / 2, y = region.y0 + (region.height() - height) / 2;
    return {x, y, x + width, y + height};
}

}  // namespace

DenoisedError PictureFinisher::errorOf(const LayeredPicture& picture) const {
    const auto start = Clock::now();
    DenoisedError error = estimateDenoisedError(picture, [this](LayeredPicture& half) { filter(half); });
    if (stats_) stats_->timer("estimate of the error").add(Clock::now() - start);
    return error;
}

void PictureFinisher::filter(LayeredPicture& picture) const {
    for (const auto& filter : filters().filters) filter->apply(picture);
}

void PictureFinisher::apply(LayeredPicture& picture, ExrMetadata& metadata) const {
    if (estimateError_) {
        DenoisedError error = errorOf(picture);
        if (std::isfinite(error.whole)) metadata["drc:error"] = fmt::format("{:.4f}", error.whole);
        picture.error = std::move(error.local);
    }
    filter(picture);
    if (const auto& balance = writer_.settings().whiteBalance) picture.balance(*balance);
}

double PictureFinisher::secondsFor(const Session& session, const PixelRegion& part) const {
    const auto start = Clock::now();
    LayeredPicture picture = session.snapshot(part);
    // While the first sample of the pixels is not complete, a denoiser would have less to do than at the end.
    picture.takenAsComplete = true;
    ExrMetadata metadata;
    apply(picture, metadata);
    writer_.encode(picture, metadata);
    return secondsSince(start);
}

double PictureFinisher::estimate(const Session& session, double budget) {
    const PixelRegion& whole = session.film().region();
    const auto timed = [&](const PixelRegion& part) {
        const double seconds = secondsFor(session, part);
        logDebug(fmt::format("to finish {} x {} pixels takes {:.3f} s", part.width(), part.height(), seconds));
        return seconds;
    };
    // After the first estimate, only the speed of the machine is measured again.
    if (last_.seconds > 0) return last_.estimate * timed(last_.part) / last_.seconds;
    // The first run is not measured, because it takes longer than all later ones.
    const double smallest = std::max(1.0, double(std::min(whole.width(), whole.height())) / kLeastSide);
    const PixelRegion small = middle(whole, smallest);
    secondsFor(session, small);
    const double smallPixels = double(small.count()), all = double(whole.count());
    const double smallSeconds = timed(small), estimated = smallSeconds / smallPixels * all;
    last_ = {small, smallSeconds, estimated};
    // Then measure a part as large as there is time for, since large parts are filtered more efficiently than small
    // ones.
    const double share = kMostToMeasure * budget / estimated;
    if (estimated < kNegligible * budget || share * all < 1.5 * smallPixels) return last_.estimate;
    const PixelRegion large = middle(whole, std::sqrt(std::max(1.0, 1 / share)));
    const double seconds = timed(large), pixels = double(large.count());
    double perPixel = pixels > smallPixels ? (seconds - smallSeconds) / (pixels - smallPixels) : 0;
    if (!(perPixel > 0)) perPixel = seconds / pixels;
    last_ = {large, seconds, std::max(0.0, seconds - perPixel * pixels) + perPixel * all};
    return last_.estimate;
}

LayeredPicture PictureFinisher::finish(LayeredPicture picture, ExrMetadata metadata) {
    const auto start = Clock::now();
    apply(picture, metadata);
    metadata["drc:denoiser"] = filters().name();
    const auto filtered = Clock::now();
    if (stats_) stats_->timer("denoise").add(filtered - start);
    writer_.write(writer_.encode(picture, metadata));
    if (stats_) stats_->timer("write").add(Clock::now() - filtered);
    return picture;
}

void PictureFinisher::useCheaper() {
    candidates_.erase(candidates_.begin());
    last_ = {};
}

void PictureFinisher::measure(Session& session, double besides) {
    Schedule& schedule = session.schedule();
    const bool first = last_.seconds == 0;
    // Even a part of the picture takes long to filter in a mode that is too expensive for the whole.
    const double pixels = double(session.film().region().count()) / threadCount();
    while (first && !filters().wanted && candidates_.size() > 1 &&
           filters().secondsPerPixel * pixels > kFasterMachine * filters().mostOfBudget * schedule.budget())
        useCheaper();
    for (;;) {
        schedule.reserve(kMargin * (estimate(session, schedule.budget()) + besides));
        schedule.reserveMeasured();
        const double most =
            std::min(filters().mostOfBudget * schedule.budget(), kLateIsBetter * schedule.secondsLeft());
        if (!first || schedule.reserved() <= most || candidates_.size() == 1) return;
        const std::string text = fmt::format(
            "--time {:g}: '{}' would take {:.1f} s; {}", schedule.budget(), filters().name(), schedule.reserved(),
            candidates_[1].filters.empty() ? "the picture is left as it is"
                                           : "'" + candidates_[1].name() + "' is used");
        if (filters().wanted)
            logWarning(text);
        else
            logDebug(text);
        useCheaper();
    }
}

}  // namespace drc
