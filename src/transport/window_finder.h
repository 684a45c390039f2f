// Finds the windows of a room: openings in its walls through which rays from the visible surfaces leave the scene. The
// windows only steer sampling (EnvironmentWindows), so that wrong ones do not change what the picture converges to.
#pragma once
#include <span>
#include <vector>

#include "accel/accel.h"
#include "transport/environment_windows.h"

namespace drc {

// Returns the windows, the most useful first. Returns none if too few or too many rays leave the scene, or if only few
// of the leaving rays pass through openings. views: camera rays. The result depends on these rays alone, not on the
// number of threads.
std::vector<Portal> findWindows(const Accel& accel, std::span<const Ray> views);

// The environment with the windows that are found, if sampling through them is clearly less noisy on the surfaces that
// the view rays show, else without windows. environment: without a portal; must outlive the result.
EnvironmentWindows windowsOnto(const Light& environment, const Accel& accel, std::span<const Ray> views);

}  // namespace drc
