// The interface of integrators: what one samples, what it keeps in the film, and the picture that it makes of that. A
// new one is a file or a pair of files, and its line in the list of integrator.cpp.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "base/stats.h"
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
    const Accel& accel;
    const LightSampler& lights;
    const PathTracer& tracer;
    const RenderParams& params;      // resolved
    float distance;                  // the median distance that the picture shows, world units; 0: no surface
    const MapDenoiser* mapDenoiser;  // null where the integrator has no radiance maps
    Stats* stats;                    // may be null
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
    // The scene's camera and film have changed, while no sample is taken: starts again with what is known of the scene
    // itself. False: this integrator has to be made anew for that.
    virtual bool cameraMoved() { return false; }
    // Frees what only further samples and saveState need. Neither may follow; a picture may.
    virtual void endSampling() {}
    // Whether there are map passes. mapPass runs one of them. index: of the pass. spacing: between maps, in pixels.
    // stride: only every so many rows and columns of pixels are lit. False: the pass was cancelled.
    virtual bool hasMapPasses() const { return false; }
    virtual bool mapPass(int /*index*/, float /*spacing*/, int /*stride*/, Film& /*film*/,
                         const CancelToken* /*cancel*/) const {
        return true;
    }
    // The layers of the picture, unfiltered.
    virtual LayeredPicture picture(std::shared_ptr<const Film> film) const = 0;
    // The beauty of that, of a film that others may add to meanwhile, under lockRow. Cheaper, where it can be, than a
    // snapshot of the film and its picture.
    virtual Preview preview(const Film& film) const;
};

// Throws Error that lists the integrators if there is none of this name.
std::unique_ptr<Integrator> makeIntegrator(const std::string& name, const RenderContext& context);
// The layers of its film. Every camera sample must add to the first one, which tells how many samples a pixel has.
// params: resolved.
std::vector<FilmLayerSpec> filmLayers(const std::string& integrator, const RenderParams& params, const Scene& scene);
std::vector<std::string> integratorNames();
// Whether this integrator has map passes.
bool usesMaps(const std::string& integrator);
// Whether this integrator renders participating media. Others need a scene without.
bool rendersMedia(const std::string& integrator);
// Whether two independent pictures of half of the samples can be had: RenderParams::independentHalves.
bool hasHalves(const std::string& integrator);

}  // namespace drc
