// pbrt's lens description files: four numbers for each surface, from the scene to the film.
#pragma once
#include <string>
#include <vector>

#include "scene/cameras/camera.h"

namespace drc::pbrt {

// The four numbers, in millimetres except the index: radius of curvature (0 for the aperture stop), distance to the
// next surface, index of refraction behind the surface, diameter. '#' begins a comment. The stop is set to stopDiameter
// (millimetres), or, with a warning, to its full diameter if that is smaller. Throws Error at the location in the file
// if the file is malformed.
std::vector<LensElement> readLensFile(const std::string& path, float stopDiameter);

}  // namespace drc::pbrt
