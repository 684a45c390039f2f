// A render that is watched: it runs on a thread of its own, makes a picture of its progress now and then, and follows a
// moving camera.
#pragma once
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "reconstruct/denoised_error.h"
#include "reconstruct/noise_threshold.h"
#include "render/session.h"

namespace drc {

// The latest estimate of the error of the denoised picture.
struct LiveError {
    double whole = 0;  // DenoisedError::whole
    int samples = 0;   // samples of each pixel at the time of the estimate
    double slope = 0;  // NoiseThreshold::slope
    Image local;       // DenoisedError::local
};

// A picture of the live view, and the state of the render when it was made.
struct LiveFrame {
    uint64_t number = 0;                     // from 1
    LayeredPicture picture;                  // finished; picture.film contains only the region
    std::shared_ptr<const Camera> camera;    // camera of this picture
    Image unfiltered;                        // beauty before filters
    int samples = 0;                         // complete samples of each pixel
    double share = 0;                        // share of the pixels that have their first sample
    double seconds = 0;                      // time from the last camera move until the picture was finished
    uint64_t view = 0;                       // number of camera moves so far
    int focusSamples = 0;                    // samples of each pixel of the focus, if there is a focus
    std::string status;                      // as Session::status()
    std::shared_ptr<const LiveError> error;  // the latest estimate for this view; null: none yet
};

// A part of the picture, in units of the picture's width and height. y down.
struct PicturePart {
    double x0 = 0, y0 = 0, x1 = 1, y1 = 1;
};

struct LiveState {
    bool paused = false, done = false;
    std::optional<PixelRegion> focus;  // part that all samples go to, in pixels of the picture; none: the whole picture
    std::string error;                 // message of the error that has ended the render
};

class LiveRender {
  public:
    // finish: applies the filters to a picture. moving: whether the camera moves, so that time counts most. onFrame:
    // called after each new frame, and when the focus has changed, on the render's thread; by pause(), on the caller's
    // thread. estimate: estimates the error of an unfiltered picture with half buffers; may be empty.
    struct Callbacks {
        std::function<void(LayeredPicture&, bool moving)> finish;
        std::function<void()> onFrame;
        std::function<DenoisedError(const LayeredPicture&)> estimate = {};
        // Raised when the camera is about to move: the results of finish and estimate will not be shown, so these may
        // end early. May be null.
        CancelToken* outdated = nullptr;
    };

    // Begins at once. The session must outlive this object, and nothing else may use it meanwhile.
    LiveRender(Session& session, Callbacks callbacks);
    // Ends the render as soon as the pixels in progress are done, even within a row.
    ~LiveRender();
    LiveRender(const LiveRender&) = delete;
    LiveRender& operator=(const LiveRender&) = delete;

    // The latest frame; null before the first one.
    std::shared_ptr<const LiveFrame> frame() const;
    // Waits for a frame with a number above `after`, for at most `most`. Returns the latest frame in any case.
    std::shared_ptr<const LiveFrame> waitForFrame(uint64_t after, std::chrono::milliseconds most) const;
    LiveState state() const;

    // Throws Error if a film of this size does not fit into memory. To be called before setCamera(), which needs one
    // that does.
    void requireMemory(const FilmGeometry& film) const;
    // Pauses or continues the render. A camera that is moved during a pause still gets a sample of each pixel.
    void pause(bool paused);
    // Renders from another camera, for a film of any size. make: called on the render's thread, and must not throw.
    // moving: another camera will soon follow. Only the latest of several calls counts.
    void setCamera(std::function<std::unique_ptr<Camera>()> make, const FilmGeometry& film, bool moving);
    // Once every pixel has a sample, all further samples go to this part, until the camera is set; none: to the whole
    // picture. The part is enlarged to at least one pixel. Only the latest of several calls counts.
    void setFocus(const std::optional<PicturePart>& part);
    // Runs f(session) while no step runs, and waits until it has returned.
    void between(const std::function<void(const Session&)>& f);

  private:
    using Clock = std::chrono::steady_clock;
    struct Move {
        std::function<std::unique_ptr<Camera>()> make;
        FilmGeometry film;
        bool moving = false;
    };
    // Moves the camera. lock: of mutex_, which is released meanwhile.
    void applyMove(Move move, std::unique_lock<std::mutex>& lock);
    void applyFocus(const std::optional<PicturePart>& part);
    void run();
    void work();
    void makeFrame();
    void estimateError(const LayeredPicture& unfiltered);
    // Whether there is nothing to sample. Called with mutex_ locked, on the render's thread.
    bool rests() const;
    // Whether a frame would come too late, because the camera is about to move or the render ends.
    bool isOutdated() const;
    // Whether a frame should be made now, after a step.
    bool isFrameDue() const;

    Session& session_;
    // Copies of the session's initial settings, for other threads: the session's own change with the camera, on the
    // render's thread.
    const RenderSettings settings_;
    const std::vector<FilmLayerSpec> layers_;
    Callbacks callbacks_;
    CancelToken cancel_;
    CancelToken own_;
    CancelToken& abandon_;  // Callbacks::outdated, if there is one; also abandons the samples in progress

    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
    std::shared_ptr<const LiveFrame> frame_;
    LiveState state_;
    bool stopping_ = false;
    bool owesFrame_ = false;  // whether no frame of the present view has been made yet
    std::optional<Move> move_;
    std::optional<std::optional<PicturePart>> nextFocus_;
    std::vector<const std::function<void(const Session&)>*> calls_;

    // Used by the render's thread only.
    uint64_t view_ = 0;
    bool moving_ = false, isCurrent_ = false, movedInPause_ = false;
    int framePasses_ = 0;  // passes of the film at the last frame
    Clock::time_point began_ = Clock::now(), lastFrame_{};
    Clock::duration frameTook_{};
    // Estimates of the error of the present view.
    std::shared_ptr<const LiveError> error_;
    NoiseThreshold errors_{0};
    Clock::time_point lastEstimate_{};
    Clock::duration estimateTook_{};
    std::thread thread_;
};

}  // namespace drc
