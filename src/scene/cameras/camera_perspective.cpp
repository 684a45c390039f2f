// Perspective camera with a thin lens (PBR 3e, sections 6.2.2 and 6.2.3). Camera space is left-handed: x right, y up,
// looking along +z.
#include "scene/cameras/camera.h"
#include "scene/cameras/camera_placement.h"
#include "scene/cameras/screen_window.h"

namespace drc {
namespace {

class PerspectiveCamera final : public Camera {
  public:
    PerspectiveCamera(const ProjectiveCameraParams& params, const FilmGeometry& film)
        : params_(params), placement_(params.worldToCamera, params.shutter), window_(params, film) {
        const double tangent = std::tan(params.fov * std::numbers::pi / 360);
        window_.left *= tangent;
        window_.top *= tangent;
        window_.pixelX *= tangent;
        window_.pixelY *= tangent;
        keepsAngles_ = placement_.keepsAngles();
    }

    CameraRay generateRay(const Vec2& film, const Vec2& uLens, float uTime) const override {
        // The intersection of the ray through the lens's centre with the plane z = 1.
        const Vec2 at = window_.at(film);
        // d is the vector from o to focalDistance * (x, y, 1), divided by focalDistance so that an infinite focal
        // distance does not overflow.
        const Vec3 o = onLens(params_, uLens), d = Vec3(at.x, at.y, 1) - o / params_.focalDistance;
        Ray ray = placement_.ray(o, d, uTime);
        // The pixel's solid angle is its area on the plane z = 1 times cos^3.
        const float cosine2 = 1 / (1 + at.x * at.x + at.y * at.y);
        ray.coneSpread = std::sqrt(window_.pixelArea() * cosine2 * std::sqrt(cosine2));
        return {ray};
    }

    std::optional<CameraView> view(const Vec3& p, const Vec2& uLens, float time) const override {
        if (!keepsAngles_) return {};
        const Transform toWorld = placement_.toWorldAt(time);
        const Vec3 o = onLens(params_, uLens), d = toWorld.inverse().point(p) - o;
        if (!(d.z > 0)) return {};
        const Vec3 at = d / d.z + o / params_.focalDistance;
        CameraView view{window_.film(Vec2(at.x, at.y)), toWorld.point(o)};
        view.pixelsPerArea = pixelsPerSolidAngle(d.z / length(d)) / lengthSquared(p - view.from);
        return view;
    }
    float pixelsPerArea(const Ray& ray, float distance) const override {
        if (!keepsAngles_) return 0;
        const Vec3 axis = normalize(placement_.toWorldAt(ray.time).vector(Vec3(0, 0, 1)));
        return pixelsPerSolidAngle(dot(ray.d, axis)) / sqr(distance);
    }

    Vec3 position() const override { return placement_.position(); }
    Vec3 up() const override { return placement_.up(); }
    const Shutter& shutter() const override { return placement_.shutter(); }
    std::unique_ptr<Camera> withFilm(const FilmGeometry& film) const override {
        return std::make_unique<PerspectiveCamera>(params_, film);
    }
    std::unique_ptr<Camera> placed(const Transform& worldToCamera, const FilmGeometry& film) const override {
        ProjectiveCameraParams params = params_;
        params.worldToCamera = {worldToCamera, worldToCamera};
        return std::make_unique<PerspectiveCamera>(params, film);
    }
    Transform worldToCameraAt(float u) const override { return placement_.toWorldAt(shutter().motion(u)).inverse(); }
    std::optional<Transform> cameraToFilm() const override { return window_.perspective(); }

  private:
    // Film area in pixels per unit solid angle, in a direction whose angle to the axis has this cosine.
    float pixelsPerSolidAngle(float cosine) const { return 1 / (window_.pixelArea() * cosine * sqr(cosine)); }

    ProjectiveCameraParams params_;
    CameraPlacement placement_;
    ScreenWindow window_;  // on the plane z = 1 of camera space
    bool keepsAngles_;
};

}  // namespace

std::unique_ptr<Camera> makePerspectiveCamera(const ProjectiveCameraParams& params, const FilmGeometry& film) {
    return std::make_unique<PerspectiveCamera>(params, film);
}

}  // namespace drc
