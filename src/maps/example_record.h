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
    int bounces = 0;            // specular vertices between the camera and the map: mirrors and faces of smooth glass
    std::optional<float> time;  // time of the map's rays; if unset, every ray has its own within the shutter interval
    // Independent realisations of the map, with one sample per texel. They have the same origin and frame.
    std::vector<CapturedMap> inputs;
    std::vector<float> target;  // [3][N*N], as CapturedMap::radiance, estimated with many samples per texel
    // [3][N*N], as CapturedMap::deviation: standard deviation of the target. Empty if unknown.
    std::vector<float> targetDeviation;
};

// Whether all values can come from a capture (finite, radiance not negative) and the target is not black.
bool isSound(const TrainingExample& example);

// Encodes an example as a zstd frame with a checksum of its content. Radiance and distances are stored as halves,
// scaled for each map by a power of two that puts its largest value just below the largest half: values down to 2^-29
// of the largest keep 11 bits, and values below 2^-39 of it become zero. Normals are stored with 16 bits per component,
// albedos with 8. An unknown deviation is stored as zero. Equal examples give equal bytes. Throws Error if the example
// is not sound.
std::string encodeExample(const TrainingExample& example, const MapLayout& layout);

// Decodes the inputs [first, first + count) of the `inputs` that the record has, and everything else. Reuses the
// buffers of `example`, and never allocates more than such an example needs, whatever the record claims. Throws Error,
// without a file name, if the record is damaged or contains values that no capture gives.
void decodeExample(std::string_view record, const MapLayout& layout, int inputs, int first, int count,
                   TrainingExample& example);

}  // namespace drc
