// Examples for the network to learn from: maps as a render captures them, and what they would be with many samples
// (Jiang and Kainz, section 4: the reference mode).
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "base/parallel.h"
#include "cache/example_record.h"
#include "cache/example_shard_writer.h"
#include "cache/iispt_folder.h"

namespace drc {

struct ExampleSettings {
    MapLayout layout{Projection::EqualArea, 32};
    // Viewpoints: primary points of camera rays. With tiles, one at random in each cell of a tiles x tiles grid over
    // the film, row by row; with none, `spread` of them, spread evenly.
    int tiles = 0, spread = 128;
    int targetSamples = 64;  // per texel of the target, at least 2
    int inputs = 4;          // independent one-sample realisations of each map
    uint64_t seed = 0;

    int viewpoints() const { return tiles > 0 ? tiles * tiles : spread; }
};

// The header of the shard of a scene. sceneHash: of the scene's file.
ShardHeader shardHeader(const ExampleSettings& settings, const std::string& scene, uint64_t sceneHash);

// Where on the film the viewpoint's ray goes through, pixels.
Vec2 viewpointOnFilm(const ExampleSettings& settings, const PixelRegion& film, int viewpoint);

// None where the camera's ray escapes, and where no light at all arrives. Deterministic by seed and viewpoint.
std::optional<TrainingExample> makeExample(const PathTracer& tracer, const ExampleSettings& settings, int viewpoint);

// The viewpoints that the shard lacks, on all threads, appended in their order: the file does not depend on the number
// of threads, nor on interruptions. done is called, by one thread at a time, for each viewpoint in the file, with
// whether it gave an example. When `cancel` is raised, what was begun is still written.
void writeExamples(const PathTracer& tracer, const ExampleSettings& settings, ExampleShardWriter& shard,
                   const std::function<void(bool)>& done, const CancelToken* cancel);
// The same into a folder of PFM files, which takes the first input of each. Of viewpoints in one pixel it gets the
// first. Returns how many were there already, for which done is not called; those without an example are tried again.
int writeExamples(const PathTracer& tracer, const ExampleSettings& settings, const IisptWriter& folder,
                  const std::function<void(bool)>& done, const CancelToken* cancel);

}  // namespace drc
