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

class KeptContents;
struct SceneListing;

struct LoadOptions {
    std::optional<FilmGeometry> resolution{};  // overrides the file's resolution
    // Parameters of film, sampler and integrator that override the file's; each has the form described in overrides.h.
    std::vector<std::string> overrides{};
    // Overrides the file's camera.
    CameraOverride camera{};
    // Maximum number of triangles of all subdivision surfaces together.
    double subdividedTriangles = limits::kSubdividedTriangles;
    // Maximum number of pieces of all curves together.
    size_t curvePieces = limits::kCurvePieces;
    // Whether to fill in Scene::names.
    bool names = false;
    // Contents of the frame before, which the scene takes over where its file describes the same, and which are
    // replaced by those of this scene; may be null.
    KeptContents* kept = nullptr;
    // Filled with what the file says, if it is not null: see scene_listing.h.
    SceneListing* listing = nullptr;
};

// The dialect is determined from the words of the file (dialect_scan.h); -v reports it and the deciding word. Before
// this returns, everything that the scene needs has been read, and all faults have been found. Throws Error for input
// that is malformed, missing or unknown. Features of pbrt that DRC does not support cause a warning.
std::unique_ptr<Scene> loadPbrtFile(const std::string& path, const LoadOptions& options = {});
// Loads only the part before WorldBegin: the camera and the settings, as a scene without a world. origin: Scene::origin
// of the scene in which the camera will be used.
std::unique_ptr<Scene> loadPbrtCamera(const std::string& path, const Vec3& origin, const LoadOptions& options = {});
// Like loadPbrtFile, but for a text in memory. Relative paths start in `directory`; messages call the text `name`.
std::unique_ptr<Scene> loadPbrtString(const std::string& text, const std::string& directory = ".",
                                      const LoadOptions& options = {}, const std::string& name = "<string>");

}  // namespace drc::pbrt
