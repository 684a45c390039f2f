// A camera given outside the scene file, such as by --lookat and --fov on the command line, which replaces the file's.
#pragma once
#include <optional>
#include <string>

#include "math/vec.h"

namespace drc::pbrt {

class ParamSet;
struct TransformSet;

struct LookAt {
    Vec3 eye{0.f}, look{0.f}, up{0, 1, 0};  // in the file's coordinates; up need not be perpendicular
    // Why these vectors define no view, for a message; empty if they do.
    std::string fault() const;
};

struct CameraOverride {
    std::optional<LookAt> lookAt{};
    std::optional<float> fov{};  // field of view of the picture's shorter side, degrees, in (0, 180)

    // The world-to-camera transform to use where the file has `worldToCamera`. A camera placed by lookAt does not move.
    // It mirrors left and right if the file's camera does.
    TransformSet placed(const TransformSet& worldToCamera) const;
    // Changes the parameters of the file's camera. Throws Error, located at the camera, if it has no field of view.
    void applyFov(const std::string& type, ParamSet& params) const;
};

}  // namespace drc::pbrt
