// Scenes from files of pbrt-v3 and pbrt-v4.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/limits.h"
#include "scene/scene.h"

namespace drc::pbrt {

struct LoadOptions {
    std::optional<FilmGeometry> resolution{};  // instead of the file's
    // Parameters of film, sampler and integrator instead of the file's, each as in overrides.h.
    std::vector<std::string> overrides{};
    // That all subdivision surfaces together may come to.
    double subdividedTriangles = limits::kSubdividedTriangles;
    // That all curves together may be cut into.
    size_t curvePieces = limits::kCurvePieces;
};

// Which of the two a file is written in is found out by its words (dialect_scan.h); -v says which, and by what.
// Everything that the scene needs is read, and everything that can be wrong found out, before this returns. Throws
// Error for what is malformed, missing or unknown; what pbrt knows and we have not built gives a warning.
std::unique_ptr<Scene> loadPbrtFile(const std::string& path, const LoadOptions& options = {});
// The same for a text. Relative paths start in directory; messages call the text name.
std::unique_ptr<Scene> loadPbrtString(const std::string& text, const std::string& directory = ".",
                                      const LoadOptions& options = {}, const std::string& name = "<string>");

}  // namespace drc::pbrt
