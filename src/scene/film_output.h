// The output files that a scene's film asks for.
#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"

namespace drc {

// The files that are written if the user names none: an EXR and a PNG in the current folder, with the stem of the
// film's file name. Throws Error, at the place of that name, if it names no file ("pictures/", "..").
std::vector<std::string> filmOutputs(const RenderSettings& settings);

}  // namespace drc
