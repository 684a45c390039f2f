// Whether the next frame of an animation shows the scene that is loaded, so that only its camera has to be read.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/file_stamp.h"
#include "pbrt/scene_file.h"

namespace drc {

class SameWorld {
  public:
    // Matches no scene.
    SameWorld() = default;
    // The world of a scene that was loaded from a file.
    explicit SameWorld(const Scene& scene);

    // The camera and the settings in a scene file, for the loaded scene. Null if the file describes another world, or
    // if its film settings differ from those of the loaded scene in more than the size. Files that the scene names,
    // such as meshes and textures, count as the same if their sizes and times are. Throws Error if the file cannot be
    // read.
    std::unique_ptr<Scene> cameraIn(const std::string& path, const Scene& loaded,
                                    const pbrt::LoadOptions& options) const;

  private:
    std::optional<uint64_t> key_;
    std::filesystem::path folder_;  // in which names of files are looked up
    std::vector<FileStamp> files_;
    RenderSettings settings_;
};

}  // namespace drc
