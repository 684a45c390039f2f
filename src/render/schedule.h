// Decides which pass a render runs next, and when it ends; no other code decides by the time. Without a time budget it
// runs as many passes as were asked for. With a budget it runs at most these, until the rest of the time is needed to
// filter, encode and write the picture.
#pragma once
#include <chrono>
#include <optional>

#include "integrators/render_params.h"

namespace drc {

class Schedule {
  public:
    using Clock = std::chrono::steady_clock;

    // params: resolved. start: when the budget begins. filmHeight: of the whole film, pixels. pixels: number of pixels
    // that are rendered.
    Schedule(const RenderParams& params, Clock::time_point start, int filmHeight, size_t pixels);

    struct Work {
        enum class Kind { Samples, Maps } kind;
        int index = 0;      // of the sample pass (SamplePass) or map pass
        float spacing = 0;  // of the maps, in pixels
        int stride = 1;     // of the lattice of pixels that the maps light
    };
    // The next pass, after these numbers of complete passes; none if the render is done.
    std::optional<Work> next(int samplePasses, int mapPasses) const;
    // Whether there has been a pass of each kind that the picture needs.
    bool hasPicture(int samplePasses, int mapPasses) const {
        const bool wantsMaps = maps_ && *params_.mapPasses > 0;
        return samplePasses > 0 && (!wantsMaps || mapPasses > 0);
    }
    // Records the time that a pass took. whole: the pass was not cancelled.
    void finished(const Work& work, Clock::duration took, bool whole);

    // When passes must end; none without a budget.
    std::optional<Clock::time_point> deadline() const;
    // Sets aside time at the end of the budget to finish the picture. PictureFinisher measures that time during the
    // render.
    void reserve(double seconds) { reserved_ = seconds; }
    double reserved() const { return reserved_; }
    // Whether the time to reserve should be measured now: as soon as there is a picture, and once more later, because
    // the load of a machine changes.
    bool wantsReserve(int samplePasses, int mapPasses) const;
    void reserveMeasured() { ++measured_; }
    // The whole budget and the rest of it, in seconds; infinity without a budget.
    double budget() const;
    double secondsLeft() const;

    // The share of the work, or of the time, that is done, in [0, 1].
    double progress(int samplePasses, int mapPasses) const;

  private:
    // The estimated time for a map pass to light all pixels, without capturing its maps.
    double gatherSeconds() const;
    // With a deadline: the spacing of the next map pass in pixels, from the cost of the last one. 0: there is no time
    // for another pass.
    float spacingInTime(int mapPasses) const;

    RenderParams params_;
    bool maps_;
    Clock::time_point start_;
    std::optional<Clock::time_point> end_;
    int filmHeight_;
    double pixels_;
    double reserved_ = 0;
    int measured_ = 0;
    double sampleSeconds_ = 0, mapSeconds_ = 0;
    double lastMapSeconds_ = 0, secondsPerSample_ = 0;
    float lastSpacing_ = 0;
};

}  // namespace drc
