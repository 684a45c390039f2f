#include "scene/cameras/camera_matrices.h"

namespace drc {

Transform worldToCamera(const Camera& camera, const Vec3& origin) {
    return camera.worldToCameraAt(0) * Transform::translate(-origin);
}

std::optional<Transform> worldToNdc(const Camera& camera, const FilmGeometry& film, const Vec3& origin) {
    const std::optional<Transform> toFilm = camera.cameraToFilm();
    if (!toFilm) return {};
    const Transform toNdc({1.0 / film.width, 0, 0, 0, 0, 1.0 / film.height, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    return toNdc * *toFilm * worldToCamera(camera, origin);
}

}  // namespace drc
