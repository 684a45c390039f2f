// The files that `drc render` reads and writes.
#pragma once
#include <memory>

#include "app/render_options.h"
#include "base/distinct_files.h"
#include "scene/scene.h"

namespace drc {

// Those of the present frame. Throws Error if an output would replace another, or what the command line says is read.
DistinctFiles filesOf(const RenderOptions& options);

// Whether --cells names a file.
inline bool namesCellsFile(const RenderOptions& options) { return options.cells != "on" && options.cells != "off"; }

// Refuses outputs that would replace a file that the scene names.
void keepFrom(const std::vector<std::string>& filesOfScene, DistinctFiles files);

// Loads options.scene; where no output is given, takes those of its film. Throws Error as the above, and if the scene
// cannot be read or an output not be written.
std::unique_ptr<Scene> loadScene(RenderOptions& options);

}  // namespace drc
