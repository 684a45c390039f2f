// A map pass: one pass of indirect light over the film. Maps are placed on a grid, captured and denoised; further maps
// are added where the grid's maps do not cover the pixels (edges, small objects, corners); then every pixel gathers
// from the maps around it. All pixels share the maps. Maps are made and released in bands from the top of the film to
// the bottom, so that the memory of a pass does not grow with its number of maps.
#pragma once
#include <atomic>
#include <functional>

#include "base/parallel.h"
#include "base/stats.h"
#include "maps/gather.h"
#include "maps/map_denoiser.h"
#include "maps/pass_maps.h"
#include "transport/camera_sample.h"

namespace drc {

struct IndirectSettings {
    CaptureSettings capture;
    int primarySamples = 4;    // camera samples per pixel in each pass
    int gatherSamples = 8;     // directions gathered per camera sample, distributed among its maps
    float minCoverage = 0.1f;  // threshold on the sum of a pixel's map weights; below it, maps are added
    Interpolation interpolation = Interpolation::Geometry;
    int fillLevels = 3;  // number of levels of added maps; each level halves the spacing
    uint64_t seed = 0;
    std::shared_ptr<const MapDenoiser> denoiser;  // null: captured maps are used without denoising
};

class IndirectPass {
  public:
    // All arguments must outlive the pass. stats may be null.
    IndirectPass(const PathTracer& tracer, const Sensor& sensor, const IndirectSettings& settings, Stats* stats);

    // Receives the value of camera sample `sample` (0 to primarySamples - 1) of a pixel, and the pixel filter's weight.
    using Add = std::function<void(int x, int y, int sample, const Rgb& value, float weight)>;

    // Estimates every pixel's indirect radiance from its broad lobes (PathTracer::layers covers the glossy ones). Calls
    // add primarySamples times per pixel, from any thread. spacing: distance between grid maps in pixels; if 1 or less,
    // each camera sample gets a map of its own. stride: for a first look, only every stride-th row and column of pixels
    // is estimated. Returns false if cancelled, in which case some pixels got no value. The result does not depend on
    // the number of threads.
    bool run(int pass, float spacing, const Add& add, const CancelToken* cancel = nullptr, int stride = 1);

    // The number of maps captured by the last run.
    int mapCount() const { return mapCount_; }

  private:
    // The state of one pass.
    struct State {
        int pass = 0;
        int stride = 1;
        const CancelToken* cancel = nullptr;
        std::vector<size_t> filled;  // number of maps added so far, by level
        bool cancelled() const { return cancel && cancel->cancelled(); }
        bool skips(const PixelRegion& film, int x, int y) const {
            return (x - film.x0) % stride != 0 || (y - film.y0) % stride != 0;
        }
    };
    void captureGrid(PassMaps& maps, int band, const State& state);
    // Adds maps where the grid's maps do not cover the band's pixels.
    void fillIn(PassMaps& maps, int band, float spacing, State& state);
    void gatherPixels(const PassMaps& maps, int band, const State& state, const Add& add) const;
    // Captures and denoises, in batches, the maps of sites whose film position is set. first: number of maps already
    // captured in this level of the pass.
    void captureSites(std::span<MapSite> sites, size_t first, size_t level, const State& state);
    bool runPerPixel(int pass, const Add& add, const CancelToken* cancel);
    // The indirect radiance from the broad lobes: gathered from the maps, or path-traced if `sites` is empty. index:
    // index of the camera sample.
    Rgb shade(const PrimaryHit& hit, std::span<const WeightedSite> sites, int x, int y, int index) const;
    // Finds the primary hit of camera sample `index` of a pixel; repeated calls give the same hit. Returns false if the
    // ray escapes or the hit has no broad lobes; even then film and weight are set.
    bool broadHit(int x, int y, int index, Vec2& film, float& weight, PrimaryHit& hit) const;
    uint64_t stream(int x, int y, uint64_t purpose) const;

    const PathTracer& tracer_;
    const Sensor& sensor_;
    IndirectSettings settings_;
    Stats* stats_;
    std::atomic<int> mapCount_{0};
};

}  // namespace drc
