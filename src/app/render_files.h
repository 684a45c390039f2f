// The files that `drc render` reads and writes.
#pragma once
#include <memory>

#include "app/render_options.h"
#include "base/distinct_files.h"
#include "scene/scene.h"

namespace drc {

// The files of the present frame. Throws Error if an output would replace another one, or a file that the command line
// names as an input.
DistinctFiles filesOf(const RenderOptions& options);

// Whether --cells names a file.
inline bool namesCellsFile(const RenderOptions& options) { return options.cells != "on" && options.cells != "off"; }

// Throws Error if an output would replace a file that the scene names.
void keepFrom(const std::vector<std::string>& filesOfScene, DistinctFiles files);

// Loads options.scene; if no output is given, uses those named by its film. kept: LoadOptions::kept. Throws Error as
// the functions above, and if the scene cannot be read or an output cannot be written.
std::unique_ptr<Scene> loadScene(RenderOptions& options, pbrt::KeptContents* kept = nullptr);

}  // namespace drc
