// Cameras. Film coordinates are pixels: (0,0) is the top left corner of the top left pixel, x to the right, y down.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "math/animated_transform.h"
#include "scene/ray.h"
#include "scene/shutter.h"

namespace drc {

struct FilmGeometry {
    int width = 1280;
    int height = 720;
    float diagonal = 35;  // millimetres; for the realistic camera alone
};

struct CameraRay {
    Ray ray;
    // The radiance along the ray counts for the pixel with this weight. 0: the camera let nothing through, and there is
    // no ray. Other than 1 only for cameras with real lenses.
    float weight = 1;
};

// How a camera sees a point.
struct CameraView {
    Vec2 film;
    Vec3 from;                // the point of the lens; world space
    float pixelsPerArea = 0;  // of the film, that a unit of area fills which faces the lens there
};

class Camera {
  public:
    virtual ~Camera() = default;
    // Ray through a film position; uLens in [0,1)^2 chooses the point on the lens, uTime in [0,1) the time.
    virtual CameraRay generateRay(const Vec2& film, const Vec2& uLens, float uTime) const = 0;
    // Of the ray through p and the lens's point for uLens, at the time of a ray (Ray::time). None: there is none, or
    // this camera cannot tell: one with a real lens, or a panorama, whose film goes on at its other side.
    virtual std::optional<CameraView> view(const Vec3& p, const Vec2& uLens, float time) const;
    // What view() says of a point at that distance along one of the camera's own rays; 0 where it can tell of none.
    virtual float pixelsPerArea(const Ray& ray, float distance) const;
    // World space, for frames and bounds. Of a camera that moves: in the middle of the exposure.
    virtual Vec3 position() const = 0;
    // The same camera for a film of another size: pbrt's rule for the screen window is applied to the new aspect.
    virtual std::unique_ptr<Camera> withFilm(const FilmGeometry& film) const = 0;
    // Direction of the scene's "up", unit, world space.
    virtual Vec3 up() const = 0;
    virtual const Shutter& shutter() const = 0;
};

// Of the perspective and the orthographic camera.
struct ProjectiveCameraParams {
    AnimatedTransform worldToCamera;
    float fov = 90;  // degrees, of the shorter axis; perspective alone
    float lensRadius = 0;
    float focalDistance = 1e6f;
    Shutter shutter{};
    float frameAspectRatio = 0;  // 0: from the film
    bool hasScreenWindow = false;
    float screenWindow[4] = {-1, 1, -1, 1};  // xmin xmax ymin ymax
};
std::unique_ptr<Camera> makePerspectiveCamera(const ProjectiveCameraParams& params, const FilmGeometry& film);
std::unique_ptr<Camera> makeOrthographicCamera(const ProjectiveCameraParams& params, const FilmGeometry& film);

// All directions from one point: the film's width is a full turn, its height goes from the camera's +y to -y.
struct EnvironmentCameraParams {
    AnimatedTransform worldToCamera;
    Shutter shutter{};
};
std::unique_ptr<Camera> makeEnvironmentCamera(const EnvironmentCameraParams& params, const FilmGeometry& film);

// One surface of a lens, or the stop. Lengths in metres, which the scene's units then are.
struct LensElement {
    float radius = 0;     // of curvature; positive: the centre is on the film's side; 0: the stop, which is flat
    float thickness = 0;  // distance along the axis to the next element, or from the last one to the film
    float eta = 1;        // index of refraction of what lies behind it, towards the film
    float aperture = 0;   // half of its diameter
};
struct RealisticCameraParams {
    AnimatedTransform worldToCamera;
    std::vector<LensElement> lens;  // from the scene to the film; not empty
    float focusDistance = 10;       // from the film, which moves away from the lens until this is sharp
    // Weights of rays: as if the film's middle had all the light that the lens lets through, whatever the aperture; or
    // else as the irradiance on the film, times the time that the shutter is open.
    bool simpleWeighting = true;
    Shutter shutter{};
};
// Throws Error if the lens cannot be focused so near.
std::unique_ptr<Camera> makeRealisticCamera(const RealisticCameraParams& params, const FilmGeometry& film);

}  // namespace drc
