// Examples for the network to learn from: maps as a render captures them, and what they would be with many samples
// (Jiang and Kainz, section 4: the reference mode).
#pragma once
#include <string>
#include <vector>

#include "base/parallel.h"
#include "base/progress.h"
#include "cache/map_capture.h"

namespace drc {

struct ExampleSettings {
    MapLayout layout{Projection::EqualArea, 32};
    int viewpoints = 128;    // primary points of camera rays, spread over the film
    int targetSamples = 64;  // per texel of the target
    int inputs = 4;          // independent one-sample realisations of each map
    uint64_t seed = 0;
};

// Planar arrays as CapturedMap's, one example after the other. Viewpoints whose ray escapes, and maps that receive no
// light at all, give no example, so count may be less than asked for.
struct ExampleSet {
    int count = 0;
    std::vector<float> radiance;  // [count][inputs][3][N][N]
    std::vector<float> normal;    // [count][inputs][3][N][N]
    std::vector<float> distance;  // [count][inputs][1][N][N]
    std::vector<float> target;    // [count][3][N][N]
};

// Deterministic by seed, whatever the number of threads. progress, if not null, is advanced by one a viewpoint.
ExampleSet makeExamples(const PathTracer& tracer, const ExampleSettings& settings, Progress* progress,
                        const CancelToken* cancel);

// A safetensors file, format "drc-examples-1", with the settings and `scene` in its metadata. All or nothing.
void writeExamples(const std::string& path, const ExampleSet& examples, const ExampleSettings& settings,
                   const std::string& scene);

}  // namespace drc
