// One example for the network to learn from, and its bytes as a record of a shard (example_shard.h).
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cache/map_capture.h"

namespace drc {

struct TrainingExample {
    int viewpoint = 0;          // its number among those asked for
    Vec2 film{0.f};             // where the camera's ray went through the film, pixels
    int bounces = 0;            // mirrors and faces of smooth glass between the camera and the map
    std::optional<float> time;  // of the map's rays; none: each its own, while the shutter was open
    // Independent one-sample realisations of the map. All have one origin and frame.
    std::vector<CapturedMap> inputs;
    std::vector<float> target;  // [3][N*N], as CapturedMap::radiance, with many samples
    // [3][N*N], as CapturedMap::deviation: how far the target may be from converged. Empty if that is not known.
    std::vector<float> targetDeviation;
};

// Whether all numbers are what a capture yields (finite, light not negative) and the target is not black.
bool isSound(const TrainingExample& example);

// A zstd frame with a checksum of its content. Light and distances are stored as halves, each map's in units of a power
// of two of its own, which puts its largest value just below the largest half: values keep 11 bits down to 2^-29 of
// that one, and vanish below 2^-39. Normals have 16 bits a component, albedos 8. A missing deviation is written as
// zero. The same example gives the same bytes. Throws Error if the example is not sound.
std::string encodeExample(const TrainingExample& example, const MapLayout& layout);

// The inputs [first, first + count) of the `inputs` that the record has, and all else; `example`'s buffers are reused.
// Allocates no more than such an example needs, whatever the record claims. Throws Error, without a file's name, if the
// record is damaged, or holds what no capture yields.
void decodeExample(std::string_view record, const MapLayout& layout, int inputs, int first, int count,
                   TrainingExample& example);

}  // namespace drc
