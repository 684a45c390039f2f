// Tells whether two scene files differ in their camera alone, as the frames of an animation do whose objects stand
// still.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

namespace drc::pbrt {

// A hash of all words of the scene file, and of the files that it includes, except for those before WorldBegin that
// place and describe the camera and the film. Other files that it names, such as meshes and textures, are not read.
// It is the same in another folder, and on another machine. None if the world may depend on the camera: with
// CoordSysTransform. Throws Error if the file cannot be read.
std::optional<uint64_t> worldKey(const std::string& path);

}  // namespace drc::pbrt
