#include "view/tev_display.h"

#include <fmt/core.h>

#include <algorithm>
#include <ctime>
#include <new>

#include "base/checksum.h"
#include "base/log.h"
#include "base/parallel.h"
#include "view/tev_packets.h"

namespace drc {
namespace {

// The share of all threads' time that pictures of each extent may take.
constexpr double kShare = 0.025;
// Number of intervals before all layers are taken for the first time.
constexpr int kUntilAll = 5;
// Time limit for connecting to a host.
constexpr std::chrono::seconds kConnect{5};

// Processor time of this thread, in seconds: waiting for the viewer costs the render nothing.
double secondsOfThread() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + double(time.tv_nsec) * 1e-9;
}

uint64_t sumOf(const std::vector<float>& values) {
    return checksum({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)});
}

}  // namespace

TevDisplay::TevDisplay(TevSettings settings, tev::Picture outline, std::function<tev::Picture(Extent)> take)
    : settings_(std::move(settings)),
      outline_(std::move(outline)),
      take_(std::move(take)),
      thread_([this] { run(); }) {}

TevDisplay::~TevDisplay() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    wake_.notify_all();
    if (thread_.joinable()) thread_.join();
}

void TevDisplay::stopTaking() {
    const std::lock_guard lock(takeMutex_);
    take_ = nullptr;
}

void TevDisplay::finish(tev::Picture picture) {
    {
        const std::lock_guard lock(mutex_);
        last_ = std::move(picture);
        lastSince_ = Clock::now();
    }
    wake_.notify_all();
    thread_.join();
}

void TevDisplay::run() {
    try {
        work();
    } catch (const std::bad_alloc&) {
        complain("there is not enough memory for its pictures");
    } catch (const std::exception& error) {
        complain(error.what());
    }
    sender_.reset();
}

void TevDisplay::work() {
    auto due = Clock::now() + settings_.interval / 4, allDue = Clock::now() + kUntilAll * settings_.interval;
    for (;;) {
        const Next next = waitUntil(due);
        if (next == Next::End) return;
        if (next == Next::Last) return showLast();
        const double began = secondsOfThread();
        try {
            connect();
            if (creation_.empty()) makeImage(outline_);
            const Extent extent = Clock::now() >= allDue ? Extent::All : Extent::Beauty;
            const std::optional<tev::Picture> picture = taken(extent);
            if (!picture) {
                due = Clock::time_point::max();
                continue;
            }
            const double made = secondsOfThread() - began;
            show(*picture);
            const double took = secondsOfThread() - began;
            const bool all = extent == Extent::All;
            logDebug(fmt::format("--display-server: to take {} took {:.3f} s, to send it {:.3f} s",
                                 all ? "all layers" : "the beauty", made, took - made));
            const std::chrono::duration<double> rest(took / (kShare * threadCount()));
            const auto again =
                Clock::now() +
                std::max<Clock::duration>(settings_.interval, std::chrono::duration_cast<Clock::duration>(rest));
            (all ? allDue : due) = again;
            if (all) due = Clock::now() + settings_.interval;
        } catch (const StreamSender::GaveUp&) {
            throw;
        } catch (const Error& error) {
            complain(error.what());
            sender_.reset();
            due = Clock::now() + settings_.retry;
        }
    }
}

TevDisplay::Next TevDisplay::waitUntil(Clock::time_point due) {
    std::unique_lock lock(mutex_);
    wake_.wait_until(lock, due, [&] { return ending_ || last_; });
    return ending_ ? Next::End : last_ ? Next::Last : Next::Take;
}

std::optional<tev::Picture> TevDisplay::taken(Extent extent) {
    const std::lock_guard lock(takeMutex_);
    std::optional<tev::Picture> picture;
    if (take_) onThisThread([&] { picture = take_(extent); });
    return picture;
}

void TevDisplay::connect() {
    // tev sends nothing, but only reading finds out that it is gone before bytes are lost.
    if (sender_ && !sender_->isOpen()) {
        complain("the viewer has closed the connection");
        sender_.reset();
    }
    if (sender_) return;
    creation_.clear();
    sender_.emplace(settings_.server, [&](Clock::duration idle) { return idle < kConnect && waits(idle); });
    logDebug("--display-server: connected to " + settings_.server.text());
}

void TevDisplay::makeImage(const tev::Picture& outline) {
    std::string creation =
        tev::createImage(settings_.name, true, outline.film.width, outline.film.height, tev::channelNames(outline));
    if (creation == creation_ && outline.region == region_) return;
    sender_->send(creation, [&](Clock::duration idle) { return waits(idle); });
    creation_ = std::move(creation);
    region_ = outline.region;
    sums_.clear();
    // tev fills a new image with zeros.
    for (const auto& [layer, image] : outline.layers)
        for (const PixelRegion& tile : tev::tilesOf(region_))
            sums_[layer].push_back(sumOf(std::vector<float>(tile.count() * size_t(image.channels()))));
}

void TevDisplay::show(const tev::Picture& picture) {
    const std::vector<PixelRegion> tiles = tev::tilesOf(picture.region);
    for (size_t i = 0; i < tiles.size(); ++i)
        for (const tev::Picture::Layer& layer : picture.layers) {
            const auto shown = sums_.find(layer.name);
            if (shown == sums_.end()) continue;
            if (isLate(picture)) return;
            const std::vector<float> values = tev::valuesOf(picture, layer, tiles[i]);
            const uint64_t sum = sumOf(values);
            if (shown->second[i] == sum) continue;
            sender_->send(tev::updateImage(settings_.name, false, tiles[i], tev::channelNames(layer), values),
                          [&](Clock::duration idle) { return waits(idle); });
            shown->second[i] = sum;
        }
}

void TevDisplay::showLast() {
    // Two attempts, for a viewer that was closed and opened again.
    for (int attempt = 0; attempt < 2; ++attempt) {
        connect();
        try {
            makeImage(*last_);
            return show(*last_);
        } catch (const StreamSender::GaveUp&) {
            throw;
        } catch (const Error& error) {
            complain(error.what());
            sender_.reset();
        }
    }
}

bool TevDisplay::waits(Clock::duration idle) const {
    const std::lock_guard lock(mutex_);
    if (ending_) return false;
    return !last_ || (idle < settings_.patience && Clock::now() - lastSince_ < settings_.longest);
}

bool TevDisplay::isLate(const tev::Picture& picture) const {
    const std::lock_guard lock(mutex_);
    return ending_ || (last_ && &picture != &*last_);
}

void TevDisplay::complain(const std::string& reason) {
    const std::string text = fmt::format("--display-server {}: {}", settings_.server.text(), reason);
    if (complained_)
        logDebug(text);
    else
        logWarning(text + "; the render goes on without it");
    complained_ = true;
}

}  // namespace drc
