// Camera. A new camera is one entry in the table of camera_factory.cpp.
#pragma once
#include <memory>
#include <string>

#include "pbrt/file_search.h"
#include "pbrt/param_set.h"
#include "scene/camera.h"

namespace drc::pbrt {

// Throws Error for an unknown type or wrong parameters.
std::unique_ptr<Camera> makeCamera(const std::string& type, const ParamSet& params, const Transform& worldToCamera,
                                   const FilmGeometry& film, const FileSearch& files);

}  // namespace drc::pbrt
