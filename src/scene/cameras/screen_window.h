// The screen window, shared by perspective and orthographic cameras.
#pragma once
#include "math/warp.h"
#include "scene/cameras/camera.h"

namespace drc {

// A point on the thin lens, uniformly distributed for u in [0,1)^2; camera space.
inline Vec3 onLens(const ProjectiveCameraParams& params, const Vec2& u) {
    if (!(params.lensRadius > 0)) return Vec3(0, 0, 0);
    const Vec2 lens = sampleConcentricDisk(u) * params.lensRadius;
    return Vec3(lens.x, lens.y, 0);
}

// The part of the screen that the film shows: its top left corner and the size of a pixel. In screen units, the shorter
// axis runs from -1 to 1 by default (PBR 3e, section 6.2). x to the right, y up.
struct ScreenWindow {
    double left, top, pixelX, pixelY;

    ScreenWindow(const ProjectiveCameraParams& params, const FilmGeometry& film) {
        const double aspect =
            params.frameAspectRatio > 0 ? double(params.frameAspectRatio) : double(film.width) / film.height;
        double window[4] = {-1, 1, -1, 1};
        if (params.hasScreenWindow) {
            for (int i = 0; i < 4; ++i) window[i] = params.screenWindow[i];
        } else if (aspect > 1) {
            window[0] = -aspect;
            window[1] = aspect;
        } else {
            window[2] = -1 / aspect;
            window[3] = 1 / aspect;
        }
        left = window[0];
        top = window[3];
        pixelX = (window[1] - window[0]) / film.width;
        pixelY = (window[3] - window[2]) / film.height;
    }
    Vec2 at(const Vec2& film) const {
        return Vec2(static_cast<float>(left + film.x * pixelX), static_cast<float>(top - film.y * pixelY));
    }
    // Inverse of at(): the film position of a screen point.
    Vec2 film(const Vec2& screen) const {
        return Vec2(static_cast<float>((double(screen.x) - left) / pixelX),
                    static_cast<float>((top - double(screen.y)) / pixelY));
    }
    // Camera space to film coordinates, as Camera::cameraToFilm() has them; for a window on the plane z = 1 that is
    // seen from the origin, and for parallel rays along z.
    Transform perspective() const {
        return Transform({1 / pixelX, 0, -left / pixelX, 0, 0, -1 / pixelY, top / pixelY, 0, 0, 0, 0, 1, 0, 0, 1, 0});
    }
    Transform parallel() const {
        return Transform({1 / pixelX, 0, 0, -left / pixelX, 0, -1 / pixelY, 0, top / pixelY, 0, 0, 1, 0, 0, 0, 0, 1});
    }
    float pixelArea() const { return static_cast<float>(std::abs(pixelX * pixelY)); }
};

}  // namespace drc
