// Answers the requests of a live view's pages: the page itself, pictures by layer, events, the camera.
//
// Every path begins with a token that only who started the view knows, so that other users of the machine, and pages of
// other sites, can neither see nor change anything. No part of a request is taken for the name of a file.
#pragma once
#include <atomic>
#include <functional>
#include <string>

#include "image/display.h"
#include "view/http_server.h"
#include "view/live_render.h"
#include "view/view_camera.h"
#include "view/view_picture.h"

namespace drc {

class ViewService {
  public:
    struct Settings {
        std::string title;  // of the page: the scene's name
        std::string token;  // see randomToken() and isToken()
        // Encodes a frame as an EXR with all that it has.
        std::function<std::string(const LiveFrame&)> encodeExr;
        DisplaySettings display{};  // how the page shows pictures at first
    };

    // All must outlive the service.
    ViewService(const Scene& scene, const Accel& accel, LiveRender& render, Settings settings);

    // Whether a request's body is to be read: not without the token, and only pictures may be large. Safe from any
    // thread, and quick.
    HttpAdmission admit(const HttpRequest& header) const;
    // Answers a request that was admitted. Safe from any thread.
    HttpResponse answer(const HttpRequest& request);
    // The data of an event "frame": what has changed. Its serial rises, so that a page can tell which of an event and
    // an answer is older.
    std::string frameEvent() const;
    const std::string& token() const { return settings_.token; }

  private:
    HttpResponse page() const;
    HttpResponse state() const;
    HttpResponse picture(const HttpRequest& request) const;
    // withLayers: what all layers have there, beside the surface.
    HttpResponse pixel(const HttpRequest& request, bool withLayers) const;
    HttpResponse point(const HttpRequest& request) const;
    HttpResponse setCamera(const HttpRequest& request);
    HttpResponse setFocus(const HttpRequest& request);
    HttpResponse compare(const HttpRequest& request);

    const Scene& scene_;
    const Accel& accel_;
    LiveRender& render_;
    const Settings settings_;
    const ViewCamera home_;
    const FilmGeometry film_;
    const ViewPicture picture_;  // at home
    // Another one for each program: a page whose program has gone may meet the next one at the same address.
    const std::string run_;

    mutable std::mutex mutex_;
    ViewCamera camera_;
    uint64_t cameraNumber_ = 0;  // how often it has been set
    mutable std::mutex eventMutex_;
    mutable uint64_t serial_ = 0;
    std::shared_ptr<const Image> reference_;
};

// 128 bits from the system's generator, as hexadecimal digits.
std::string randomToken();
// Whether it can be a part of an address as it is, and cannot be guessed by trying: 16 to 128 letters, digits, - and _.
bool isToken(std::string_view text);

// The names of what can be seen of a frame, and the image of one; an empty image if there is none of this name.
std::vector<std::string> layersOf(const LiveFrame& frame);
Image layerOf(const LiveFrame& frame, const std::string& name);
// The values of one of these layers in a pixel, without making its image.
std::vector<float> layerAt(const LiveFrame& frame, const std::string& name, int x, int y);

// The page, one HTML file.
std::string_view viewerPage();

}  // namespace drc
