// Finds the windows of a room: openings in its walls through which rays from what the camera sees leave the scene. What
// it finds steers sampling alone (EnvironmentWindows), so that it may be wrong without harm to the picture.
#pragma once
#include <span>
#include <vector>

#include "accel/accel.h"
#include "transport/environment_windows.h"

namespace drc {

// Windows, the most useful first; none if most rays leave the scene, or if openings explain few of those that do.
// views: rays of the camera. The same for the same rays, whatever the number of threads.
std::vector<Portal> findWindows(const Accel& accel, std::span<const Ray> views);

// An environment with the windows that are found, if samples through them are clearly less noisy on the surfaces that
// the views show, or else without any. environment: without a portal; must outlive the result.
EnvironmentWindows windowsOnto(const Light& environment, const Accel& accel, std::span<const Ray> views);

}  // namespace drc
