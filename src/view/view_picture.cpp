#include "view/view_picture.h"

#include <cmath>

namespace drc {
namespace {

// The share of the picture's width and height, around its middle, that is measured: the corners of a realistic lens may
// be dark, and a panorama wraps around.
constexpr float kMeasured = 0.25f;

}  // namespace

ViewPicture ViewPicture::of(const Camera& camera, const ViewCamera& at, const PixelRegion& region) {
    ViewPicture picture;
    if (at.mirrored) picture.right = {-1, 0, 0};
    const Transform toAxes = Transform::lookAt(at.eye, at.look, at.up);
    bool isDark = false;
    // The camera ray at (x, y): (0, 0) is the middle, (1, 0) the right edge, (0, 1) the top edge.
    const auto ray = [&](float x, float y) {
        const Vec2 film(float(region.x0 + region.x1) / 2 + x * float(region.width()) / 2,
                        float(region.y0 + region.y1) / 2 - y * float(region.height()) / 2);
        const CameraRay r = camera.generateRay(film, Vec2(0.5f), 0.5f);
        isDark |= !(r.weight > 0);
        return std::pair(toAxes.point(r.ray.o), normalize(toAxes.vector(r.ray.d)));
    };
    const auto middle = ray(0, 0), left = ray(-kMeasured, 0), right = ray(kMeasured, 0), bottom = ray(0, -kMeasured),
               top = ray(0, kMeasured);
    if (isDark) return picture;
    if (length(right.second - left.second) < 1e-6f) {
        const Vec3 across = right.first - left.first, upwards = top.first - bottom.first;
        picture.kind = Kind::Parallel;
        picture.width = length(across) / kMeasured;
        picture.right = normalize(across);
        picture.top = normalize(upwards);
        const float x = dot(middle.first, picture.right), y = dot(middle.first, picture.top),
                    height = length(upwards) / kMeasured;
        picture.window = {x - picture.width / 2, x + picture.width / 2, y - height / 2, y + height / 2};
        return picture;
    }
    // Scales a direction to reach the plane at distance 1, on which a perspective picture is uniform.
    const auto onPlane = [](const Vec3& d) { return d / d.z; };
    if (middle.second.z > 0.1f) {
        const Vec3 across = onPlane(right.second) - onPlane(left.second);
        picture.width = length(across) / kMeasured;
        picture.right = normalize(across);
        picture.top = normalize(onPlane(top.second) - onPlane(bottom.second));
        return picture;
    }
    const Vec3 across = right.second - left.second;
    picture.kind = Kind::Panorama;
    picture.width = 2 * std::asin(std::min(1.f, length(across) / 2)) / kMeasured;
    picture.ahead = middle.second;
    picture.right = normalize(across);
    picture.top = normalize(top.second - bottom.second);
    return picture;
}

}  // namespace drc
