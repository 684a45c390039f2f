// The camera of a live view, as people move it: the point that it looks from and the point that it looks at. World
// space of the scene, whose numbers are accurate near zero; adding Scene::origin gives the coordinates of the scene's
// file.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>

#include "scene/cameras/camera.h"

namespace drc {

// The projection and focus of a camera, independent of its place.
struct ViewLens {
    bool orthographic = false;
    // The left, right, bottom and top edge of the picture: for a perspective, on the plane at distance 1; for an
    // orthographic camera, in world units. y up.
    std::array<float, 4> window{-1, 1, -1, 1};
    float radius = 0;            // of the thin lens, world units; 0: all is in focus
    float focalDistance = 1e6f;  // distance of the plane in focus, along the axis

    bool isUsable() const;
};

struct ViewCamera {
    Vec3 eye{0.f}, look{0.f}, up{0, 0, 1};
    // Whether left and right are swapped, which some exporters do by "Scale -1 1 1".
    bool mirrored = false;
    // Replaces the lens of the scene's camera.
    std::optional<ViewLens> lens{};

    // distance: from the camera to `look`.
    static ViewCamera of(const Camera& sceneCamera, float distance);
    // The scene's camera, moved to this place; with `lens`, a new camera that shares only the exposure with it.
    std::unique_ptr<Camera> place(const Camera& sceneCamera, const FilmGeometry& film) const;
    // Whether the camera has a direction, and its lens, if any, is usable.
    bool isUsable() const;
    // The lines of a pbrt scene that set this camera: LookAt, and Camera if it has a lens. origin: Scene::origin.
    std::string asPbrt(const Vec3& origin) const;
};

}  // namespace drc
