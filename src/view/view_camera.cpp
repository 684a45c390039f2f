#include "view/view_camera.h"

#include <fmt/ranges.h>

#include <algorithm>

namespace drc {
namespace {

Transform mirror() { return Transform::scale(-1, 1, 1); }

}  // namespace

ViewCamera ViewCamera::of(const Camera& sceneCamera, float distance) {
    const Transform toCamera = sceneCamera.worldToCamera(), toWorld = toCamera.inverse();
    ViewCamera camera;
    camera.eye = toWorld.point(Vec3(0.f));
    camera.look = camera.eye + normalize(toWorld.vector(Vec3(0, 0, 1))) * (distance > 0 ? distance : 1);
    camera.up = normalize(toWorld.vector(Vec3(0, 1, 0)));
    camera.mirrored =
        toCamera.swapsHandedness() != Transform::lookAt(camera.eye, camera.look, camera.up).swapsHandedness();
    return camera;
}

std::unique_ptr<Camera> ViewCamera::place(const Camera& sceneCamera, const FilmGeometry& film) const {
    const Transform upright = Transform::lookAt(eye, look, up), toCamera = mirrored ? mirror() * upright : upright;
    if (!lens) return sceneCamera.placed(toCamera, film);
    ProjectiveCameraParams params;
    params.worldToCamera = {toCamera, toCamera};
    params.lensRadius = lens->radius;
    params.focalDistance = lens->focalDistance;
    params.shutter = sceneCamera.shutter();
    params.hasScreenWindow = true;
    std::copy(lens->window.begin(), lens->window.end(), params.screenWindow);
    return lens->orthographic ? makeOrthographicCamera(params, film) : makePerspectiveCamera(params, film);
}

bool ViewLens::isUsable() const {
    // Greater values have squares that overflow in pixels.
    const auto isFine = [](float v) { return std::abs(v) < 1e9f; };
    return std::all_of(window.begin(), window.end(), isFine) && window[1] - window[0] > 1e-9f &&
           window[3] - window[2] > 1e-9f && radius >= 0 && isFine(radius) && focalDistance > 1e-9f &&
           isFine(focalDistance);
}

bool ViewCamera::isUsable() const {
    const auto isFine = [](const Vec3& v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && length(v) < 1e18f;
    };
    if (!isFine(eye) || !isFine(look) || !isFine(up) || (lens && !lens->isUsable())) return false;
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
    std::string text = (mirrored ? std::string("Scale -1 1 1\n") : std::string()) + "LookAt " + point(eye) + "  " +
                       point(look) + "  " + direction(up) + "\n";
    if (lens) {
        text += fmt::format("Camera \"{}\" \"float screenwindow\" [{:.9g}]",
                            lens->orthographic ? "orthographic" : "perspective", fmt::join(lens->window, " "));
        if (!lens->orthographic) text += " \"float fov\" 90";
        if (lens->radius > 0)
            text += fmt::format(" \"float lensradius\" {:.9g} \"float focaldistance\" {:.9g}", lens->radius,
                                lens->focalDistance);
        text += "\n";
    }
    return text;
}

}  // namespace drc
