// Shows a render in tev, the image viewer, while it refines. All of it happens on a thread of its own, so that a viewer
// that is slow, hangs, goes away or is not there costs the render nothing.
#pragma once
#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "view/stream_sender.h"
#include "view/tev_picture.h"

namespace drc {

struct TevSettings {
    StreamAddress server;
    std::string name;                           // of the image in the viewer
    std::chrono::milliseconds interval{1000};   // between pictures, at least
    std::chrono::milliseconds retry{2000};      // after a failure, until the next attempt to connect
    std::chrono::milliseconds patience{2000};   // for a viewer that takes nothing of the last picture
    std::chrono::milliseconds longest{10'000};  // for one that takes it slowly
};

class TevDisplay {
  public:
    // The part of the picture so far to take: its beauty, or all of its layers, which take many times as long.
    enum class Extent { Beauty, All };

    // outline: the region, and the layers that there will be, whose images may have any size.
    // take: the picture so far, of the same region. Called on this object's thread, for the beauty soon and often, for
    // all layers more seldom: so that each of the two, and what follows, takes a fortieth of the machine's time at
    // most. Its parallel loops run on that thread alone. Of a beauty, layers that the outline does not have are not
    // shown.
    TevDisplay(TevSettings settings, tev::Picture outline, std::function<tev::Picture(Extent)> take);
    // Ends at once, whatever has been sent.
    ~TevDisplay();
    TevDisplay(const TevDisplay&) = delete;
    TevDisplay& operator=(const TevDisplay&) = delete;

    // From now on `take` is not called. Waits for a call that has begun.
    void stopTaking();
    // Shows the last picture, and waits until it is sent. A viewer that takes none of it, or takes long, is given up:
    // see the settings.
    void finish(tev::Picture picture);

  private:
    using Clock = std::chrono::steady_clock;
    enum class Next { Take, Last, End };
    void run();
    void work();
    Next waitUntil(Clock::time_point due);
    std::optional<tev::Picture> taken(Extent extent);
    // Makes a connection if there is none that works. Throws Error if that fails.
    void connect();
    // Makes the image that can show these layers, if the viewer has another one or none. Throws as StreamSender::send.
    void makeImage(const tev::Picture& outline);
    // Sends the tiles that the viewer does not have yet, until there is a later picture. Throws as StreamSender::send.
    void show(const tev::Picture& picture);
    void showLast();
    // Whether to go on waiting for the viewer, which has taken nothing for so long.
    bool waits(Clock::duration idle) const;
    bool isLate(const tev::Picture& picture) const;
    // Warns, the first time.
    void complain(const std::string& reason);

    const TevSettings settings_;
    const tev::Picture outline_;
    std::mutex takeMutex_;
    std::function<tev::Picture(Extent)> take_;  // under takeMutex_; null after stopTaking()

    mutable std::mutex mutex_;
    std::condition_variable wake_;
    std::optional<tev::Picture> last_;
    Clock::time_point lastSince_;
    bool ending_ = false;

    // Used by the thread alone.
    std::optional<StreamSender> sender_;
    std::string creation_;  // the packet that made the image that the viewer has; empty: it has none
    PixelRegion region_;    // that the image shows
    std::map<std::string, std::vector<uint64_t>> sums_;  // checksums of the tiles of each layer
    bool complained_ = false;
    std::thread thread_;
};

}  // namespace drc
