// A training example, and its encoding as a record of a shard (example_shard.h).
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "maps/map_capture.h"

namespace drc {

struct TrainingExample {
    int viewpoint = 0;          // index among the viewpoints requested
    Vec2 film{0.f};             // film position of the camera ray, pixels
    int bounces = 0;            // specular vertices between the camera and the map's origin: mirrors and smooth glass
    std::optional<float> time;  // time of the map's rays; if unset, each has its own within the shutter interval
    // Independent realisations of the map, with one sample per texel. All have the same origin and frame.
    std::vector<CapturedMap> inputs;
    std::vector<float> target;  // [3][N*N], as CapturedMap::radiance, estimated with many samples per texel
    // [3][N*N], as CapturedMap::deviation: standard deviation of the target. Empty if unknown.
    std::vector<float> targetDeviation;
};

// Whether all values are possible in a capture (finite, radiance not negative) and the target is not black.
bool isSound(const TrainingExample& example);

// Encodes an example as a zstd frame with a checksum of its content. Radiance and distances are stored as halves. Each
// map is scaled by a power of two that brings its largest value to [2^14, 2^15): values down to 2^-29 of the largest
// keep 11 bits, and values below 2^-39 of it become zero. Normals have 16 bits per component, albedos 8. An unknown
// deviation is stored as zero. Equal examples give equal bytes. Throws Error if the example is not sound.
std::string encodeExample(const TrainingExample& example, const MapLayout& layout);

// Decodes a record: only the inputs [first, first + count) of its `inputs` inputs, and everything else. Reuses the
// buffers of `example`, and never allocates more than an example of this layout and count needs, whatever sizes the
// record contains. Throws Error, without a file name, if the record is damaged or contains values that are impossible
// in a capture.
void decodeExample(std::string_view record, const MapLayout& layout, int inputs, int first, int count,
                   TrainingExample& example);

}  // namespace drc
