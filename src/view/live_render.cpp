#include "view/live_render.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/log.h"
#include "film/sample_pass.h"

namespace drc {
namespace {

// Frames take at most this share of the time, after the first sample of the pixels.
constexpr double kShareOfFrames = 0.2;
// Estimates of the error take at most this share of the time.
constexpr double kShareOfEstimates = 0.1;
// Least time between two frames: more frames a second are of no use.
constexpr std::chrono::milliseconds kLeastInterval{150};

}  // namespace

LiveRender::LiveRender(Session& session, Callbacks callbacks)
    : session_(session),
      settings_(session.sensor().settings),
      layers_(session.layers()),
      callbacks_(std::move(callbacks)),
      abandon_(callbacks_.outdated ? *callbacks_.outdated : own_),
      thread_([this] { run(); }) {}

LiveRender::~LiveRender() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
        abandon_.cancel();
        cancel_.cancel();
    }
    changed_.notify_all();
    thread_.join();
}

std::shared_ptr<const LiveFrame> LiveRender::frame() const {
    const std::lock_guard lock(mutex_);
    return frame_;
}

std::shared_ptr<const LiveFrame> LiveRender::waitForFrame(uint64_t after, std::chrono::milliseconds most) const {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, most,
                      [&] { return stopping_ || !state_.error.empty() || (frame_ && frame_->number > after); });
    return frame_;
}

LiveState LiveRender::state() const {
    const std::lock_guard lock(mutex_);
    return state_;
}

void LiveRender::pause(bool paused) {
    {
        const std::lock_guard lock(mutex_);
        state_.paused = paused;
        if (paused) cancel_.cancel();
    }
    changed_.notify_all();
    // A resting render makes no frames, so listeners are told of the change here.
    if (callbacks_.onFrame) callbacks_.onFrame();
}

void LiveRender::setCamera(std::function<std::unique_ptr<Camera>()> make, const FilmGeometry& film, bool moving) {
    {
        const std::lock_guard lock(mutex_);
        move_ = Move{std::move(make), film, moving};
        nextFocus_.reset();
        // Otherwise a camera that moves all the time would never get a frame.
        if (!owesFrame_) {
            abandon_.cancel();
            cancel_.cancel();
        }
    }
    changed_.notify_all();
}

void LiveRender::setFocus(const std::optional<PicturePart>& part) {
    {
        const std::lock_guard lock(mutex_);
        nextFocus_ = part;
        cancel_.cancel();
    }
    changed_.notify_all();
}

void LiveRender::between(const std::function<void(const Session&)>& f) {
    std::unique_lock lock(mutex_);
    if (!state_.error.empty() || stopping_) return f(session_);
    calls_.push_back(&f);
    cancel_.cancel();
    changed_.notify_all();
    changed_.wait(lock, [&] { return std::ranges::find(calls_, &f) == calls_.end(); });
}

void LiveRender::run() {
    try {
        work();
    } catch (const std::exception& error) {
        logError(error.what());
        const std::lock_guard lock(mutex_);
        state_.error = error.what();
    }
    const std::lock_guard lock(mutex_);
    for (const auto* call : calls_) (*call)(session_);
    calls_.clear();
    changed_.notify_all();
}

void LiveRender::work() {
    for (;;) {
        {
            std::unique_lock lock(mutex_);
            for (;;) {
                // A cancelled pass keeps its samples, and continues later.
                cancel_.reset();
                abandon_.reset();
                if (stopping_) return;
                // Moves come first, because a pass may have been abandoned for one.
                if (move_) {
                    Move move = std::move(*move_);
                    move_.reset();
                    applyMove(std::move(move), lock);
                    continue;
                }
                if (nextFocus_) {
                    applyFocus(*nextFocus_);
                    nextFocus_.reset();
                    lock.unlock();
                    if (callbacks_.onFrame) callbacks_.onFrame();
                    lock.lock();
                    continue;
                }
                if (!calls_.empty()) {
                    for (const auto* call : calls_) (*call)(session_);
                    calls_.clear();
                    changed_.notify_all();
                }
                // Show all samples taken so far before the render rests.
                if (!rests() || (!isCurrent_ && session_.hasPicture())) break;
                changed_.wait(lock, [&] { return stopping_ || move_ || nextFocus_ || !calls_.empty() || !rests(); });
            }
        }
        bool isResting = false;
        {
            const std::lock_guard lock(mutex_);
            isResting = rests();
        }
        if (!isResting) {
            const bool whole = session_.step(&cancel_, &abandon_);
            isCurrent_ = false;
            if (!whole && !cancel_.cancelled()) {
                const std::lock_guard lock(mutex_);
                state_.done = true;
                isResting = true;
            }
            if (cancel_.cancelled()) continue;
        }
        if (session_.hasPicture() && (isResting || isFrameDue())) makeFrame();
    }
}

void LiveRender::applyMove(Move move, std::unique_lock<std::mutex>& lock) {
    owesFrame_ = true;
    lock.unlock();
    try {
        session_.moveCamera(move.make(), move.film);
    } catch (const Error& error) {
        // Memory has become short since requireMemory(). The samples in progress have been abandoned, so the picture of
        // the present camera starts anew.
        logError(error.what());
        move = {.make = {}, .film = session_.sensor().settings.film, .moving = false};
        session_.moveCamera(session_.sensor().camera, move.film);
    }
    lock.lock();
    moving_ = move.moving;
    movedInPause_ = state_.paused;
    state_.done = false;
    state_.focus.reset();
    isCurrent_ = false;
    error_ = nullptr;
    errors_ = NoiseThreshold(0);
    framePasses_ = 0;
    ++view_;
    began_ = Clock::now();
}

void LiveRender::requireMemory(const FilmGeometry& film) const {
    RenderSettings settings = settings_;
    settings.film = film;
    Film::requireMemory(settings, layers_);
}

void LiveRender::applyFocus(const std::optional<PicturePart>& part) {
    // Even a picture that has all its samples gets more in a focus.
    state_.done = false;
    state_.focus.reset();
    if (!part) return session_.setFocus({});
    const PixelRegion& film = session_.film().region();
    const auto pixels = [](double from, double to, int size) {
        const int begin = std::clamp(int(std::lround(from * size)), 0, size - 1);
        return std::pair(begin, std::clamp(int(std::lround(to * size)), begin + 1, size));
    };
    const auto [x0, x1] = pixels(part->x0, part->x1, film.width());
    const auto [y0, y1] = pixels(part->y0, part->y1, film.height());
    session_.setFocus(PixelRegion{film.x0 + x0, film.y0 + y0, film.x0 + x1, film.y0 + y1});
    state_.focus = PixelRegion{x0, y0, x1, y1};
}

bool LiveRender::rests() const {
    return state_.done || (state_.paused && !(movedInPause_ && session_.samplesDone() == 0));
}

bool LiveRender::isOutdated() const {
    const std::lock_guard lock(mutex_);
    return stopping_ || (move_ && !owesFrame_);
}

bool LiveRender::isFrameDue() const {
    const int passes = session_.film().passes();
    const auto since = Clock::now() - lastFrame_;
    // The first sample of the pixels comes in passes over lattices, and each of these passes is shown.
    if (passes <= SamplePass::kLattices && passes != framePasses_) return true;
    return since >= kLeastInterval &&
           std::chrono::duration<double>(since) >= std::chrono::duration<double>(frameTook_) / kShareOfFrames;
}

void LiveRender::estimateError(const LayeredPicture& unfiltered) {
    const int samples = session_.samplesDone();
    if (!callbacks_.estimate || moving_ || samples < NoiseThreshold::kFirst || (error_ && error_->samples == samples))
        return;
    const auto start = Clock::now();
    if (error_ && std::chrono::duration<double>(start - lastEstimate_) < estimateTook_ / kShareOfEstimates) return;
    DenoisedError error = callbacks_.estimate(unfiltered);
    if (isOutdated()) return;
    lastEstimate_ = Clock::now();
    estimateTook_ = lastEstimate_ - start;
    if (!std::isfinite(error.whole)) return;
    errors_.estimated(samples, error.whole);
    error_ =
        std::make_shared<const LiveError>(LiveError{error.whole, samples, errors_.slope(), std::move(error.local)});
}

void LiveRender::makeFrame() {
    const auto start = Clock::now();
    auto next = std::make_shared<LiveFrame>();
    // The film is not copied: no step runs until the frame is finished.
    next->picture = session_.picture();
    if (isOutdated()) return;
    next->camera = session_.sensor().camera;
    next->unfiltered = next->picture.beauty;
    estimateError(next->picture);
    if (isOutdated()) return;
    next->error = error_;
    callbacks_.finish(next->picture, moving_);
    if (isOutdated()) return;
    next->picture.film = std::make_shared<const Film>(session_.sensor().settings, std::vector<FilmLayerSpec>());
    next->samples = session_.samplesDone();
    next->focusSamples = session_.focusSamples();
    const int passes = session_.film().passes();
    next->share = passes >= SamplePass::kLattices ? 1 : passes == 2 ? 0.25 : 0.0625;
    next->seconds = std::chrono::duration<double>(Clock::now() - began_).count();
    next->view = view_;
    next->status = session_.status();
    frameTook_ = Clock::now() - start;
    lastFrame_ = Clock::now();
    framePasses_ = passes;
    isCurrent_ = true;
    {
        const std::lock_guard lock(mutex_);
        next->number = frame_ ? frame_->number + 1 : 1;
        owesFrame_ = false;
        frame_ = std::move(next);
    }
    changed_.notify_all();
    if (callbacks_.onFrame) callbacks_.onFrame();
}

}  // namespace drc
