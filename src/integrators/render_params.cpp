#include "integrators/render_params.h"

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "base/log.h"
#include "integrators/integrator.h"
#include "maps/map_grid.h"

namespace drc {
namespace {

constexpr int kUnbounded = std::numeric_limits<int>::max();

// spp: camera samples per pixel without map passes. The other numbers are for map passes: camera samples per pixel,
// number of passes, and directions gathered from the maps.
struct Effort {
    int mapSpp, mapPasses, gatherSamples, spp;
};
Effort effortOf(Quality quality) {
    switch (quality) {
        case Quality::Draft:
            return {16, 7, 4, 16};
        case Quality::Standard:
            return {64, 10, 4, 128};
        case Quality::High:
            return {256, 16, 8, 1024};
    }
    return {};
}

// The integrator that the scene's file asks for, or the nearest available one.
std::string integratorOfFile(const std::string& name) {
    if (name == "iispt") return "drc";
    if (name == "directlighting") return "direct";
    if (name == "bdpt") return "bdpt";
    // Without media, "volpath" is "path"; media have warnings of their own.
    if (name != "path" && name != "volpath") logWarning("the scene's integrator '" + name + "' is rendered as 'path'");
    return "path";
}

}  // namespace

uint64_t RenderParams::seedOfFrame() const {
    constexpr uint64_t kFrameStream = 0x2008;
    return frame == 0 ? seed : hashCombine(seed, hashCombine(kFrameStream, uint64_t(frame)));
}

RenderParams resolved(RenderParams p, const RenderSettings& settings) {
    const bool byFile = p.integrator == "scene";
    if (byFile) p.integrator = integratorOfFile(settings.integrator);
    const bool maps = traitsOf(p.integrator).maps;
    const Effort effort = effortOf(p.quality);
    // With a time budget, only limits that were set explicitly apply besides it.
    if (p.seconds > 0) {
        if (!p.spp) p.spp = kUnbounded;
        if (!p.mapPasses && !p.mapTasks) p.mapPasses = kUnbounded;
    }
    if (!p.spp) p.spp = byFile ? settings.samplesPerPixel : maps ? effort.mapSpp : effort.spp;
    if (!p.mapPasses)
        p.mapPasses =
            p.mapTasks ? passesForTasks(*p.mapTasks, settings.film.width, settings.film.height) : effort.mapPasses;
    if (!p.gatherSamples) p.gatherSamples = p.seconds > 0 ? p.indirect.gatherSamples : effort.gatherSamples;
    p.indirect.gatherSamples = *p.gatherSamples;
    if (!p.maxDepth) p.maxDepth = byFile ? settings.maxDepth : PathSettings().maxDepth;
    p.clamp = std::min(settings.maxSampleLuminance, p.clamp > 0 ? p.clamp : kInfinity);
    if (p.firstSpacing == 0) p.firstSpacing = kFirstSpacing;
    if (p.denoise == Denoise::Automatic) p.denoise = maps ? Denoise::Surface : Denoise::Off;
    if (!maps && (p.denoise == Denoise::Surface || p.denoise == Denoise::OidnDirect))
        throw Error("--denoise " + std::string(p.denoise == Denoise::Surface ? "surface" : "oidn-direct") +
                    ": it filters the layers of --integrator drc-maps, which others do not have");
    if (maps && settings.transparentFilm)
        throw Error(
            "--integrator drc-maps: its pictures have no alpha, which the scene's film asks for by 'transparent'; "
            "drc, path, bdpt and direct have it");
    if (p.denoise == Denoise::Oidn || p.denoise == Denoise::OidnDirect || settings.transparentFilm || p.surfaces)
        p.gBuffer = true;
    return p;
}

}  // namespace drc
