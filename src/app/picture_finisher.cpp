#include "app/picture_finisher.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/log.h"

namespace drc {
namespace {

using Clock = std::chrono::steady_clock;

// If finishing takes more than this share of the budget, cheaper filters are used.
constexpr double kMostOfBudget = 0.7;
// A larger part is measured if that takes no more than this share of the budget.
constexpr double kMostToMeasure = 0.02;
// The side of the smallest part in pixels: no filter reaches farther.
constexpr int kLeastSide = 64;
// The estimate is multiplied by this, because the speed of a machine varies.
constexpr double kMargin = 1.03;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// The central part of a region: each side divided by `divisor`, but at least kLeastSide.
PixelRegion middle(const PixelRegion& region, int divisor) {
    const auto side = [&](int length) { return std::min(length, std::max(kLeastSide, length / divisor)); };
    const int width = side(region.width()), height = side(region.height());
    const int x = region.x0 + (region.width() - width) / 2, y = region.y0 + (region.height() - height) / 2;
    return {x, y, x + width, y + height};
}

}  // namespace

double PictureFinisher::secondsFor(const Session& session, const PixelRegion& part) const {
    const auto start = Clock::now();
    LayeredPicture picture = session.snapshot(part);
    for (const auto& filter : filters()) filter->apply(picture);
    writer_.encode(picture, {});
    return secondsSince(start);
}

double PictureFinisher::estimate(const Session& session, double budget) const {
    const PixelRegion& whole = session.film().region();
    // A first, unmeasured run, because it takes longer than all that follow.
    secondsFor(session, middle(whole, 16));
    double fixed = 0, perPixel = 0, lastPixels = 0, lastSeconds = 0;
    for (const int divisor : {16, 8, 4, 2, 1}) {
        const PixelRegion part = middle(whole, divisor);
        const double pixels = double(part.count());
        if (lastPixels > 0) {
            if (pixels <= lastPixels) continue;
            if (fixed + perPixel * pixels > kMostToMeasure * budget) break;
        }
        const double seconds = secondsFor(session, part);
        if (lastPixels > 0) perPixel = std::max(0.0, (seconds - lastSeconds) / (pixels - lastPixels));
        if (lastPixels == 0 || perPixel == 0) perPixel = seconds / pixels;
        fixed = std::max(0.0, seconds - perPixel * pixels);
        lastPixels = pixels;
        lastSeconds = seconds;
    }
    return kMargin * (fixed + perPixel * double(whole.count()));
}

void PictureFinisher::finish(LayeredPicture picture, const ExrMetadata& metadata) {
    const auto start = Clock::now();
    for (const auto& filter : filters()) filter->apply(picture);
    const auto filtered = Clock::now();
    stats_.timer("denoise").add(filtered - start);
    writer_.write(writer_.encode(picture, metadata));
    stats_.timer("write").add(Clock::now() - filtered);
}

void PictureFinisher::measure(Session& session) {
    Schedule& schedule = session.schedule();
    for (;;) {
        schedule.reserve(estimate(session, schedule.budget()));
        schedule.reserveMeasured();
        if (schedule.reserved() <= kMostOfBudget * schedule.budget() || candidates_.size() == 1) return;
        logWarning(fmt::format("--time {:g}: '{}' alone would take {:.1f} s; {}", schedule.budget(),
                               filters().front()->name(), schedule.reserved(),
                               candidates_[1].empty() ? "the picture is left as it is"
                                                      : "'" + candidates_[1].front()->name() + "' is used"));
        candidates_.erase(candidates_.begin());
    }
}

}  // namespace drc
