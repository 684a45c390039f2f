// The surface that a place of the film shows, for people who point at it.
#pragma once
#include <optional>

#include "accel/accel.h"

namespace drc {

struct SeenSurface {
    const Primitive* primitive = nullptr;
    const Instance* instance = nullptr;  // of the object that it is a part of; null: of none
    float distance = 0;                  // from the camera, world units
    Vec3 point{0.f};                     // that is seen, world space
};

// The first surface, of those with a material or a light, that the camera sees there from the middle of its lens in the
// middle of the exposure. film: in pixels. None: it sees no surface, or the lens lets no light through. Safe while the
// scene is rendered.
std::optional<SeenSurface> seenSurface(const Accel& accel, const Camera& camera, const Vec2& film);

}  // namespace drc
