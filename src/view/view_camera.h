// The camera of a live view, in the terms in which a person moves it: from where it looks to where. World space of the
// scene, which is fine near zero; that of its file is Scene::origin away.
#pragma once
#include <memory>
#include <string>

#include "scene/scene.h"

namespace drc {

struct ViewCamera {
    Vec3 eye{0.f}, look{0.f}, up{0, 0, 1};
    // Whether left and right are swapped, as some exporters have it by "Scale -1 1 1".
    bool mirrored = false;

    // The scene's camera. distance: at which the point that it looks to is taken to be.
    static ViewCamera of(const Scene& scene, float distance);
    // The scene's camera, moved there.
    std::unique_ptr<Camera> place(const Scene& scene, const FilmGeometry& film) const;
    // Whether it looks anywhere.
    bool isUsable() const;
    // As lines of a pbrt scene. origin: the scene's.
    std::string asPbrt(const Vec3& origin) const;
};

}  // namespace drc
