// A sensor takes the picture of a scene: a camera and its film.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "base/error.h"
#include "image/white_balance.h"
#include "scene/cameras/camera.h"
#include "scene/filter.h"
#include "scene/media/medium.h"

namespace drc {

// The pixels [x0, x1) x [y0, y1) of the film.
struct PixelRegion {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
    size_t count() const { return size_t(width()) * size_t(height()); }
    bool operator==(const PixelRegion&) const = default;
    size_t index(int x, int y) const { return size_t(y - y0) * size_t(width()) + size_t(x - x0); }
};

// Render settings of the scene file, which the command line may override.
struct RenderSettings {
    std::string integrator = "path";  // as named in the file: "path", "directlighting", "iispt", ...
    int maxDepth = 5;
    int samplesPerPixel = 16;
    std::string sampler = "halton";
    std::string outputFile = "pbrt.exr";
    SourceLocation outputFileAt;  // where the file sets outputFile, for messages; empty if it does not
    FilmGeometry film;
    SourceLocation filmAt;                   // where the file sets the film's size, for messages; empty if it does not
    float cropWindow[4] = {0, 1, 0, 1};      // as returned by cropWindowOf() (crop_window.h)
    std::optional<PixelRegion> pixelBounds;  // of the film; none: the whole film
    // The region to render: the crop window, rounded to pixels as in pbrt, intersected with the pixel bounds; at least
    // one pixel.
    PixelRegion region() const;
    float filmScale = 1;
    // Whether lights at infinity are invisible to camera rays and the picture has an alpha channel: the share of each
    // pixel that surfaces cover.
    bool transparentFilm = false;
    // Whether EXR files contain the layers of `drc render --aovs`, as pbrt-v4's film "gbuffer" requests.
    bool auxiliaryLayers = false;
    std::optional<RgbMatrix> whiteBalance;  // applied to the finished picture
    float maxSampleLuminance = kInfinity;
    FilterPtr filter;  // not null
};

// A camera and its film, and the medium around it.
struct Sensor {
    std::shared_ptr<const Camera> camera;
    const Medium* medium = nullptr;  // around the camera, owned by Scene::media; null: empty space
    RenderSettings settings;
};

}  // namespace drc
