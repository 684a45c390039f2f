// Creates the camera of a scene file. To add a camera, add an entry to the table in camera_factory.cpp.
#pragma once
#include <array>
#include <memory>
#include <string>

#include "pbrt/file_search.h"
#include "pbrt/param_set.h"
#include "scene/cameras/camera.h"

namespace drc::pbrt {

// The camera's transform, and the two times between which the camera and all other moving things move.
struct CameraMotion {
    AnimatedTransform worldToCamera;
    std::array<float, 2> transformTimes{0, 1};
};

// Throws Error for an unknown type or wrong parameters.
std::unique_ptr<Camera> makeCamera(const std::string& type, const ParamSet& params, const CameraMotion& motion,
                                   const FilmGeometry& film, const FileSearch& files);
// The counterpart for pbrt-v4.
std::unique_ptr<Camera> makeCameraV4(const std::string& type, const ParamSet& params, const CameraMotion& motion,
                                     const FilmGeometry& film, const FileSearch& files);
// The exposure time, which multiplies the picture in pbrt-v4. Throws Error if the shutter never opens.
float exposureTimeV4(const ParamSet& camera);

}  // namespace drc::pbrt
