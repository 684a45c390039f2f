#include "render/same_world.h"

#include <algorithm>

#include "base/regular_file.h"
#include "pbrt/world_key.h"

namespace drc {
namespace {

bool sameBalance(const std::optional<RgbMatrix>& a, const std::optional<RgbMatrix>& b) {
    return a && b ? a->rows == b->rows : !a && !b;
}

bool sameFilm(const RenderSettings& a, const RenderSettings& b) {
    return std::ranges::equal(a.cropWindow, b.cropWindow) && a.pixelBounds == b.pixelBounds &&
           a.filmScale == b.filmScale && sameBalance(a.whiteBalance, b.whiteBalance) &&
           a.maxSampleLuminance == b.maxSampleLuminance && a.transparentFilm == b.transparentFilm &&
           a.auxiliaryLayers == b.auxiliaryLayers;
}

std::filesystem::path folderOf(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, ignored), ignored).parent_path();
}

}  // namespace

SameWorld::SameWorld(const Scene& scene) : settings_(scene.sensor.settings) {
    // A pipe cannot be read again.
    if (scene.files.empty() || !isRegularFile(scene.files[0])) return;
    key_ = pbrt::worldKey(scene.files[0]);
    folder_ = folderOf(scene.files[0]);
    for (size_t i = 1; i < scene.files.size(); ++i) files_.emplace_back(scene.files[i]);
}

std::unique_ptr<Scene> SameWorld::cameraIn(const std::string& path, const Scene& loaded,
                                           const pbrt::LoadOptions& options) const {
    if (!key_ || !isRegularFile(path) || folderOf(path) != folder_ || pbrt::worldKey(path) != key_) return nullptr;
    for (const FileStamp& file : files_)
        if (FileStamp(file.path) != file) return nullptr;
    std::unique_ptr<Scene> camera = pbrt::loadPbrtCamera(path, loaded.origin, options);
    return sameFilm(camera->sensor.settings, settings_) ? std::move(camera) : nullptr;
}

}  // namespace drc
