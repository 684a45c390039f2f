// Perspective camera with a thin lens (PBR 3e, sections 6.2.2 and 6.2.3). Camera space is left-handed: x right, y up,
// looking along +z.
#include "math/warp.h"
#include "scene/camera.h"

namespace drc {
namespace {

class PerspectiveCamera final : public Camera {
  public:
    PerspectiveCamera(const PerspectiveParams& params, const FilmGeometry& film)
        : params_(params), cameraToWorld_(params.worldToCamera.inverse()) {
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
        const double tangent = std::tan(params.fov * std::numbers::pi / 360);
        left_ = window[0] * tangent;
        top_ = window[3] * tangent;
        pixelX_ = (window[1] - window[0]) * tangent / film.width;
        pixelY_ = (window[3] - window[2]) * tangent / film.height;
    }

    Ray generateRay(const Vec2& film, const Vec2& uLens, float uTime) const override {
        // Where the ray through the lens's centre meets the plane z = 1.
        const auto x = static_cast<float>(left_ + film.x * pixelX_), y = static_cast<float>(top_ - film.y * pixelY_);
        Vec3 o(0, 0, 0), d(x, y, 1);
        if (params_.lensRadius > 0) {
            const Vec2 lens = sampleConcentricDisk(uLens) * params_.lensRadius;
            o = Vec3(lens.x, lens.y, 0);
            // Towards focalDistance * (x, y, 1), scaled down, so that a focus at infinity does not overflow.
            d -= o / params_.focalDistance;
        }
        Ray ray;
        ray.o = cameraToWorld_.point(o);
        ray.d = normalize(cameraToWorld_.vector(d));
        ray.time = lerp(uTime, params_.shutterOpen, params_.shutterClose);
        // The pixel as seen along the ray: its solid angle is its area at z = 1 times cos^3.
        const float cosine2 = 1 / (1 + x * x + y * y);
        ray.coneSpread = std::sqrt(static_cast<float>(std::abs(pixelX_ * pixelY_)) * cosine2 * std::sqrt(cosine2));
        return ray;
    }

    Vec3 position() const override { return cameraToWorld_.point(Vec3(0, 0, 0)); }
    Vec3 up() const override { return normalize(cameraToWorld_.vector(Vec3(0, 1, 0))); }
    std::unique_ptr<Camera> withFilm(const FilmGeometry& film) const override {
        return std::make_unique<PerspectiveCamera>(params_, film);
    }

  private:
    PerspectiveParams params_;
    Transform cameraToWorld_;
    // The film on the plane z = 1 of camera space: its top left corner, and the size of a pixel.
    double left_ = 0, top_ = 0, pixelX_ = 0, pixelY_ = 0;
};

}  // namespace

std::unique_ptr<Camera> makePerspectiveCamera(const PerspectiveParams& params, const FilmGeometry& film) {
    return std::make_unique<PerspectiveCamera>(params, film);
}

}  // namespace drc
