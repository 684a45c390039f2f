// pbrt's lens description files: four numbers for each surface, from the scene to the film.
#pragma once
#include <string>
#include <vector>

#include "scene/cameras/camera.h"

namespace drc::pbrt {

// The numbers are, in millimetres: radius of curvature (0 for the aperture stop), distance to the next surface, index
// of refraction behind the surface, diameter. '#' begins a comment. The stop is set to stopDiameter (millimetres), or
// to its full diameter with a warning if that is smaller. Throws Error at the place in the file if it is malformed.
std::vector<LensElement> readLensFile(const std::string& path, float stopDiameter);

}  // namespace drc::pbrt
