// The pictures that a scene's film asks for.
#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"

namespace drc {

// What is written where the user names no picture: an EXR and a PNG in the current folder, called as the film's file
// is, without its folder and extension. Throws Error, at the film's file name, if that names no file ("pictures/",
// "..").
std::vector<std::string> filmOutputs(const RenderSettings& settings);

}  // namespace drc
