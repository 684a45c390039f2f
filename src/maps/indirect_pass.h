// A map pass: one pass of indirect light over the film. Maps are placed on a grid, captured and denoised; where the
// grid's maps do not serve (edges, small objects, corners), further maps are added; then every pixel gathers from the
// maps around it, which all pixels of the image share. Maps are made and released in bands from the top of the film to
// its bottom, so that the memory of a pass does not grow with the number of its maps.
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
    int primarySamples = 4;    // camera samples for each pixel and pass
    int gatherSamples = 8;     // directions that each of them gathers, divided among its maps
    float minCoverage = 0.1f;  // sum of a pixel's weights below which maps are added
    Interpolation interpolation = Interpolation::Geometry;
    int fillLevels = 3;  // how often the spacing is halved for added maps
    uint64_t seed = 0;
    std::shared_ptr<const MapDenoiser> denoiser;  // null: maps are used as they are captured
};

class IndirectPass {
  public:
    // All arguments must outlive the pass. stats may be null.
    IndirectPass(const PathTracer& tracer, const Sensor& sensor, const IndirectSettings& settings, Stats* stats);

    // Receives the value of one camera sample of a pixel (0 to primarySamples - 1) with the pixel filter's weight.
    using Add = std::function<void(int x, int y, int sample, const Rgb& value, float weight)>;

    // Estimates the indirect radiance of every pixel by its broad lobes (PathTracer::layers gives that of the glossy
    // ones): calls add primarySamples times for each pixel, from any thread. With a spacing of one pixel or less, each
    // camera sample gets a map of its own. False: cancelled, and some pixels have no value. The result does not depend
    // on the number of threads. stride: only every so many rows and columns of pixels are estimated, for a first look.
    bool run(int pass, float spacing, const Add& add, const CancelToken* cancel = nullptr, int stride = 1);

    // The number of maps that the last run captured.
    int mapCount() const { return mapCount_; }

  private:
    // The state of one pass.
    struct State {
        int pass = 0;
        int stride = 1;
        const CancelToken* cancel = nullptr;
        std::vector<size_t> filled;  // number of added maps, by level
        bool cancelled() const { return cancel && cancel->cancelled(); }
        bool skips(const PixelRegion& film, int x, int y) const {
            return (x - film.x0) % stride != 0 || (y - film.y0) % stride != 0;
        }
    };
    void captureGrid(PassMaps& maps, int band, const State& state);
    // Adds maps where the grid does not serve the band's pixels.
    void fillIn(PassMaps& maps, int band, float spacing, State& state);
    void gatherPixels(const PassMaps& maps, int band, const State& state, const Add& add) const;
    // Captures and denoises, in batches, the maps of sites whose film position is set. first: the number of maps that
    // this level of the pass already has.
    void captureSites(std::span<MapSite> sites, size_t first, size_t level, const State& state);
    bool runPerPixel(int pass, const Add& add, const CancelToken* cancel);
    // The indirect radiance of the broad lobes: from the maps, or path-traced if there are none. index: of the camera
    // sample.
    Rgb shade(const PrimaryHit& hit, std::span<const WeightedSite> sites, int x, int y, int index) const;
    // The primary point of camera sample `index` of a pixel, the same at each call. False: there is none, or none with
    // broad lobes; film and weight are set even then.
    bool broadHit(int x, int y, int index, Vec2& film, float& weight, PrimaryHit& hit) const;
    uint64_t stream(int x, int y, uint64_t purpose) const;

    const PathTracer& tracer_;
    const Sensor& sensor_;
    IndirectSettings settings_;
    Stats* stats_;
    std::atomic<int> mapCount_{0};
};

}  // namespace drc
