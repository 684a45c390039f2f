// Training examples for the network: maps as a render captures them, and the same maps with many samples a texel as
// targets (Jiang and Kainz, section 4: the reference mode).
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
    // Viewpoints are primary points of camera rays. With tiles, there is one at random in each cell of a tiles x tiles
    // grid over the film, row by row; without, there are `spread` of them, spread evenly.
    int tiles = 0, spread = 128;
    int targetSamples = 64;  // per texel of the target, at least 2
    int inputs = 4;          // independent one-sample realisations of each map
    uint64_t seed = 0;

    int viewpoints() const { return tiles > 0 ? tiles * tiles : spread; }
};

// The header of a scene's shard. sceneHash: of the scene's file.
ShardHeader shardHeader(const ExampleSettings& settings, const std::string& scene, uint64_t sceneHash);

// The film position of the viewpoint's camera ray, in pixels.
Vec2 viewpointOnFilm(const ExampleSettings& settings, const PixelRegion& film, int viewpoint);

// None if the camera ray escapes or no light arrives. Deterministic for a seed and viewpoint.
std::optional<TrainingExample> makeExample(const PathTracer& tracer, const ExampleSettings& settings, int viewpoint);

// Makes the examples that the shard lacks, on all threads, and appends them in the order of their viewpoints: the file
// does not depend on the number of threads, nor on interruptions. done is called for each viewpoint in the file, by one
// thread at a time, with whether it gave an example. After `cancel` is raised, examples that were begun are still
// written.
void writeExamples(const PathTracer& tracer, const ExampleSettings& settings, ExampleShardWriter& shard,
                   const std::function<void(bool)>& done, const CancelToken* cancel);
// Writes the examples to a folder of PFM files instead, with the first input of each. If several viewpoints fall into
// one pixel, only the first is used. Returns how many examples existed already, for which done is not called;
// viewpoints without an example are tried again.
int writeExamples(const PathTracer& tracer, const ExampleSettings& settings, const IisptWriter& folder,
                  const std::function<void(bool)>& done, const CancelToken* cancel);

}  // namespace drc
