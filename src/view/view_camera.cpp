#include "view/view_camera.h"

#include <fmt/core.h>

namespace drc {
namespace {

Transform mirror() { return Transform::scale(-1, 1, 1); }

}  // namespace

ViewCamera ViewCamera::of(const Scene& scene, float distance) {
    const Transform toCamera = scene.camera->worldToCamera(), toWorld = toCamera.inverse();
    ViewCamera camera;
    camera.eye = toWorld.point(Vec3(0.f));
    camera.look = camera.eye + normalize(toWorld.vector(Vec3(0, 0, 1))) * (distance > 0 ? distance : 1);
    camera.up = normalize(toWorld.vector(Vec3(0, 1, 0)));
    camera.mirrored =
        toCamera.swapsHandedness() != Transform::lookAt(camera.eye, camera.look, camera.up).swapsHandedness();
    return camera;
}

std::unique_ptr<Camera> ViewCamera::place(const Scene& scene, const FilmGeometry& film) const {
    const Transform toCamera = Transform::lookAt(eye, look, up);
    return scene.camera->placed(mirrored ? mirror() * toCamera : toCamera, film);
}

bool ViewCamera::isUsable() const {
    const auto isFine = [](const Vec3& v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && length(v) < 1e18f;
    };
    if (!isFine(eye) || !isFine(look) || !isFine(up)) return false;
    const Vec3 forward = normalize(look - eye);
    return lengthSquared(forward) > 0 && length(cross(forward, normalize(up))) > 1e-3f;
}

std::string ViewCamera::asPbrt(const Vec3& origin) const {
    // Enough digits for a place far from zero, and no more than floats have near it.
    const auto point = [&](const Vec3& v) {
        std::string text;
        for (int c = 0; c < 3; ++c) text += fmt::format("{}{:.9g}", c ? " " : "", double(v[c]) + double(origin[c]));
        return text;
    };
    const auto direction = [](const Vec3& v) { return fmt::format("{:.6g} {:.6g} {:.6g}", v.x, v.y, v.z); };
    return (mirrored ? std::string("Scale -1 1 1\n") : std::string()) + "LookAt " + point(eye) + "  " + point(look) +
           "  " + direction(up) + "\n";
}

}  // namespace drc
