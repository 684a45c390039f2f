// How close an enhancer's maps come to converged ones: the measures of one map, and the examples they are taken over.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "cache/enhancer.h"
#include "cache/example_source.h"

namespace drc {

// Of one map against its target. Both are divided by the target's mean, so that bright and dark examples weigh alike.
struct MapScores {
    double l1 = 0;          // mean absolute difference over the hemisphere and the three channels
    double ssim = 0;        // see scoreMap; NaN if the map is smaller than SSIM's window
    double irradiance = 0;  // relative squared error of the irradiance, mean over 64 normals and three channels
};

// Mean over texels, weighted by solid angle, and channels. Planar [3][N*N], as all radiance here.
double hemisphereMean(std::span<const float> radiance, const MapLayout& layout);

// `radiance` scaled to the mean of `target`. A black map stays black.
std::vector<float> withMeanOf(std::span<const float> radiance, std::span<const float> target, const MapLayout& layout);

// What the target's luminances are multiplied by to be shown: its 99th percentile is white. Where less than a hundredth
// of the map is lit, its brightest texel is. The target must not be black.
float exposureOf(std::span<const float> target, const MapLayout& layout);

// The target's mean must be positive.
// SSIM is that of `drc compare` between the luminances of the two maps, shown as grey pictures under one exposure
// (exposureOf): what is brighter than white is clipped, the rest sRGB-encoded. The window is 11 x 11 texels.
// Irradiance is sampled at the normals of an 8 x 8 equal-area map of the hemisphere; light below the map's horizon
// counts as none. Its error is (e - t)^2 / (t^2 + 0.01), e and t irradiances over pi in units of the target's mean.
MapScores scoreMap(std::span<const float> radiance, std::span<const float> target, const MapLayout& layout);

// Both ways to look at the energy of an example's maps.
struct ExampleScores {
    MapScores asRendered;   // with the energy that the enhancer leaves it: that of the captured map
    MapScores equalEnergy;  // with the target's mean: what is wrong with the shape alone
};

struct EvaluatedExample {
    int viewpoint = 0;                  // as TrainingExample::viewpoint
    Vec2 film{0.f};                     // as TrainingExample::film
    std::vector<ExampleScores> scores;  // one an enhancer: the mean over realisations, which are not independent
};

// Runs the enhancers over the first `inputs` realisations of each example (at most those there are), eight maps at a
// time on all threads. One entry an example, in the order of `examples`.
std::vector<EvaluatedExample> evaluateEnhancers(const ExampleSource& examples,
                                                std::span<const Enhancer* const> enhancers, int inputs);

}  // namespace drc
