// A camera that is given outside the scene file, as by --lookat and --fov on the command line, in place of the file's.
#pragma once
#include <optional>
#include <string>

#include "math/vec.h"

namespace drc::pbrt {

class ParamSet;
struct TransformSet;

struct LookAt {
    Vec3 eye{0.f}, look{0.f}, up{0, 1, 0};  // the file's coordinates; up need not be perpendicular
    // The reason, for a message, why it defines no view; empty if it does.
    std::string fault() const;
};

struct CameraOverride {
    std::optional<LookAt> lookAt{};
    std::optional<float> fov{};  // of the picture's shorter side, in degrees, in (0, 180)

    // The transform of a camera for which the file has `worldToCamera`. One that stands elsewhere stands still; it
    // keeps left and right swapped if the file's has them so.
    TransformSet placed(const TransformSet& worldToCamera) const;
    // Changes the parameters of the file's camera. Throws Error, at the camera, if it has no field of view.
    void applyFov(const std::string& type, ParamSet& params) const;
};

}  // namespace drc::pbrt
