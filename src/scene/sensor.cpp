#include "scene/sensor.h"

#include <algorithm>
#include <cmath>

namespace drc {

PixelRegion RenderSettings::region() const {
    const auto edge = [](int n, float f) { return std::clamp(int(std::ceil(float(n) * f)), 0, n); };
    PixelRegion r{edge(film.width, cropWindow[0]), edge(film.height, cropWindow[2]), edge(film.width, cropWindow[1]),
                  edge(film.height, cropWindow[3])};
    if (pixelBounds) {
        r.x0 = std::max(r.x0, pixelBounds->x0);
        r.y0 = std::max(r.y0, pixelBounds->y0);
        r.x1 = std::min(r.x1, pixelBounds->x1);
        r.y1 = std::min(r.y1, pixelBounds->y1);
    }
    r.x0 = std::min(r.x0, film.width - 1);
    r.y0 = std::min(r.y0, film.height - 1);
    r.x1 = std::max(r.x1, r.x0 + 1);
    r.y1 = std::max(r.y1, r.y0 + 1);
    return r;
}

}  // namespace drc
