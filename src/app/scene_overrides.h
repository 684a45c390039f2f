// The options that replace what a scene's file says of its picture: film, crop window, camera, and single parameters.
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

    // Throws UsageError that names the option if a resolution, crop window or camera cannot be meant.
    void check() const;
    // For the front end. Throws as check().
    pbrt::LoadOptions loadOptions() const;
    // Puts the crop window into the settings of a scene that was loaded.
    void cropFilm(RenderSettings& settings) const;
    // Loads a scene with all of this. Throws UsageError for what is wrong with the options, else Error.
    std::unique_ptr<Scene> load(const std::string& path, pbrt::LoadOptions options) const;
    std::unique_ptr<Scene> load(const std::string& path) const { return load(path, loadOptions()); }
};

void addSceneOverrides(CLI::App& command, SceneOverrides& overrides);

}  // namespace drc
