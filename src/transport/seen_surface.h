// Finds the surface at a position of the film, for users who point at it.
#pragma once
#include <optional>

#include "accel/accel.h"

namespace drc {

struct SeenSurface {
    const Primitive* primitive = nullptr;
    const Instance* instance = nullptr;  // instance that the surface belongs to; null: none
    float distance = 0;                  // from the camera, world units
    Vec3 point{0.f};                     // the visible point, world space
};

// The first surface with a material or a light on the camera ray through `film` (in pixels), from the middle of the
// lens, at the middle of the exposure. None: there is no such surface, or the lens lets no light through. Safe while
// the scene is rendered.
std::optional<SeenSurface> seenSurface(const Accel& accel, const Camera& camera, const Vec2& film);

}  // namespace drc
