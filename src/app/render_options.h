// The options of `drc render`. Scene and outputs are those of the present frame.
#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/scene_overrides.h"
#include "image/display.h"
#include "integrators/render_params.h"
#include "render/frame_list.h"

namespace drc {

struct RenderOptions : FrameFiles {
    DisplaySettings display;
    RenderParams params;  // options that determine the picture write to these
    std::string mapDenoiser = "network";
    std::string weights;
    std::string precision = "auto";
    std::string projection = "auto";
    SceneOverrides overrides;
    std::optional<float> spacing;  // between the maps of the first map pass, in pixels
    int oracleSamples = 64;
    int threads = 0;
    std::string oidnLibrary;
    std::string timing;
    std::string checkpoint, every = "60s", resume;
    std::optional<double> noiseThreshold;
    std::string displayServer;
    std::string frames;
    std::optional<int> frame;  // the frame's number, in place of that in the scene file's name
    std::string cells = "on";  // or off, or a file
    bool temporal = false;     // average each frame with its neighbours
    bool aovs = false, stats = false, quiet = false, verbose = false;
};

void addRenderOptions(CLI::App& command, RenderOptions& options);

// Throws UsageError that names the options given to the parsed `command` that would do nothing: those about radiance
// maps or radiance cells where `integrator` has none.
void refuseIdleOptions(const CLI::App& command, const std::string& integrator);

}  // namespace drc
