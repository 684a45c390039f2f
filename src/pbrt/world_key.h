// Detects whether two scene files differ only in their cameras, like the frames of an animation in which objects do not
// move.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

namespace drc::pbrt {

// A hash of all words in the scene file and in the files that it includes, except the directives before WorldBegin that
// place and describe the camera and the film. Other files that it names, such as meshes and textures, are not read.
// The hash is the same in another folder and on another machine. None if the world may depend on the camera, because of
// CoordSysTransform. Throws Error if the file cannot be read.
std::optional<uint64_t> worldKey(const std::string& path);

}  // namespace drc::pbrt
