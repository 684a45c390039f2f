// Training examples for the network: inputs are maps as captured in a render, targets the same maps with many samples
// per texel (Jiang and Kainz, section 4: the reference mode).
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "base/parallel.h"
#include "maps/example_record.h"
#include "maps/example_shard_writer.h"
#include "maps/iispt_folder.h"

namespace drc {

struct ExampleSettings {
    MapLayout layout{Projection::EqualArea, 32};
    // Viewpoints are the primary hits of camera rays. With tiles > 0, one ray is placed at random in each cell of a
    // tiles x tiles grid over the film, row by row; with tiles = 0, `spread` rays are spread evenly over the film.
    int tiles = 0, spread = 128;
    int targetSamples = 64;  // samples per texel of the target, at least 2
    int inputs = 4;          // independent realisations of each map, with one sample per texel
    uint64_t seed = 0;

    int viewpoints() const { return tiles > 0 ? tiles * tiles : spread; }
};

// The header of a scene's shard. sceneHash: hash of the scene file.
ShardHeader shardHeader(const ExampleSettings& settings, const std::string& scene, uint64_t sceneHash);

// The film position of the viewpoint's camera ray, in pixels.
Vec2 viewpointOnFilm(const ExampleSettings& settings, const PixelRegion& film, int viewpoint);

// Makes the example of a viewpoint; none if the camera ray escapes or the target is black. Deterministic for a seed and
// viewpoint.
std::optional<TrainingExample> makeExample(const PathTracer& tracer, const ExampleSettings& settings, int viewpoint);

// Makes the examples missing from the shard, on all threads, and appends them in viewpoint order, so that the file
// depends neither on the number of threads nor on interruptions. Calls done(gaveExample) for each viewpoint written,
// from one thread at a time. After `cancel` is raised, examples in progress are still finished and written.
void writeExamples(const PathTracer& tracer, const ExampleSettings& settings, ExampleShardWriter& shard,
                   const std::function<void(bool)>& done, const CancelToken* cancel);
// Writes the examples to a folder of PFM files instead, each with its first input. If several viewpoints fall into one
// pixel, only the first is used. Returns the number of examples that existed already, for which done is not called;
// viewpoints without an example are tried again.
int writeExamples(const PathTracer& tracer, const ExampleSettings& settings, const IisptWriter& folder,
                  const std::function<void(bool)>& done, const CancelToken* cancel);

}  // namespace drc
