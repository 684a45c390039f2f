// The interface of integrators: what an integrator samples, what it stores in the film, and how it makes a picture from
// the film. A new integrator is a file or a pair of files, and a line in the list of integrator.cpp.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "base/stats.h"
#include "cells/radiance_cells.h"
#include "film/film.h"
#include "film/layered_picture.h"
#include "film/preview.h"
#include "film/sample_pass.h"
#include "integrators/render_params.h"
#include "maps/map_denoiser.h"
#include "transport/camera_sample.h"
#include "transport/path_tracer.h"

namespace drc {

// Inputs of integrators. All of them must outlive the integrator.
struct RenderContext {
    const Scene& scene;
    const Sensor& sensor;  // may change; cameraMoved() must then be called
    const Accel& accel;
    const LightSampler& lights;
    const PathTracer& tracer;
    const RenderParams& params;  // resolved
    float distance;              // median distance of the visible surfaces, world units; 0: no surface
    Stats* stats;                // may be null
};

// Passes over the film that add indirect light from radiance maps.
class MapPasses {
  public:
    virtual ~MapPasses() = default;
    // Adds a pass to the film. index: of the pass. spacing: distance between maps, in pixels. stride: only every
    // stride-th row and column of pixels is lit. False: the pass was cancelled.
    virtual bool mapPass(int index, float spacing, int stride, Film& film, const CancelToken* cancel) const = 0;
};

class Integrator {
  public:
    virtual ~Integrator() = default;

    // The camera samples of pixel (x, y) in a pass. sample: index of the pass's sample if all pixels have the same
    // number.
    virtual PixelSamples samplesOf(int /*x*/, int /*y*/, uint32_t sample) const { return {sample, 1}; }
    // Adds one camera sample of pixel (x, y) to the film, whose row the caller has locked. index: of the sample within
    // its pixel.
    virtual void sample(int x, int y, uint32_t index, CameraSample& sample, Film& film) = 0;
    // Called at the end of a sample pass over the whole film, while no sample is being taken. samples: the number of
    // complete samples of each pixel.
    virtual void samplePassDone(int /*samples*/) {}
    // Called while no sample is being taken, after passes over a part of the film have taken about as many samples as a
    // pass over the whole film.
    virtual void focusPassesDone() {}
    // Save and restore the integrator's state beyond the film, so that a render resumes as if it had not stopped, even
    // within a pass. Call these only while no sample is being taken. loadState reads the data that saveState of an
    // integrator with the same parameters wrote; it changes nothing, and throws Error if the values contradict each
    // other. The function that it returns installs the state and cannot fail.
    virtual void saveState(StateWriter& /*to*/) const {}
    virtual std::function<void()> loadState(StateReader& /*from*/) {
        return [] {};
    }
    // Called when the camera and the film have changed, while no sample is being taken: starts again, and keeps only
    // what is known of the scene itself. False: the integrator has to be made anew.
    virtual bool cameraMoved() { return false; }
    // Frees memory that only further samples and saveState need. After this, only pictures may be made.
    virtual void endSampling() {}
    // Null unless the integrator has map passes besides its sample passes.
    virtual const MapPasses* mapPasses() const { return nullptr; }
    // The radiance cells; null if there are none.
    virtual const RadianceCells* cells() const { return nullptr; }
    // The layers of the picture, unfiltered.
    virtual LayeredPicture picture(std::shared_ptr<const Film> film) const = 0;
    // The beauty of picture(), of a film that other threads may be adding to under lockRow. Where possible, cheaper
    // than a snapshot of the film and its picture.
    virtual Preview preview(const Film& film) const;
};

// The abilities of an integrator, for code that chooses one by name.
struct IntegratorTraits {
    bool maps = false;    // there are map passes
    bool cells = false;   // paths end in radiance cells
    bool media = false;   // participating media are rendered; other integrators need a scene without media
    bool halves = false;  // can give two independent pictures of half of the samples: RenderParams::independentHalves
    bool guided = false;  // PathTracer's guide is used
};

// These throw Error with a list of the integrators if none has this name.
const IntegratorTraits& traitsOf(const std::string& integrator);
std::unique_ptr<Integrator> makeIntegrator(const std::string& name, const RenderContext& context);
// The layers of the integrator's film. Every camera sample must add to the first layer, which counts the samples of
// each pixel. params: resolved.
std::vector<FilmLayerSpec> filmLayers(const std::string& integrator, const RenderParams& params, const Scene& scene,
                                      const RenderSettings& settings);

// The index of a layer of the integrator's film; none if it has no such layer.
std::optional<size_t> layerIndex(const RenderContext& context, std::string_view name);
std::vector<std::string> integratorNames();

}  // namespace drc
