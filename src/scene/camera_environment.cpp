// Environment camera: a lat-long picture of all directions (PBR 3e, section 6.3). As in pbrt the film's left edge looks
// along camera space's +x, and a quarter of the way to the right along +z.
#include "scene/camera.h"

namespace drc {
namespace {

class EnvironmentCamera final : public Camera {
  public:
    EnvironmentCamera(const EnvironmentCameraParams& params, const FilmGeometry& film)
        : params_(params),
          cameraToWorld_(params.worldToCamera.inverse()),
          dTheta_(kPi / float(film.height)),
          dPhi_(2 * kPi / float(film.width)) {}

    CameraRay generateRay(const Vec2& film, const Vec2&, float uTime) const override {
        const float theta = film.y * dTheta_, phi = film.x * dPhi_;
        const float sinTheta = std::sin(theta);
        Ray ray;
        ray.o = position();
        ray.d =
            normalize(cameraToWorld_.vector(Vec3(sinTheta * std::cos(phi), std::cos(theta), sinTheta * std::sin(phi))));
        ray.time = lerp(uTime, params_.shutterOpen, params_.shutterClose);
        // The pixel's solid angle; at a pole, that of half a row below it.
        ray.coneSpread = std::sqrt(dTheta_ * dPhi_ * std::max(std::abs(sinTheta), std::sin(0.5f * dTheta_)));
        return {ray};
    }

    Vec3 position() const override { return cameraToWorld_.point(Vec3(0, 0, 0)); }
    Vec3 up() const override { return normalize(cameraToWorld_.vector(Vec3(0, 1, 0))); }
    std::unique_ptr<Camera> withFilm(const FilmGeometry& film) const override {
        return std::make_unique<EnvironmentCamera>(params_, film);
    }

  private:
    EnvironmentCameraParams params_;
    Transform cameraToWorld_;
    float dTheta_, dPhi_;  // radians a pixel
};

}  // namespace

std::unique_ptr<Camera> makeEnvironmentCamera(const EnvironmentCameraParams& params, const FilmGeometry& film) {
    return std::make_unique<EnvironmentCamera>(params, film);
}

}  // namespace drc
