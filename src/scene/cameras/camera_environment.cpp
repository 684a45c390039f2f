// Environment camera: a lat-long image of all directions (PBR 3e, section 6.3). As in pbrt, the left edge of the film
// looks along +x of camera space, and the column at a quarter of its width looks along +z.
#include "scene/cameras/camera.h"
#include "scene/cameras/camera_placement.h"

namespace drc {
namespace {

class EnvironmentCamera final : public Camera {
  public:
    EnvironmentCamera(const EnvironmentCameraParams& params, const FilmGeometry& film)
        : params_(params),
          placement_(params.worldToCamera, params.shutter),
          dTheta_(kPi / float(film.height)),
          dPhi_(2 * kPi / float(film.width)) {}

    CameraRay generateRay(const Vec2& film, const Vec2&, float uTime) const override {
        const float theta = film.y * dTheta_, phi = film.x * dPhi_;
        const float sinTheta = std::sin(theta);
        const Vec3 d(sinTheta * std::cos(phi), std::cos(theta), sinTheta * std::sin(phi));
        Ray ray = placement_.ray(Vec3(0, 0, 0), d, uTime);
        // Square root of the pixel's solid angle; at a pole, of the solid angle half a row away from it.
        ray.coneSpread = std::sqrt(dTheta_ * dPhi_ * std::max(std::abs(sinTheta), std::sin(0.5f * dTheta_)));
        return {ray};
    }

    Vec3 position() const override { return placement_.position(); }
    Vec3 up() const override { return placement_.up(); }
    const Shutter& shutter() const override { return placement_.shutter(); }
    std::unique_ptr<Camera> withFilm(const FilmGeometry& film) const override {
        return std::make_unique<EnvironmentCamera>(params_, film);
    }
    std::unique_ptr<Camera> placed(const Transform& worldToCamera, const FilmGeometry& film) const override {
        EnvironmentCameraParams params = params_;
        params.worldToCamera = {worldToCamera, worldToCamera};
        return std::make_unique<EnvironmentCamera>(params, film);
    }
    Transform worldToCameraAt(float u) const override { return placement_.toWorldAt(shutter().motion(u)).inverse(); }
    bool isPanoramic() const override { return true; }

  private:
    EnvironmentCameraParams params_;
    CameraPlacement placement_;
    float dTheta_, dPhi_;  // radians per pixel
};

}  // namespace

std::unique_ptr<Camera> makeEnvironmentCamera(const EnvironmentCameraParams& params, const FilmGeometry& film) {
    return std::make_unique<EnvironmentCamera>(params, film);
}

}  // namespace drc
