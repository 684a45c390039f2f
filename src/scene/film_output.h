// The output files that a scene's film specifies.
#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"

namespace drc {

// The files to write if the user names none: an EXR and a PNG in the current folder, with the stem of the film's file
// name. Throws Error, located at settings.outputFileAt, if the film's file name has no stem ("pictures/", "..",
// ".exr").
std::vector<std::string> filmOutputs(const RenderSettings& settings);

}  // namespace drc
