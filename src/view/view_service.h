// Answers the requests of a live view's pages: the page itself, pictures by layer, events, the camera.
//
// Every path begins with a secret token of the user who started the view, so that other users of the machine, and pages
// of other sites, can neither see nor change anything. No part of a request is used as the name of a file.
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
        // Encodes a frame as an EXR with all of its layers.
        std::function<std::string(const LiveFrame&)> encodeExr;
        DisplaySettings display{};  // how the page shows pictures at first
    };

    // All references must outlive the service.
    ViewService(const Scene& scene, const Accel& accel, LiveRender& render, Settings settings);

    // Whether a request's body is to be read: only with the token, and only pictures may be large. Safe from any
    // thread, and quick.
    HttpAdmission admit(const HttpRequest& header) const;
    // Answers a request that was admitted. Safe from any thread.
    HttpResponse answer(const HttpRequest& request);
    // The data of an event "frame": the present state. Its serial number rises, so that a page can tell whether an
    // event or an answer is older.
    std::string frameEvent() const;
    const std::string& token() const { return settings_.token; }

  private:
    HttpResponse page() const;
    HttpResponse state() const;
    HttpResponse picture(const HttpRequest& request) const;
    // withLayers: whether the answer contains the pixel's values in all layers, besides the surface.
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
    const ViewPicture picture_;  // geometry of home_
    // Random for each run of the program: a page may outlive its program, and meet the next one at the same address.
    const std::string run_;

    mutable std::mutex mutex_;
    ViewCamera camera_;
    uint64_t cameraNumber_ = 0;  // how often the camera has been set
    mutable std::mutex eventMutex_;
    mutable uint64_t serial_ = 0;
    std::shared_ptr<const Image> reference_;
};

// 128 bits from the system's generator, as hexadecimal digits.
std::string randomToken();
// Whether the text can be a part of an address as it is, and cannot be guessed: 16 to 128 letters, digits, - and _.
bool isToken(std::string_view text);

// The names of a frame's layers, and the image of one of them; an empty image if there is none of this name.
std::vector<std::string> layersOf(const LiveFrame& frame);
Image layerOf(const LiveFrame& frame, const std::string& name);
// The values of one of these layers at a pixel, without making the layer's image.
std::vector<float> layerAt(const LiveFrame& frame, const std::string& name, int x, int y);

// The page, one HTML file.
std::string_view viewerPage();

}  // namespace drc
