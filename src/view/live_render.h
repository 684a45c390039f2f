// A render that is watched: it goes on in a thread of its own, makes a picture of what it has now and then, and follows
// a camera that is moved.
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

// The error of the denoised picture, as far as it has been estimated.
struct LiveError {
    double whole = 0;  // DenoisedError::whole
    int samples = 0;   // after so many in each pixel
    double slope = 0;  // NoiseThreshold::slope
    Image local;       // DenoisedError::local
};

// A picture of the live view, and the state of the render when it was made.
struct LiveFrame {
    uint64_t number = 0;                     // from 1
    LayeredPicture picture;                  // finished; picture.film has the region alone
    std::shared_ptr<const Camera> camera;    // that took it
    Image unfiltered;                        // beauty before filters
    int samples = 0;                         // complete ones in each pixel
    double share = 0;                        // of the pixels of the first sample, until that is complete; then 1
    double seconds = 0;                      // since the camera was moved last, until it was finished
    uint64_t view = 0;                       // counts the movements of the camera
    int focusSamples = 0;                    // of each pixel of the part that the samples go to, if there is one
    std::string status;                      // as Session::status()
    std::shared_ptr<const LiveError> error;  // the latest estimate; null: there is none yet of this view
};

// A part of the picture, whose width and height are 1 here.
struct PicturePart {
    double x0 = 0, y0 = 0, x1 = 1, y1 = 1;
};

struct LiveState {
    bool paused = false, done = false;
    std::optional<PixelRegion> focus;  // that the samples go to, in pixels of the picture; none: to all of it
    std::string error;                 // of the render, which has ended by it
};

class LiveRender {
  public:
    // finish: applies the filters to a picture. moving: while the camera moves, when time counts most. onFrame: called
    // after each new frame, and when the focus has changed, on the render's thread; by pause(), on its caller's.
    // estimate: of a picture with half buffers that is not filtered; may be empty.
    struct Callbacks {
        std::function<void(LayeredPicture&, bool moving)> finish;
        std::function<void()> onFrame;
        std::function<DenoisedError(const LayeredPicture&)> estimate = {};
        // Is raised when the camera will be moved, so that what finish and estimate are making will not be shown, and
        // they may end early. May be null.
        CancelToken* outdated = nullptr;
    };

    // Begins at once. The session must outlive this object, and is used by nothing else meanwhile.
    LiveRender(Session& session, Callbacks callbacks);
    // Ends it as soon as the present row of pixels is done.
    ~LiveRender();
    LiveRender(const LiveRender&) = delete;
    LiveRender& operator=(const LiveRender&) = delete;

    // The latest frame; null before the first one.
    std::shared_ptr<const LiveFrame> frame() const;
    // Waits until there is a frame later than this one, or the time is over; the latest in any case.
    std::shared_ptr<const LiveFrame> waitForFrame(uint64_t after, std::chrono::milliseconds most) const;
    LiveState state() const;

    // Throws Error if a film of this size does not fit into memory. For setCamera(), which must not be told of such.
    void requireMemory(const FilmGeometry& film) const;
    // While it is paused, a camera that is moved is seen all the same, by a sample of each pixel.
    void pause(bool paused);
    // Renders from another camera, for a film of any size. make: called on the render's thread, and must not throw.
    // moving: another camera will soon follow. The latest of several counts.
    void setCamera(std::function<std::unique_ptr<Camera>()> make, const FilmGeometry& film, bool moving);
    // From now on all samples go to this part, once every pixel has one, until the camera is set; none: to the whole
    // picture. The part has at least a pixel. The latest of several counts.
    void setFocus(const std::optional<PicturePart>& part);
    // Calls f(session) while no step runs, and waits for it.
    void between(const std::function<void(const Session&)>& f);

  private:
    using Clock = std::chrono::steady_clock;
    struct Move {
        std::function<std::unique_ptr<Camera>()> make;
        FilmGeometry film;
        bool moving = false;
    };
    // Moves the camera. lock: of mutex_, which others may have meanwhile.
    void applyMove(Move move, std::unique_lock<std::mutex>& lock);
    void applyFocus(const std::optional<PicturePart>& part);
    void run();
    void work();
    void makeFrame();
    void estimateError(const LayeredPicture& unfiltered);
    // Whether nothing is to be sampled. With mutex_ locked, on the render's thread.
    bool rests() const;
    // Whether a frame would be too late, because the camera will be moved now, or all ends.
    bool isOutdated() const;
    // Whether a frame should be made now, after a step.
    bool isFrameDue() const;

    Session& session_;
    // Copied from the session at first, whose settings change with the camera, on the render's thread.
    const RenderSettings settings_;
    const std::vector<FilmLayerSpec> layers_;
    Callbacks callbacks_;
    CancelToken cancel_;
    CancelToken own_;
    CancelToken& abandon_;  // Callbacks::outdated, if there is one; what is being sampled is of no use either

    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
    std::shared_ptr<const LiveFrame> frame_;
    LiveState state_;
    bool stopping_ = false;
    bool owesFrame_ = false;  // of the present view none has been made yet
    std::optional<Move> move_;
    std::optional<std::optional<PicturePart>> nextFocus_;
    std::vector<const std::function<void(const Session&)>*> calls_;

    // Used by the render's thread.
    uint64_t view_ = 0;
    bool moving_ = false, isCurrent_ = false, movedInPause_ = false;
    int framePasses_ = 0;  // of the film, at the last frame
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
