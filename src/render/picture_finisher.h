// Turns the film into files: filters, encodes and writes the picture, and measures during the render how long that will
// take.
#pragma once
#include <memory>

#include "reconstruct/denoised_error.h"
#include "render/picture_filters.h"
#include "render/picture_writer.h"
#include "render/session.h"

namespace drc {

class PictureFinisher {
  public:
    // candidates: the wanted filters, then cheaper ones for when there is no time for these; not empty.
    // estimateError: whether finish() tells the error of the picture, which triples the time that its filters take.
    // stats may be null. All arguments but the first must outlive this object.
    PictureFinisher(std::vector<PictureFilters> candidates, PictureWriter& writer, Stats* stats = nullptr,
                    bool estimateError = false)
        : candidates_(std::move(candidates)), writer_(writer), stats_(stats), estimateError_(estimateError) {}

    // Measures on parts of the unfinished picture how long finishing all of it will take, and reserves that time in the
    // session's schedule. Changes to cheaper filters if these would take too much of the budget, with a warning if they
    // were asked for. besides: the seconds that something else takes at the end, such as a checkpoint.
    void measure(Session& session, double besides = 0);
    // The error that the unfinished picture would have if it were finished now.
    DenoisedError errorOf(const LayeredPicture& picture) const;
    // Filters, encodes and writes the picture; adds to the metadata what filtered it, and its error. Returns what was
    // written.
    LayeredPicture finish(LayeredPicture picture, ExrMetadata metadata = {});

  private:
    // Seconds for the whole picture, extrapolated from parts.
    double estimate(const Session& session, double budget);
    double secondsFor(const Session& session, const PixelRegion& part) const;
    const PictureFilters& filters() const { return candidates_.front(); }
    void filter(LayeredPicture& picture) const;
    // Estimates the error if it is wanted, then filters.
    void apply(LayeredPicture& picture, ExrMetadata& metadata) const;
    // Goes on to the next candidate.
    void useCheaper();

    // The last part that was measured, and the estimate by it, seconds.
    struct Measured {
        PixelRegion part{};
        double seconds = 0, estimate = 0;
    };
    Measured last_;
    std::vector<PictureFilters> candidates_;
    PictureWriter& writer_;
    Stats* stats_;
    const bool estimateError_;
};

}  // namespace drc
