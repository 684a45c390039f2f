// Copies scenes as text, for programs that read pbrt's format themselves but are to render with other settings.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/cameras/camera.h"

namespace drc::pbrt {

// Settings that are not set stay as in the file.
struct CopySettings {
    std::optional<FilmGeometry> resolution;
    std::optional<int> spp;  // of the sampler "halton", which takes any number
    std::string integrator;  // its type; empty: the file's
    int maxDepth = 5;        // of `integrator`
};

// Calls `write` with consecutive parts of a scene that has no Include or Import, names files by absolute paths, and
// has these settings; it ends with the file's first scene. The first line is "# pbrt-v3" or "# pbrt-v4". "-" is
// standard input. Nothing but the form of directives is checked, so that a scene need not be one that DRC renders.
// Returns the files that the scene consists of, but for `path` itself. Throws Error for unknown directives, malformed
// parameters, files to include that are missing, and files without a WorldBegin.
std::vector<std::string> copyScene(const std::string& path, const CopySettings& settings,
                                   const std::function<void(std::string_view)>& write);

}  // namespace drc::pbrt
