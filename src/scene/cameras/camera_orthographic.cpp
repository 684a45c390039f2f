// Orthographic camera (PBR 3e, section 6.2.1): parallel rays along +z from the screen window in the plane z = 0 of
// camera space. With a thin lens, the rays through a film position start on a disk and meet at the focal distance.
#include "scene/cameras/camera.h"
#include "scene/cameras/camera_placement.h"
#include "scene/cameras/screen_window.h"

namespace drc {
namespace {

class OrthographicCamera final : public Camera {
  public:
    OrthographicCamera(const ProjectiveCameraParams& params, const FilmGeometry& film)
        : params_(params), placement_(params.worldToCamera, params.shutter), window_(params, film) {
        const Transform& toWorld = placement_.inTheMiddle();
        const Vec3 x = toWorld.vector(Vec3(1, 0, 0)), y = toWorld.vector(Vec3(0, 1, 0));
        keepsAngles_ = placement_.keepsAngles();
        pixelWidth_ = std::sqrt(window_.pixelArea() * length(cross(x, y)));
    }

    CameraRay generateRay(const Vec2& film, const Vec2& uLens, float uTime) const override {
        const Vec2 at = window_.at(film);
        const Vec3 lens = onLens(params_, uLens);
        Ray ray = placement_.ray(Vec3(at.x, at.y, 0) + lens, Vec3(0, 0, 1) - lens / params_.focalDistance, uTime);
        ray.coneWidth = pixelWidth_;
        return {ray};
    }

    std::optional<CameraView> view(const Vec3& p, const Vec2& uLens, float time) const override {
        if (!keepsAngles_) return {};
        const Transform toWorld = placement_.toWorldAt(time);
        const Vec3 q = toWorld.inverse().point(p), lens = onLens(params_, uLens);
        if (!(q.z > 0)) return {};
        const Vec3 d = Vec3(0, 0, 1) - lens / params_.focalDistance, from = q - d * q.z;
        CameraView view{window_.film(Vec2(from.x - lens.x, from.y - lens.y)), toWorld.point(from)};
        view.pixelsPerArea = pixelsPerFacingArea(1 / length(d));
        return view;
    }
    float pixelsPerArea(const Ray& ray, float) const override {
        if (!keepsAngles_) return 0;
        return pixelsPerFacingArea(dot(ray.d, normalize(placement_.toWorldAt(ray.time).vector(Vec3(0, 0, 1)))));
    }

    Vec3 position() const override { return placement_.position(); }
    Vec3 up() const override { return placement_.up(); }
    const Shutter& shutter() const override { return placement_.shutter(); }
    std::unique_ptr<Camera> withFilm(const FilmGeometry& film) const override {
        return std::make_unique<OrthographicCamera>(params_, film);
    }
    std::unique_ptr<Camera> placed(const Transform& worldToCamera, const FilmGeometry& film) const override {
        ProjectiveCameraParams params = params_;
        params.worldToCamera = {worldToCamera, worldToCamera};
        return std::make_unique<OrthographicCamera>(params, film);
    }
    Transform worldToCameraAt(float u) const override { return placement_.toWorldAt(shutter().motion(u)).inverse(); }
    std::optional<Transform> cameraToFilm() const override { return window_.parallel(); }

  private:
    // CameraView::pixelsPerArea for rays whose angle to the camera's axis has this cosine.
    float pixelsPerFacingArea(float cosine) const { return 1 / (sqr(pixelWidth_) * cosine); }

    ProjectiveCameraParams params_;
    CameraPlacement placement_;
    ScreenWindow window_;
    float pixelWidth_ = 0;  // width of a pixel perpendicular to the axis, world units
    bool keepsAngles_;
};

}  // namespace

std::unique_ptr<Camera> makeOrthographicCamera(const ProjectiveCameraParams& params, const FilmGeometry& film) {
    return std::make_unique<OrthographicCamera>(params, film);
}

}  // namespace drc
