// A render in progress: the scene prepared for rays, the camera and its film, and the schedule of passes. The command
// line and the live view use it, and so can any other program (render_run.h).
#pragma once
#include <memory>

#include "integrators/integrator.h"
#include "render/schedule.h"
#include "transport/environment_guide.h"

namespace drc {

// The parts of a session that serve the next frame of an animation, whose scene is another one.
struct SessionRemains {
    std::unique_ptr<Accel> accel;
    std::shared_ptr<const CellCollection> cells;  // RadianceCells::carry(); null: none
    int maxDepth = 0;                             // PathSettings, on which the cells depend
    float clamp = 0;
};

class Session {
  public:
    // Renders the view of `sensor`, by default the scene's own. The scene must outlive the session, which does not
    // change it: several sessions may share one scene. params are resolved here. stats may be null. start: when the
    // time budget begins. earlier: from the frame before in an animation. Throws Error if parameters contradict each
    // other or the film does not fit into memory.
    Session(const Scene& scene, Sensor sensor, const RenderParams& params, Stats* stats = nullptr,
            Schedule::Clock::time_point start = Schedule::Clock::now(), SessionRemains earlier = {});
    Session(const Scene& scene, const RenderParams& params, Stats* stats = nullptr,
            Schedule::Clock::time_point start = Schedule::Clock::now())
        : Session(scene, scene.sensor, params, stats, start) {}
    ~Session();

    // Runs one pass over the film, or the part of it that can be done until the deadline passes or `cancel` is raised;
    // that part counts. False: the render is done or cancelled. abandon: when raised, the step ends even within a row
    // of pixels, and the film is of no use until the camera is set or moved; to be raised only if that comes next.
    bool step(const CancelToken* cancel = nullptr, const CancelToken* abandon = nullptr);
    // Whether the film has had a pass of each kind that the picture needs.
    bool hasPicture() const { return schedule_.hasPicture(film_->passes(), film_->mapPasses()); }
    // The picture so far, unfiltered. Safe while step runs, from any thread. part: of the film's region.
    LayeredPicture snapshot() const { return integrator_->picture(film_->snapshot()); }
    LayeredPicture snapshot(const PixelRegion& part) const { return integrator_->picture(film_->snapshot(part)); }
    // The beauty of a snapshot, at a fraction of its cost.
    Preview preview() const { return integrator_->preview(*film_); }
    // The picture without copying the film. Not while step runs; valid only until the next step.
    LayeredPicture picture() const;

    // Frees memory that only further steps need, such as radiance cells, so that the filters of the last picture can
    // use it. Afterwards, only pictures, the film and the functions that report progress may be used.
    void endSampling();

    // Changes the camera: the film is cleared and may get another size, the prepared scene stays. Not while other calls
    // run. Throws Error, and changes nothing, if the film does not fit into memory.
    void setCamera(std::shared_ptr<const Camera> camera, const FilmGeometry& film);
    // Like setCamera(), for a camera that looks around in the same room: keeps what was learned about the scene, such
    // as radiance cells. This helps the new picture, which therefore depends on where the camera has been.
    void moveCamera(std::shared_ptr<const Camera> camera, const FilmGeometry& film);

    // Returns what the next frame can use, if more than the camera changes. The session may only be destroyed
    // afterwards.
    SessionRemains takeRemains();

    // Sets RenderParams::firstSample for later films, so that a camera that is visited again gets other samples.
    void setFirstSample(int index) { params_.firstSample = index; }
    // Sets RenderParams::frame, whose samples the next camera gets.
    void setFrame(int number) { params_.frame = number; }
    // Sets RenderParams::cellSize for later calls of setCamera().
    void setCellSize(float size) { params_.cellSize = size; }
    // The radiance cells so far; null if there are none. Not while step runs.
    const RadianceCells* cells() const { return integrator_->cells(); }

    // Once every pixel has a sample, all further samples go to this part of the film's region. None: back to passes
    // over the whole film, which continue where they stopped. Samples of a focus count like all others, and repeat none
    // of them. Setting or moving the camera ends the focus. Not while other calls run. Throws std::out_of_range if the
    // part is empty or not within the region.
    void setFocus(const std::optional<PixelRegion>& focus);
    const std::optional<PixelRegion>& focus() const { return focus_; }
    // Number of samples that each pixel of the present focus has got since setFocus().
    int focusSamples() const { return focusSamples_; }

    // save writes the state of the render to a file, whole or not at all. A session of the same scene and parameters
    // that loads the file ends with the same bits as one that was never stopped. identity: one line that describes
    // scene, camera and settings; it ends the file's first line. load throws Error, and changes nothing, if the file
    // has another identity, integrator or film, or is damaged. Neither may be called while step runs. save throws
    // std::logic_error after focus passes, because the file does not record which samples they took.
    void save(const std::string& path, const std::string& identity) const;
    void load(const std::string& path, const std::string& identity);

    // The film may be saved, loaded and added to while no step runs.
    Film& film() { return *film_; }
    const Film& film() const { return *film_; }
    Schedule& schedule() { return schedule_; }
    // The present camera and its film.
    const Sensor& sensor() const { return sensor_; }
    const RenderParams& params() const { return params_; }
    // The layers of the session's film.
    std::vector<FilmLayerSpec> layers() const;
    // Number of complete samples of each pixel, and of complete map passes.
    int samplesDone() const;
    int mapPassesDone() const { return film_->mapPasses(); }
    // The share of the work, or of the time, that is done, in [0, 1].
    double progress() const { return schedule_.progress(film_->passes(), film_->mapPasses()); }
    // A line for progress displays, for example "direct 12 spp, indirect pass 5".
    std::string status() const;
    const PathTracer& tracer() const { return tracer_; }
    const Accel& accel() const { return accel_; }
    // The median distance of the visible surfaces, world units; 0 if no surface is visible.
    float distance() const { return distance_; }

  private:
    std::string fileHeader(const std::string& identity) const;
    bool samplePass(int index, const CancelToken* cancel, const CancelToken* abandon);
    // Takes a sample of each pixel of the focus.
    bool focusPass(const CancelToken* cancel, const CancelToken* abandon);
    // Takes samples of a pixel, whose row is locked.
    void takeSamples(int x, int y, const PixelSamples& samples);
    void startGuide();
    // Calls f(ray, sampler) for about side x side camera rays all over the picture.
    template <class F>
    void probe(int side, F&& f) const;
    // The median distance of the visible surfaces, world units; 0 if no surface is visible.
    float medianDistance() const;
    // Warns if the picture can only be black.
    void warnIfBlack() const;
    // Throws Error, with the sensor as it was, if the film does not fit into memory.
    void setSensor(std::shared_ptr<const Camera> camera, const FilmGeometry& film);
    // Makes the integrator, the film, and all else that depends on the camera.
    void begin();
    void restart();

    Sensor sensor_;
    RenderParams params_;
    std::unique_ptr<const Scene> ownScene_;  // the scene without its media, if the integrator does not render media
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
    uint32_t focusPasses_ = 0;   // since the camera was set, over all focuses
    size_t waitingSamples_ = 0;  // samples of focus passes since the integrator and the guide last learned
};

}  // namespace drc
