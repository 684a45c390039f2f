// Loads scenes from pbrt-v3 and pbrt-v4 files.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/limits.h"
#include "pbrt/camera_override.h"
#include "scene/scene.h"

namespace drc::pbrt {

struct LoadOptions {
    std::optional<FilmGeometry> resolution{};  // overrides that of the file
    // Parameters of film, sampler and integrator that override the file's, each as in overrides.h.
    std::vector<std::string> overrides{};
    // In place of the file's camera.
    CameraOverride camera{};
    // Maximum number of triangles of all subdivision surfaces together.
    double subdividedTriangles = limits::kSubdividedTriangles;
    // Maximum number of pieces of all curves together.
    size_t curvePieces = limits::kCurvePieces;
    // Whether Scene::names is filled in.
    bool names = false;
};

// The dialect is determined by the words of the file (dialect_scan.h); -v reports it and the deciding word. Everything
// that the scene needs is read, and all faults are found, before this returns. Throws Error for input that is
// malformed, missing or unknown. Features of pbrt that DRC does not support give a warning.
std::unique_ptr<Scene> loadPbrtFile(const std::string& path, const LoadOptions& options = {});
// Loads only what precedes WorldBegin: the camera and the settings, as a scene without a world. origin: Scene::origin
// of the scene that the camera is for.
std::unique_ptr<Scene> loadPbrtCamera(const std::string& path, const Vec3& origin, const LoadOptions& options = {});
// Like loadPbrtFile, but for a text. Relative paths start in `directory`; messages call the text `name`.
std::unique_ptr<Scene> loadPbrtString(const std::string& text, const std::string& directory = ".",
                                      const LoadOptions& options = {}, const std::string& name = "<string>");

}  // namespace drc::pbrt
