// A way to render: what it samples, what it keeps of that, and the picture that this comes to. A new one is a pair of
// files and its line in the list of integrator.cpp.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "base/stats.h"
#include "cache/map_denoiser.h"
#include "integrators/camera_sample.h"
#include "integrators/path_tracer.h"
#include "render/film.h"
#include "render/layered_picture.h"
#include "render/render_params.h"

namespace drc {

// What integrators are made from. All must outlive them.
struct RenderContext {
    const Scene& scene;
    const Accel& accel;
    const LightSampler& lights;
    const PathTracer& tracer;
    const RenderParams& params;      // resolved
    const MapDenoiser* mapDenoiser;  // null where the integrator has no radiance maps
    Stats* stats;                    // may be null
};

class Integrator {
  public:
    virtual ~Integrator() = default;

    // Of the film that it needs. All camera samples add to the first layer.
    virtual std::vector<FilmLayerSpec> layers() const = 0;
    // Takes one camera sample of pixel (x, y) into the film, whose row is locked. index: of the sample in its pixel.
    virtual void sample(int x, int y, uint32_t index, CameraSample& sample, Film& film) const = 0;
    // Whether it has passes of radiance maps too, and the one of this index. spacing: between maps, pixels; only pixels
    // on a lattice of this stride are lit. False: cancelled. maps: counts those captured.
    virtual bool hasMapPasses() const { return false; }
    virtual bool mapPass(int /*index*/, float /*spacing*/, int /*stride*/, Film& /*film*/,
                         const CancelToken* /*cancel*/) const {
        return true;
    }
    // The layers of the picture, unfiltered.
    virtual LayeredPicture picture(std::shared_ptr<const Film> film) const = 0;
};

// Throws Error that lists what there is.
std::unique_ptr<Integrator> makeIntegrator(const std::string& name, const RenderContext& context);
std::vector<std::string> integratorNames();
// Whether it has passes of radiance maps.
bool usesMaps(const std::string& integrator);

}  // namespace drc
