// Orthographic camera (PBR 3e, section 6.2.1): parallel rays along +z, from the screen window in the plane z = 0 of
// camera space. With a thin lens each of them spreads over a disk and meets again at the focal distance.
#include "math/warp.h"
#include "scene/camera.h"
#include "scene/camera_placement.h"
#include "scene/screen_window.h"

namespace drc {
namespace {

class OrthographicCamera final : public Camera {
  public:
    OrthographicCamera(const ProjectiveCameraParams& params, const FilmGeometry& film)
        : params_(params), placement_(params.worldToCamera, params.shutter), window_(params, film) {
        const Transform& toWorld = placement_.inTheMiddle();
        const Vec3 x = toWorld.vector(Vec3(1, 0, 0)), y = toWorld.vector(Vec3(0, 1, 0));
        pixelWidth_ = std::sqrt(window_.pixelArea() * length(cross(x, y)));
    }

    CameraRay generateRay(const Vec2& film, const Vec2& uLens, float uTime) const override {
        const Vec2 at = window_.at(film);
        Vec3 o(at.x, at.y, 0), d(0, 0, 1);
        if (params_.lensRadius > 0) {
            const Vec2 lens = sampleConcentricDisk(uLens) * params_.lensRadius;
            o += Vec3(lens.x, lens.y, 0);
            d -= Vec3(lens.x, lens.y, 0) / params_.focalDistance;
        }
        Ray ray = placement_.ray(o, d, uTime);
        ray.coneWidth = pixelWidth_;
        return {ray};
    }

    Vec3 position() const override { return placement_.position(); }
    Vec3 up() const override { return placement_.up(); }
    const Shutter& shutter() const override { return placement_.shutter(); }
    std::unique_ptr<Camera> withFilm(const FilmGeometry& film) const override {
        return std::make_unique<OrthographicCamera>(params_, film);
    }

  private:
    ProjectiveCameraParams params_;
    CameraPlacement placement_;
    ScreenWindow window_;
    float pixelWidth_ = 0;  // world units
};

}  // namespace

std::unique_ptr<Camera> makeOrthographicCamera(const ProjectiveCameraParams& params, const FilmGeometry& film) {
    return std::make_unique<OrthographicCamera>(params, film);
}

}  // namespace drc
