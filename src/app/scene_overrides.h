// The options that override the scene file's film size, crop window, camera, and single parameters.
#pragma once
#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "pbrt/scene_file.h"

namespace drc {

struct SceneOverrides {
    std::string resolution;
    std::vector<double> crop;             // x0 x1 y0 y1; empty: the file's
    std::vector<std::string> parameters;  // NAME=VALUE of film, sampler and integrator
    std::vector<double> lookAt;           // eye, look, up; empty: the file's
    std::optional<double> fov;

    // Throws UsageError that names the option if a resolution, crop window or camera is invalid.
    void check() const;
    // The overrides as options of the front end, except the crop window. Throws as check().
    pbrt::LoadOptions loadOptions() const;
    // Sets the crop window in the settings of a loaded scene.
    void cropFilm(RenderSettings& settings) const;
    // Loads a scene with these overrides. Throws UsageError for a fault of the options, Error for any other.
    std::unique_ptr<Scene> load(const std::string& path, pbrt::LoadOptions options) const;
    std::unique_ptr<Scene> load(const std::string& path) const { return load(path, loadOptions()); }
};

void addSceneOverrides(CLI::App& command, SceneOverrides& overrides);

}  // namespace drc
