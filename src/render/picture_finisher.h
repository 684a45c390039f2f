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
    // candidates: the wanted filters, then cheaper ones for when time is short; not empty. estimateError: whether
    // finish() also estimates the picture's error, which triples the time of the filters. stats may be null. All
    // arguments but the first must outlive this object.
    PictureFinisher(std::vector<PictureFilters> candidates, PictureWriter& writer, Stats* stats = nullptr,
                    bool estimateError = false)
        : candidates_(std::move(candidates)), writer_(writer), stats_(stats), estimateError_(estimateError) {}

    // Measures on parts of the unfinished picture how long finishing all of it will take, and reserves that time in the
    // session's schedule. Changes to cheaper filters if these would take too much of the budget, with a warning if they
    // were asked for. besides: seconds for other work at the end, such as a checkpoint.
    void measure(Session& session, double besides = 0);
    // The estimated error of the unfinished picture if it were finished now.
    DenoisedError errorOf(const LayeredPicture& picture) const;
    // Filters, encodes and writes the picture; adds the denoiser's name and the error to the metadata. Returns the
    // finished picture.
    LayeredPicture finish(LayeredPicture picture, ExrMetadata metadata = {});

  private:
    // Seconds for the whole picture, extrapolated from parts.
    double estimate(const Session& session, double budget);
    double secondsFor(const Session& session, const PixelRegion& part) const;
    const PictureFilters& filters() const { return candidates_.front(); }
    void filter(LayeredPicture& picture) const;
    // Estimates the error if it is wanted, then filters.
    void apply(LayeredPicture& picture, ExrMetadata& metadata) const;
    // Replaces the filters by the next candidate.
    void useCheaper();

    // The last part that was measured, the seconds it took, and the estimate for the whole picture, in seconds.
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
