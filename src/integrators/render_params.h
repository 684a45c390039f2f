// All that determines a picture besides its scene, set by the command line or by another program. resolved() fills in
// what is left open, from the quality and from the scene's file.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "cells/cell_collection.h"
#include "maps/indirect_pass.h"
#include "reconstruct/open_image_denoise.h"
#include "transport/path_state.h"

namespace drc {

enum class Quality { Draft, Standard, High };

enum class Denoise {
    Automatic,   // the surface filter where the integrator has layers for it, else none; who can load Open Image
                 // Denoise, asks for Oidn in place of none
    Off,         //
    Surface,     // each layer is averaged along surfaces, as far as its noise requires (LayerFilter)
    Oidn,        // Open Image Denoise on the whole picture
    OidnDirect,  // the same on direct light alone
};

struct RenderParams {
    std::string integrator = "drc";  // one of integratorNames(), or "scene": what the file asks for
    Quality quality = Quality::Standard;
    std::optional<int> spp;        // camera samples a pixel; beside a time budget, at most
    int firstSample = 0;           // index of the first one: films of different samples can be added up
    std::optional<int> mapPasses;  // number of map passes; beside a time budget, at most
    std::optional<int> mapTasks;   // the same in the paper's unit (passesForTasks)
    std::optional<int> maxDepth;
    double seconds = 0;  // wall-clock budget; 0: none. Without spp and mapPasses it is the only bound
    uint64_t seed = 0;
    float clamp = 0;  // upper bound on the luminance of a sample; 0: the film's own, by default none
    IndirectSettings indirect;
    std::optional<int> gatherSamples;
    float firstSpacing = 0;  // of the maps of the first map pass, as a share of the film's height; 0: the default
    // Whether path-traced samples of the broad lobes' indirect light correct the maps' errors.
    bool correct = true;
    Denoise denoise = Denoise::Automatic;
    // The mode of Open Image Denoise; what is left open is chosen for the picture and the time that there is.
    std::optional<OidnQuality> oidnQuality;
    std::optional<bool> oidnPrefilter;
    bool gBuffer = false;   // record albedo, normal and depth: LayeredPicture::gBuffer
    bool parts = false;     // keep direct light apart, where the integrator can: LayeredPicture::hasParts
    bool variance = false;  // keep half buffers: PictureLayer::variance
    // The half buffers know nothing of each other, as the estimate of the denoised picture's error needs
    // (DenoisedError): each has a sequence of samples and a G-buffer of its own. Else one sequence is well distributed
    // over both.
    bool independentHalves = false;
    bool cells = true;  // whether paths of integrator drc end in radiance cells; false: it is the path tracer
    // Cells to begin with, in place of none; null: none. cellSize is then theirs.
    std::shared_ptr<const CellCollection> startCells;
    // The cells stay as they are at first: pictures depend on them, the seed and the samples alone.
    bool freezeCells = false;
    // Every path deposits that may, as if the cells were all that is wanted.
    bool trainCells = false;
    float cellSize = 0;  // edge of the finest cells at first, world units; 0: by the distances that the picture shows
    bool guide = true;   // whether sampling of the environment learns where its light enters (EnvironmentGuide)
};

// settings: those of the scene's file. Fills in whatever was left open: integrator, spp, mapPasses, maxDepth and all
// other parameters have values. Throws Error if parameters contradict each other.
RenderParams resolved(RenderParams params, const RenderSettings& settings);

}  // namespace drc
