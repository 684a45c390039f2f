// Shows a render in tev, the image viewer, while it refines. All work is done on a separate thread, so that a viewer
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
    std::chrono::milliseconds interval{1000};   // least time between pictures
    std::chrono::milliseconds retry{2000};      // time after a failure until the next attempt to connect
    std::chrono::milliseconds patience{2000};   // time limit for a viewer that reads nothing of the last picture
    std::chrono::milliseconds longest{10'000};  // time limit for a viewer that reads the last picture slowly
};

class TevDisplay {
  public:
    // The layers of a picture to take: its beauty, or all layers, which take many times as long.
    enum class Extent { Beauty, All };

    // outline: the region, and all layers that will be shown, whose images may have any size. take: returns the picture
    // so far, of the same region. It is called on this object's thread, often for the beauty and more seldom for all
    // layers, so that each of the two, with encoding and sending, takes at most a fortieth of the machine's time. Its
    // parallel loops run on that thread alone. Layers that the outline does not contain are not shown.
    TevDisplay(TevSettings settings, tev::Picture outline, std::function<tev::Picture(Extent)> take);
    // Ends at once, even if not all data has been sent.
    ~TevDisplay();
    TevDisplay(const TevDisplay&) = delete;
    TevDisplay& operator=(const TevDisplay&) = delete;

    // After this, `take` is not called any more. Waits for a call in progress.
    void stopTaking();
    // Shows the last picture, and waits until it is sent. Gives up on a viewer that reads nothing, or too slowly: see
    // the settings.
    void finish(tev::Picture picture);

  private:
    using Clock = std::chrono::steady_clock;
    enum class Next { Take, Last, End };
    void run();
    void work();
    Next waitUntil(Clock::time_point due);
    std::optional<tev::Picture> taken(Extent extent);
    // Connects if there is no working connection. Throws Error if that fails.
    void connect();
    // Creates the image for these layers, unless the viewer has it already. Throws as StreamSender::send.
    void makeImage(const tev::Picture& outline);
    // Sends the tiles that the viewer does not have yet; stops if there is a later picture. Throws as
    // StreamSender::send.
    void show(const tev::Picture& picture);
    void showLast();
    // Whether to go on waiting for the viewer, which has read nothing for the time `idle`.
    bool waits(Clock::duration idle) const;
    bool isLate(const tev::Picture& picture) const;
    // Logs the reason: the first time as a warning, later for debugging.
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

    // Used only by the thread.
    std::optional<StreamSender> sender_;
    std::string creation_;  // packet that created the viewer's present image; empty: it has none
    PixelRegion region_;    // region that the image shows
    std::map<std::string, std::vector<uint64_t>> sums_;  // checksums of the tiles of each layer
    bool complained_ = false;
    std::thread thread_;
};

}  // namespace drc
