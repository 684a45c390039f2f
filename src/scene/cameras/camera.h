// Cameras. Film coordinates are in pixels: (0,0) is the top left corner of the top left pixel, x to the right, y down.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "math/animated_transform.h"
#include "scene/cameras/shutter.h"
#include "scene/ray.h"

namespace drc {

struct FilmGeometry {
    int width = 1280;
    int height = 720;
    float diagonal = 35;  // of the film, in millimetres; only the realistic camera uses it
    bool operator==(const FilmGeometry&) const = default;
};

struct CameraRay {
    Ray ray;
    // Factor of the radiance along the ray in the pixel's value. 0: the lens blocks the ray. Always 1 except for
    // realistic cameras.
    float weight = 1;
};

// The projection of a scene point onto the film through a point on the lens.
struct CameraView {
    Vec2 film;
    Vec3 from;                // the point on the lens, world space
    float pixelsPerArea = 0;  // film area in pixels per unit area of a surface at the point that faces the lens
};

class Camera {
  public:
    virtual ~Camera() = default;
    // Ray through a film position, in world space. uLens in [0,1)^2 chooses the point on the lens, uTime in [0,1) the
    // time within the exposure.
    virtual CameraRay generateRay(const Vec2& film, const Vec2& uLens, float uTime) const = 0;
    // Projects p through the lens point that uLens chooses, at a ray's time (Ray::time). Empty if p is behind the
    // camera, or if the camera has no view(): realistic cameras, environment cameras (whose film wraps around), and
    // cameras whose transform does not preserve angles. The film position may lie outside the film.
    virtual std::optional<CameraView> view(const Vec3& p, const Vec2& uLens, float time) const;
    // CameraView::pixelsPerArea of the point at this distance along a ray from generateRay(); 0 if the camera has no
    // view().
    virtual float pixelsPerArea(const Ray& ray, float distance) const;
    // World-space position, for camera frames and bounds. For a moving camera, that in the middle of the exposure.
    virtual Vec3 position() const = 0;
    // A copy for a film of another size. The screen window follows from the new aspect ratio by pbrt's rule.
    virtual std::unique_ptr<Camera> withFilm(const FilmGeometry& film) const = 0;
    // A copy for a film of another size, at another place, without motion.
    virtual std::unique_ptr<Camera> placed(const Transform& worldToCamera, const FilmGeometry& film) const = 0;
    // The transform at the fraction u in [0, 1] of the exposure; and in its middle.
    virtual Transform worldToCameraAt(float u) const = 0;
    Transform worldToCamera() const { return worldToCameraAt(0.5f); }
    // The projection through the middle of the lens: takes camera space to film coordinates x and y, and to a z that
    // falls with the distance or rises with it. None if the camera has no such projection: environment and realistic
    // cameras.
    virtual std::optional<Transform> cameraToFilm() const { return {}; }
    // Whether the picture shows all directions, so that it has no axis along which depth could be measured.
    virtual bool isPanoramic() const { return false; }
    // The camera's "up" direction, unit, world space.
    virtual Vec3 up() const = 0;
    virtual const Shutter& shutter() const = 0;
};

// Parameters of the perspective and the orthographic camera.
struct ProjectiveCameraParams {
    AnimatedTransform worldToCamera;
    float fov = 90;  // field of view of the shorter axis, degrees; perspective only
    float lensRadius = 0;
    float focalDistance = 1e6f;
    Shutter shutter{};
    float frameAspectRatio = 0;  // 0: that of the film
    bool hasScreenWindow = false;
    float screenWindow[4] = {-1, 1, -1, 1};  // xmin, xmax, ymin, ymax
};
std::unique_ptr<Camera> makePerspectiveCamera(const ProjectiveCameraParams& params, const FilmGeometry& film);
std::unique_ptr<Camera> makeOrthographicCamera(const ProjectiveCameraParams& params, const FilmGeometry& film);

// All directions around a point: the film's width spans 360 degrees, its height runs from the camera's +y to its -y.
struct EnvironmentCameraParams {
    AnimatedTransform worldToCamera;
    Shutter shutter{};
};
std::unique_ptr<Camera> makeEnvironmentCamera(const EnvironmentCameraParams& params, const FilmGeometry& film);

// A surface of a lens, or the aperture stop. Lengths are in metres, which must then be the unit of the scene.
struct LensElement {
    float radius = 0;     // of curvature; positive if the centre is on the film's side; 0: the flat stop
    float thickness = 0;  // distance along the axis to the next element, or from the last element to the film
    float eta = 1;        // index of refraction between this element and the next one towards the film
    float aperture = 0;   // half the element's diameter
};
struct RealisticCameraParams {
    AnimatedTransform worldToCamera;
    std::vector<LensElement> lens;  // in order from the scene to the film; not empty
    float focusDistance = 10;       // distance in focus, measured from the film
    // true: the weights of rays are relative to those at the film's centre, so that brightness does not depend on the
    // aperture. false: a pixel's value is the irradiance on the film times the exposure time.
    bool simpleWeighting = true;
    Shutter shutter{};
};
// Throws Error if the lens cannot focus at the distance.
std::unique_ptr<Camera> makeRealisticCamera(const RealisticCameraParams& params, const FilmGeometry& film);

}  // namespace drc
