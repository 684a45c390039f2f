// A render that goes on for as long as it is let: a prepared scene, the film of what was found out so far, and the
// schedule of what comes next. Command line, live view and other programs are its callers.
#pragma once
#include <memory>

#include "integrators/environment_guide.h"
#include "render/integrator.h"
#include "render/schedule.h"

namespace drc {

class Session {
  public:
    // The scene must outlive the session. params: resolved here. mapDenoiser: for integrators with radiance maps alone.
    // stats may be null. start: from when on the budget of time counts. Throws Error on parameters that contradict each
    // other, and if there is not enough memory for the film.
    Session(Scene& scene, const RenderParams& params, std::shared_ptr<const MapDenoiser> mapDenoiser, Stats* stats,
            Schedule::Clock::time_point start = Schedule::Clock::now());
    ~Session();

    // One pass over the film, or what of it could be done until the time was up or `cancel` was raised: what was done
    // counts. False: there is nothing left to do, or it was cancelled.
    bool step(const CancelToken* cancel = nullptr);
    // Whether every part of the picture has some light already.
    bool hasPicture() const { return schedule_.hasPicture(film_->passes(), film_->mapPasses); }
    // The picture so far, unfiltered. Safe beside step, from any thread. part: of the film's region.
    LayeredPicture snapshot() const { return integrator_->picture(film_->snapshot()); }
    LayeredPicture snapshot(const PixelRegion& part) const { return integrator_->picture(film_->snapshot(part)); }
    // The same without copying the film: not beside step, and only until the next one.
    LayeredPicture picture() const;

    // Looks at the same scene from elsewhere: the film is cleared and may have another size, the prepared scene stays.
    // Not beside other calls.
    void setCamera(std::unique_ptr<Camera> camera, const FilmGeometry& film);

    // To be saved, loaded and added to while no step is under way.
    Film& film() { return *film_; }
    const Film& film() const { return *film_; }
    Schedule& schedule() { return schedule_; }
    const RenderParams& params() const { return params_; }
    // Whole samples a pixel, and whole passes of maps.
    int samplesDone() const;
    int mapPassesDone() const { return film_->mapPasses; }
    // Of the work, or of the time: in [0, 1].
    double progress() const { return schedule_.progress(film_->passes(), film_->mapPasses); }
    // "direct 12 spp, indirect pass 5".
    std::string status() const;
    const PathTracer& tracer() const { return tracer_; }
    const Accel& accel() const { return accel_; }

  private:
    bool samplePass(int index, const CancelToken* cancel);
    void startGuide();
    // The film, and what depends on the camera.
    void begin();

    Scene& scene_;
    RenderParams params_;
    Accel accel_;
    LightSampler lights_;
    PathTracer tracer_;
    std::optional<EnvironmentGuide> guide_;  // none: there is no environment to learn about
    std::shared_ptr<const MapDenoiser> mapDenoiser_;
    Stats* stats_;
    std::unique_ptr<Integrator> integrator_;
    std::unique_ptr<Film> film_;
    Schedule schedule_;
};

}  // namespace drc
