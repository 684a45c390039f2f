// The camera of a live view, in the terms in which a person moves it: from where it looks to where. World space of the
// scene, which is fine near zero; that of its file is Scene::origin away.
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
    // The left, right, bottom and top edge of the picture: on the plane at distance 1 or, if it is orthographic, in
    // world units. y up.
    std::array<float, 4> window{-1, 1, -1, 1};
    float radius = 0;            // of the thin lens, world units; 0: all is in focus
    float focalDistance = 1e6f;  // in focus, along the axis

    bool isUsable() const;
};

struct ViewCamera {
    Vec3 eye{0.f}, look{0.f}, up{0, 0, 1};
    // Whether left and right are swapped, as some exporters have it by "Scale -1 1 1".
    bool mirrored = false;
    // In place of that of the scene's camera.
    std::optional<ViewLens> lens{};

    // distance: at which the point that it looks to is taken to be.
    static ViewCamera of(const Camera& sceneCamera, float distance);
    // The scene's camera, moved there; with `lens`, one that has only its exposure.
    std::unique_ptr<Camera> place(const Camera& sceneCamera, const FilmGeometry& film) const;
    // Whether it looks anywhere.
    bool isUsable() const;
    // As lines of a pbrt scene, with the camera's own if it has a lens. origin: the scene's.
    std::string asPbrt(const Vec3& origin) const;
};

}  // namespace drc
