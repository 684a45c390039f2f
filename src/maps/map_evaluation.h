// Compares the output of map denoisers with converged maps: error measures for one map, and an evaluation over a set of
// examples.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "maps/example_source.h"
#include "maps/map_denoiser.h"

namespace drc {

// Errors of one map against its target. Both are first divided by the target's mean, so that bright and dark examples
// weigh the same.
struct MapScores {
    double l1 = 0;          // mean absolute difference over the hemisphere and the three channels
    double ssim = 0;        // see scoreMap(); NaN if the map is smaller than SSIM's window
    double irradiance = 0;  // relative squared error of the irradiance, averaged over 64 normals and three channels
};

// Mean radiance over the hemisphere (texels weighted by solid angle) and over the channels. All maps in this file are
// planar, [3][N*N].
double hemisphereMean(std::span<const float> radiance, const MapLayout& layout);

// `radiance` scaled so that its mean equals that of `target`. A black map stays black.
std::vector<float> withMeanOf(std::span<const float> radiance, std::span<const float> target, const MapLayout& layout);

// Exposure for viewing the target: the factor that maps the 99th percentile of its luminance to white. If less than 1 %
// of the map is lit, its brightest texel is mapped to white instead. The target must not be black.
float exposureOf(std::span<const float> target, const MapLayout& layout);

// Scores a map. The target's mean must be positive. SSIM is the measure of `drc compare`, on the luminances of both
// maps as grey images under the target's exposure (exposureOf): values above white are clipped, the others
// sRGB-encoded. The window is 11 x 11 texels. The irradiance is computed for the normals of an 8 x 8 equal-area map of
// the hemisphere; directions below the map's horizon contribute nothing. Its error is (e - t)^2 / (t^2 + 0.01), where e
// and t are the irradiances from map and target, divided by pi and by the target's mean.
MapScores scoreMap(std::span<const float> radiance, std::span<const float> target, const MapLayout& layout);

// The errors of an example, before and after correcting its overall energy.
struct ExampleScores {
    MapScores asRendered;   // with the energy of the denoiser's output, which is the captured map's
    MapScores equalEnergy;  // after scaling to the target's mean: only the error of the shape
};

struct EvaluatedExample {
    int viewpoint = 0;                  // as TrainingExample::viewpoint
    Vec2 film{0.f};                     // as TrainingExample::film
    std::vector<ExampleScores> scores;  // one per denoiser: mean over the (not independent) realisations
};

// Runs the map denoisers on the first `inputs` realisations of each example (or on all, if the examples have fewer), in
// batches of eight maps, on all threads. Returns one entry per example, in the order of `examples`.
std::vector<EvaluatedExample> evaluateMapDenoisers(const ExampleSource& examples,
                                                   std::span<const MapDenoiser* const> mapDenoisers, int inputs);

}  // namespace drc
