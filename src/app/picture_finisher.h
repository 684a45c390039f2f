// Turns the film into files: filters, encodes and writes the picture, and measures during the render how long that will
// take.
#pragma once
#include <memory>

#include "app/picture_writer.h"
#include "render/picture_filter.h"
#include "render/session.h"

namespace drc {

using PictureFilters = std::vector<std::shared_ptr<const PictureFilter>>;

class PictureFinisher {
  public:
    // candidates: the wanted filters, then cheaper ones for when there is no time for these; not empty.
    PictureFinisher(std::vector<PictureFilters> candidates, PictureWriter& writer, Stats& stats)
        : candidates_(std::move(candidates)), writer_(writer), stats_(stats) {}

    // Measures on parts of the unfinished picture how long finishing all of it will take, and reserves that time in the
    // session's schedule. Changes to cheaper filters, with a warning, if these would take most of the budget.
    void measure(Session& session);
    // Filters, encodes and writes the picture.
    void finish(LayeredPicture picture, const ExrMetadata& metadata);

  private:
    // Seconds for the whole picture, extrapolated from parts.
    double estimate(const Session& session, double budget);
    double secondsFor(const Session& session, const PixelRegion& part) const;
    const PictureFilters& filters() const { return candidates_.front(); }

    // The last part that was measured, and the estimate by it, seconds.
    struct Measured {
        PixelRegion part{};
        double seconds = 0, estimate = 0;
    };
    Measured last_;
    std::vector<PictureFilters> candidates_;
    PictureWriter& writer_;
    Stats& stats_;
};

}  // namespace drc
