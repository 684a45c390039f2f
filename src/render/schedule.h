// What a render does next, and until when: the only place that knows time. Without a budget of time, as many passes as
// were asked for; with one, passes until what is left is needed to finish: to filter, encode and write the picture.
#pragma once
#include <chrono>
#include <optional>

#include "render/render_params.h"

namespace drc {

class Schedule {
  public:
    using Clock = std::chrono::steady_clock;

    // params: resolved. start: from when on the budget counts. filmHeight: pixels, of the whole frame.
    Schedule(const RenderParams& params, Clock::time_point start, int filmHeight, size_t pixels);

    struct Work {
        enum class Kind { Samples, Maps } kind;
        int index = 0;      // of the sample pass (SamplePass) or of the map pass
        float spacing = 0;  // of the maps, pixels
        int stride = 1;     // of the lattice of pixels that the maps light
    };
    // What comes next, if so many passes are done; none: nothing.
    std::optional<Work> next(int samplePasses, int mapPasses) const;
    // Whether there is one of all that makes up a picture.
    bool hasPicture(int samplePasses, int mapPasses) const { return samplePasses > 0 && (!maps_ || mapPasses > 0); }
    // Takes note of what work took. whole: it was not cancelled.
    void finished(const Work& work, Clock::duration took, bool whole);

    // When passes have to end. None: no budget.
    std::optional<Clock::time_point> deadline() const;
    // Sets aside time before the end of the budget. Measured, while rendering, by whoever finishes pictures.
    void reserve(double seconds) { reserved_ = seconds; }
    double reserved() const { return reserved_; }
    // When the time is right to measure it: as soon as there is a picture, and once more later, as machines get busy.
    bool wantsReserve(int samplePasses, int mapPasses) const;
    void reserveMeasured() { ++measured_; }
    // Of the whole budget, seconds; infinity without one.
    double budget() const;
    double secondsLeft() const;

    // Share of the work, or of the time, that is done: in [0, 1].
    double progress(int samplePasses, int mapPasses) const;

  private:
    // Before a deadline: the spacing of the next map pass, from what the last one cost. 0: there is no time for one.
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
