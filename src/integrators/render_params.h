// All parameters of a picture besides its scene, set by the command line or by another program. resolved() derives
// missing ones from the quality and from the scene's file.
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
    // resolved() makes it Surface if the integrator has layers for it, else Off. Callers that can load Open Image
    // Denoise replace that Off by Oidn.
    Automatic,
    Off,         // no denoiser
    Surface,     // each layer is averaged along surfaces, as far as its noise requires (LayerFilter)
    Oidn,        // Open Image Denoise on the whole picture
    OidnDirect,  // Open Image Denoise on direct light only
};

struct RenderParams {
    std::string integrator = "drc";  // one of integratorNames(), or "scene": the one that the file asks for
    Quality quality = Quality::Standard;
    std::optional<int> spp;        // camera samples per pixel; with a time budget, an upper bound
    int firstSample = 0;           // index of the first camera sample: films of different samples can be added up
    std::optional<int> mapPasses;  // number of map passes; with a time budget, an upper bound
    std::optional<int> mapTasks;   // number of map passes in the paper's unit (passesForTasks)
    std::optional<int> maxDepth;
    double seconds = 0;  // wall-clock budget; 0: none. Without spp and mapPasses it is the only bound
    uint64_t seed = 0;
    int frame = 0;  // number of the frame in its animation, from 0
    // The seed of all samples: that of the frame, so that noise does not stick to the screen. Frame 0, such as a still,
    // has the seed itself.
    uint64_t seedOfFrame() const;
    float clamp = 0;  // upper bound on the luminance of a sample; 0: only the film's own, by default none
    IndirectSettings indirect;
    std::optional<int> gatherSamples;
    float firstSpacing = 0;  // map spacing in the first map pass, as a share of the film's height; 0: the default
    // Whether path-traced samples of the broad lobes' indirect light correct the maps' errors.
    bool correct = true;
    Denoise denoise = Denoise::Automatic;
    // The mode of Open Image Denoise. If unset, the picture and the available time determine it.
    std::optional<OidnQuality> oidnQuality;
    std::optional<bool> oidnPrefilter;
    bool gBuffer = false;  // record albedo, normal and depth: LayeredPicture::gBuffer
    // Also record which surfaces the camera itself sees: LayeredPicture::surfaces and, with independentHalves, halves.
    // resolved() then sets gBuffer.
    bool surfaces = false;
    bool parts = false;     // store direct light separately if the integrator can: LayeredPicture::hasParts
    bool variance = false;  // store half buffers: PictureLayer::variance
    // Makes the half buffers independent, as the estimate of the denoised picture's error requires (DenoisedError):
    // each has its own sample sequence and G-buffer. Otherwise, one sequence is well distributed over both.
    bool independentHalves = false;
    bool cells = true;  // whether paths of integrator drc end in radiance cells; false: it is the path tracer
    // Cells to begin with, in place of none; null: none. cellSize is then theirs.
    std::shared_ptr<const CellCollection> startCells;
    // Cells of the frame before, which are forgotten where they no longer hold (CarriedCells), in place of startCells;
    // null: none.
    std::shared_ptr<const CellCollection> carriedCells;
    // The cells stay as they are at first: pictures depend on them, the seed and the samples alone.
    bool freezeCells = false;
    // Every path deposits that may, as if the cells were all that is wanted.
    bool trainCells = false;
    float cellSize = 0;  // edge of the finest cells at first, world units; 0: by the distances that the picture shows
    bool guide = true;   // whether sampling of the environment learns where its light enters (EnvironmentGuide)
};

// settings: those of the scene's file. Fills in all parameters that were left open, such as integrator, spp, mapPasses
// and maxDepth. Throws Error if parameters contradict each other.
RenderParams resolved(RenderParams params, const RenderSettings& settings);

}  // namespace drc
