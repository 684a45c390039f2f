// A render in progress: the scene prepared for rays, the camera and its film, and the schedule of passes. The command
// line and the live view are callers of it, and so can be any other program (render_run.h).
#pragma once
#include <memory>

#include "integrators/integrator.h"
#include "render/schedule.h"
#include "transport/environment_guide.h"

namespace drc {

class Session {
  public:
    // Renders what `sensor` sees; without it, what the scene's own sees. The scene must outlive the session, which does
    // not change it: several sessions may share one. params are resolved here. stats may be null. start: when the time
    // budget begins. Throws Error if parameters contradict each other or the film does not fit into memory.
    Session(const Scene& scene, Sensor sensor, const RenderParams& params, Stats* stats = nullptr,
            Schedule::Clock::time_point start = Schedule::Clock::now());
    Session(const Scene& scene, const RenderParams& params, Stats* stats = nullptr,
            Schedule::Clock::time_point start = Schedule::Clock::now())
        : Session(scene, scene.sensor, params, stats, start) {}
    ~Session();

    // Runs one pass over the film, or the part of it that could be done until the deadline passed or `cancel` was
    // raised; that part counts. False: the render is done, or it was cancelled. abandon: when raised, the step ends
    // even within a row of pixels, and the film is of no use until the camera has been set or moved; for when that is
    // what comes next.
    bool step(const CancelToken* cancel = nullptr, const CancelToken* abandon = nullptr);
    // Whether every layer of the picture has some light already.
    bool hasPicture() const { return schedule_.hasPicture(film_->passes(), film_->mapPasses()); }
    // The picture so far, unfiltered. Safe while step runs, from any thread. part: of the film's region.
    LayeredPicture snapshot() const { return integrator_->picture(film_->snapshot()); }
    LayeredPicture snapshot(const PixelRegion& part) const { return integrator_->picture(film_->snapshot(part)); }
    // The beauty of a snapshot, at a fraction of its price.
    Preview preview() const { return integrator_->preview(*film_); }
    // The picture without copying the film: not while step runs, and valid only until the next step.
    LayeredPicture picture() const;

    // Frees the memory that only further steps need, such as radiance cells, for the filters of the last picture. Only
    // pictures, figures and the film may be asked for afterwards.
    void endSampling();

    // Changes the camera: the film is cleared and may have another size, the prepared scene stays. Not while other
    // calls run. Throws Error, with all as it was, if the film does not fit into memory.
    void setCamera(std::shared_ptr<const Camera> camera, const FilmGeometry& film);
    // Like setCamera(), for a camera that looks around in the same room: keeps what was learned about the scene, such
    // as radiance cells. This helps the new picture, which therefore depends on where the camera has been.
    void moveCamera(std::shared_ptr<const Camera> camera, const FilmGeometry& film);

    // The index of the first sample of each pixel in later films, RenderParams::firstSample: for cameras that are
    // visited more than once, and are to have other samples each time.
    void setFirstSample(int index) { params_.firstSample = index; }
    // RenderParams::cellSize for the cells of cameras that are set from now on.
    void setCellSize(float size) { params_.cellSize = size; }
    // The radiance cells so far; null if there are none. Not while step runs.
    const RadianceCells* cells() const { return integrator_->cells(); }

    // Once every pixel has a sample, all further ones go to this part of the film's region, none: to whole passes,
    // which go on where they stopped. The samples count as any other, and are different ones. Setting or moving the
    // camera ends it. Not while other calls run. Throws std::out_of_range if the part is empty or not within the
    // region.
    void setFocus(const std::optional<PixelRegion>& focus);
    const std::optional<PixelRegion>& focus() const { return focus_; }
    // Samples of each of its pixels that have been taken for the present focus.
    int focusSamples() const { return focusSamples_; }

    // Writes all that the render has found out to a file, whole or not at all, and goes on from there: a session of the
    // same scene and parameters that has loaded the file ends with the same bits as one that was never stopped.
    // identity: describes scene, camera and settings, in one line, which the file's first line ends with. load throws
    // Error, and changes nothing, if the file is of another identity, integrator or film, or if it is damaged. Not
    // while step runs. The file does not tell which samples a focus has taken: save throws std::logic_error if there
    // are such.
    void save(const std::string& path, const std::string& identity) const;
    void load(const std::string& path, const std::string& identity);

    // May be saved, loaded and added to while no step runs.
    Film& film() { return *film_; }
    const Film& film() const { return *film_; }
    Schedule& schedule() { return schedule_; }
    // The present camera and its film.
    const Sensor& sensor() const { return sensor_; }
    const RenderParams& params() const { return params_; }
    // The layers of its film.
    std::vector<FilmLayerSpec> layers() const;
    // Complete samples a pixel, and complete map passes.
    int samplesDone() const;
    int mapPassesDone() const { return film_->mapPasses(); }
    // The share of the work, or of the time, that is done, in [0, 1].
    double progress() const { return schedule_.progress(film_->passes(), film_->mapPasses()); }
    // A line for progress displays, as "direct 12 spp, indirect pass 5".
    std::string status() const;
    const PathTracer& tracer() const { return tracer_; }
    const Accel& accel() const { return accel_; }
    // The median distance that the picture shows, world units; 0 if it shows no surface.
    float distance() const { return distance_; }

  private:
    std::string fileHeader(const std::string& identity) const;
    bool samplePass(int index, const CancelToken* cancel, const CancelToken* abandon);
    // A sample of each pixel of the focus.
    bool focusPass(const CancelToken* cancel, const CancelToken* abandon);
    // Takes samples of a pixel, whose row is locked.
    void takeSamples(int x, int y, const PixelSamples& samples);
    void startGuide();
    // Calls f(ray, sampler) for about side x side camera rays all over the picture.
    template <class F>
    void probe(int side, F&& f) const;
    // The median distance that the picture shows, world units; 0 if it shows no surface.
    float medianDistance() const;
    // Warns of pictures that can only be black.
    void warnIfBlack() const;
    // Throws Error, with the sensor as it was, if the film does not fit into memory.
    void setSensor(std::shared_ptr<const Camera> camera, const FilmGeometry& film);
    // Makes the integrator, the film, and all else that depends on the camera.
    void begin();
    void restart();

    Sensor sensor_;
    RenderParams params_;
    std::unique_ptr<const Scene> ownScene_;  // without media, if the integrator does not render those of the scene
    const Scene& scene_;
    Accel accel_;
    LightSampler lights_;
    PathTracer tracer_;
    float distance_ = 0;                     // medianDistance()
    std::optional<EnvironmentGuide> guide_;  // none: there is no environment light to guide
    Stats* stats_;
    std::unique_ptr<Integrator> integrator_;
    std::unique_ptr<Film> film_;
    Schedule schedule_;
    std::optional<PixelRegion> focus_;
    int focusSamples_ = 0;
    uint32_t focusPasses_ = 0;   // of this film, for any focus
    size_t waitingSamples_ = 0;  // of focus passes, that nothing has been learnt from yet
};

}  // namespace drc
