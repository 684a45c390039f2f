// Random training examples and shards of them, for tests.
#pragma once
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "maps/example_record.h"
#include "maps/example_shard_writer.h"

namespace drc {

inline std::vector<float> randomLight(size_t count, unsigned seed) {
    std::mt19937 random{seed};
    std::exponential_distribution<float> light(1);
    std::vector<float> values(count);
    for (float& v : values) v = light(random);
    return values;
}

inline TrainingExample randomExample(const MapLayout& layout, int inputs, unsigned seed) {
    const auto texels = size_t(layout.texels());
    std::mt19937 random{seed};
    std::uniform_real_distribution<float> uniform(0, 1);
    TrainingExample example;
    example.film = Vec2(uniform(random), uniform(random));
    example.bounces = int(seed % 3);
    if (seed % 2) example.time = uniform(random);
    for (int i = 0; i < inputs; ++i) {
        CapturedMap& map = example.inputs.emplace_back();
        map.origin = Vec3(1, 2, float(seed));
        map.frame = Frame::fromNormal(normalize(Vec3(1, 2, 3)));
        map.radiance = randomLight(3 * texels, seed * 100 + unsigned(i));
        map.distance = randomLight(texels, seed * 100 + 50 + unsigned(i));
        map.direct = map.radiance;
        for (float& v : map.direct) v *= uniform(random);
        map.albedo.resize(3 * texels);
        for (float& v : map.albedo) v = uniform(random);
        map.normal.resize(3 * texels);
        for (size_t t = 0; t < texels; ++t) {
            const Vec3 n = normalize(Vec3(uniform(random) - 0.5f, uniform(random) - 0.5f, uniform(random)));
            for (size_t c = 0; c < 3; ++c) map.normal[c * texels + t] = n[int(c)];
        }
    }
    example.target = randomLight(3 * texels, seed * 100 + 99);
    example.targetDeviation = randomLight(3 * texels, seed * 100 + 98);
    return example;
}

// Writes a complete shard of the given examples.
inline void writeShard(const std::string& path, const std::string& scene, const MapLayout& layout,
                       const std::vector<TrainingExample>& examples) {
    std::filesystem::remove(path);
    ShardHeader header;
    header.scene = scene;
    header.layout = layout;
    header.inputs = int(examples.front().inputs.size());
    header.targetSamples = 64;
    header.viewpoints = int(examples.size());
    ExampleShardWriter shard(path, header);
    for (size_t i = 0; i < examples.size(); ++i) {
        TrainingExample numbered = examples[i];
        numbered.viewpoint = int(i);
        shard.append(encodeExample(numbered, layout));
    }
}

}  // namespace drc
