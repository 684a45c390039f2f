// Creates the camera of a scene file. A new camera is an entry in the table of camera_factory.cpp.
#pragma once
#include <array>
#include <memory>
#include <string>

#include "pbrt/file_search.h"
#include "pbrt/param_set.h"
#include "scene/cameras/camera.h"

namespace drc::pbrt {

// The camera's transform, and the two times between which it and everything else moves.
struct CameraMotion {
    AnimatedTransform worldToCamera;
    std::array<float, 2> transformTimes{0, 1};
};

// Throws Error for an unknown type or wrong parameters.
std::unique_ptr<Camera> makeCamera(const std::string& type, const ParamSet& params, const CameraMotion& motion,
                                   const FilmGeometry& film, const FileSearch& files);
// pbrt-v4's.
std::unique_ptr<Camera> makeCameraV4(const std::string& type, const ParamSet& params, const CameraMotion& motion,
                                     const FilmGeometry& film, const FileSearch& files);
// The exposure time, by which pbrt-v4 multiplies the picture. Throws Error if the shutter never opens.
float exposureTimeV4(const ParamSet& camera);

}  // namespace drc::pbrt
