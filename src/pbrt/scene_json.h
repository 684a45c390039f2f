// Writes a SceneListing as JSON: docs/scene-export.md.
#pragma once
#include <functional>
#include <string_view>
#include <vector>

#include "pbrt/mesh_files.h"
#include "pbrt/scene_listing.h"

namespace drc::pbrt {

// Grows by one whenever readers of an older version would misread a document.
inline constexpr int kSceneJsonVersion = 1;

// Calls `write` with consecutive parts of the document. For shapes that have a mesh file, the values of parameters that
// the file contains are left out. meshes: may be empty.
void writeSceneJson(const SceneListing& listing, const std::vector<MeshFile>& meshes,
                    const std::function<void(std::string_view)>& write);

}  // namespace drc::pbrt
