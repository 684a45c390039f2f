// Cameras. Film coordinates are pixels: (0,0) is the top left corner of the top left pixel, x to the right, y down.
#pragma once
#include <memory>

#include "math/transform.h"
#include "scene/ray.h"

namespace drc {

struct FilmGeometry {
    int width = 1280;
    int height = 720;
};

class Camera {
  public:
    virtual ~Camera() = default;
    // Ray through a film position; uLens in [0,1)^2 chooses the point on the lens, uTime in [0,1) the time.
    virtual Ray generateRay(const Vec2& film, const Vec2& uLens, float uTime) const = 0;
    // World-space position and viewing direction, for frames and bounds.
    virtual Vec3 position() const = 0;
    // The same camera for a film of another size: pbrt's rule for the screen window is applied to the new aspect.
    virtual std::unique_ptr<Camera> withFilm(const FilmGeometry& film) const = 0;
    // Direction of the scene's "up", unit, world space.
    virtual Vec3 up() const = 0;
};

struct PerspectiveParams {
    Transform worldToCamera;
    float fov = 90;  // degrees, of the shorter axis
    float lensRadius = 0;
    float focalDistance = 1e6f;
    float shutterOpen = 0, shutterClose = 1;
    float frameAspectRatio = 0;  // 0: from the film
    bool hasScreenWindow = false;
    float screenWindow[4] = {-1, 1, -1, 1};  // xmin xmax ymin ymax
};
std::unique_ptr<Camera> makePerspectiveCamera(const PerspectiveParams& params, const FilmGeometry& film);

}  // namespace drc
