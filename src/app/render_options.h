// The options of `drc render`.
#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "image/display.h"
#include "render/render_params.h"

namespace drc {

struct RenderOptions {
    std::string scene;
    std::vector<std::string> outputs;
    DisplaySettings display;
    RenderParams params;  // options that determine the picture write to these
    std::string mapDenoiser = "network";
    std::string weights;
    std::string precision = "auto";
    std::string projection = "auto";
    std::string resolution;
    std::vector<double> crop;
    std::vector<std::string> overrides;  // NAME=VALUE for parameters of the scene's file
    std::optional<float> spacing;        // of the first map pass, in pixels
    int oracleSamples = 64;
    int threads = 0;
    std::string oidnLibrary;
    std::string timing;
    std::string checkpoint, every = "60s", resume;
    std::optional<double> noiseThreshold;
    std::string displayServer;
    std::string frames;
    bool aovs = false, stats = false, quiet = false, verbose = false;
};

void addRenderOptions(CLI::App& command, RenderOptions& options);

// Throws Error that names the options given to the parsed `command` that would do nothing: those about radiance maps or
// radiance cells where `integrator` has none.
void refuseIdleOptions(const CLI::App& command, const std::string& integrator);

}  // namespace drc
