// Camera. A new camera is one entry in the table of camera_factory.cpp.
#pragma once
#include <memory>
#include <string>

#include "pbrt/param_set.h"
#include "scene/camera.h"

namespace drc::pbrt {

// What is not built becomes a perspective camera, with a warning. Throws Error for an unknown type.
std::unique_ptr<Camera> makeCamera(const std::string& type, const ParamSet& params, const Transform& worldToCamera,
                                   const FilmGeometry& film);

}  // namespace drc::pbrt
