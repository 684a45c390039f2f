// The interface of integrators: what one samples, what it keeps in the film, and the picture that it makes of that. A
// new one is a file or a pair of files, and its line in the list of integrator.cpp.
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
    const Sensor& sensor;  // may change, if cameraMoved() is called after it
    const Accel& accel;
    const LightSampler& lights;
    const PathTracer& tracer;
    const RenderParams& params;  // resolved
    float distance;              // the median distance that the picture shows, world units; 0: no surface
    Stats* stats;                // may be null
};

// Passes of indirect light over the film, by radiance maps.
class MapPasses {
  public:
    virtual ~MapPasses() = default;
    // Adds a pass to the film. index: of the pass. spacing: between maps, in pixels. stride: only every so many rows
    // and columns of pixels are lit. False: the pass was cancelled.
    virtual bool mapPass(int index, float spacing, int stride, Film& film, const CancelToken* cancel) const = 0;
};

class Integrator {
  public:
    virtual ~Integrator() = default;

    // The camera samples that a pass takes of a pixel. sample: of the pass, if all pixels have the same number.
    virtual PixelSamples samplesOf(int /*x*/, int /*y*/, uint32_t sample) const { return {sample, 1}; }
    // Adds one camera sample of pixel (x, y) to the film, whose row is locked. index: of the sample within its pixel.
    virtual void sample(int x, int y, uint32_t index, CameraSample& sample, Film& film) = 0;
    // Called when a sample pass over the whole film is complete, while no sample is taken. samples: complete ones in
    // each pixel.
    virtual void samplePassDone(int /*samples*/) {}
    // Called when, beside passes over the whole film, about as many samples have been taken of a part of it, while no
    // sample is taken.
    virtual void focusPassesDone() {}
    // Save and restore the integrator's state beyond the film, so that a render resumes as if it had not stopped, even
    // within a pass. Call these only while no sample is taken. loadState reads what saveState of an integrator with the
    // same parameters wrote; it changes nothing, and throws Error if the values contradict each other. The function
    // that it returns installs the state and cannot fail.
    virtual void saveState(StateWriter& /*to*/) const {}
    virtual std::function<void()> loadState(StateReader& /*from*/) {
        return [] {};
    }
    // The camera and the film have changed, while no sample is taken: starts again with what is known of the scene
    // itself. False: this integrator has to be made anew for that.
    virtual bool cameraMoved() { return false; }
    // Frees what only further samples and saveState need. Neither may follow; a picture may.
    virtual void endSampling() {}
    // Null unless there are map passes beside the sample passes.
    virtual const MapPasses* mapPasses() const { return nullptr; }
    // The radiance cells; null if there are none.
    virtual const RadianceCells* cells() const { return nullptr; }
    // The layers of the picture, unfiltered.
    virtual LayeredPicture picture(std::shared_ptr<const Film> film) const = 0;
    // The beauty of that, of a film that others may add to meanwhile, under lockRow. Cheaper, where it can be, than a
    // snapshot of the film and its picture.
    virtual Preview preview(const Film& film) const;
};

// Says what an integrator can do, for those who choose one by name.
struct IntegratorTraits {
    bool maps = false;    // there are map passes
    bool cells = false;   // paths end in radiance cells
    bool media = false;   // participating media are rendered; others need a scene without
    bool halves = false;  // two independent pictures of half of the samples can be had: RenderParams::independentHalves
    bool guided = false;  // PathTracer's guide is used
};

// These throw Error that lists the integrators if there is none of this name.
const IntegratorTraits& traitsOf(const std::string& integrator);
std::unique_ptr<Integrator> makeIntegrator(const std::string& name, const RenderContext& context);
// The layers of its film. Every camera sample must add to the first one, which tells how many samples a pixel has.
// params: resolved.
std::vector<FilmLayerSpec> filmLayers(const std::string& integrator, const RenderParams& params, const Scene& scene,
                                      const RenderSettings& settings);

// The index of a layer of the integrator's film; none if it has no such layer.
std::optional<size_t> layerIndex(const RenderContext& context, std::string_view name);
std::vector<std::string> integratorNames();

}  // namespace drc
