// pbrt's lens descriptions: a text with four numbers for each surface, from the scene to the film.
#pragma once
#include <string>
#include <vector>

#include "scene/camera.h"

namespace drc::pbrt {

// The file has, in millimetres: radius of curvature (0: the stop), distance to the next surface, index of refraction
// behind the surface, diameter. From '#' on a line is comment. The stop is opened to stopDiameter, millimetres, or as
// far as it goes. Throws Error, at the place in the lens file, for what is no such list; warns of a stop that does not
// open so far.
std::vector<LensElement> readLensFile(const std::string& path, float stopDiameter);

}  // namespace drc::pbrt
