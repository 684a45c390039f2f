#include "dataset.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "base/error.h"
#include "base/log.h"

namespace drc {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> shardPaths(const std::vector<std::string>& paths) {
    std::vector<std::string> shards;
    for (const std::string& path : paths) {
        std::error_code error;
        if (!fs::is_directory(path, error)) {
            if (!fs::exists(path, error)) throw Error(SourceLocation{path}, "no such file or directory");
            shards.push_back(path);
            continue;
        }
        for (const auto& entry : fs::recursive_directory_iterator(path))
            if (entry.is_regular_file() && entry.path().extension() == ".safetensors")
                shards.push_back(entry.path().string());
    }
    // The order in which a directory is listed must not change the training.
    std::sort(shards.begin(), shards.end());
    shards.erase(std::unique(shards.begin(), shards.end()), shards.end());
    return shards;
}

uint64_t hashName(const std::string& name) { return hashBytes(name.data(), name.size()); }

}  // namespace

Dataset::Dataset(const std::vector<std::string>& paths) {
    const std::vector<std::string> found = shardPaths(paths);
    for (const std::string& path : found) {
        try {
            addShard(path);
        } catch (const Error& error) {
            logWarning(fmt::format("{} (shard skipped)", error.what()));
            ++skipped_;
        }
    }
    if (entries_.empty())
        throw Error(found.empty() ? "no *.safetensors shard in the data directories" : "no usable example in the data");
}

void Dataset::addShard(const std::string& path) {
    auto file = std::make_unique<SafetensorsFile>(path);
    const SourceLocation where{path};
    if (file->metadata("format", "") != "drc-examples-1")
        throw Error(where,
                    fmt::format("metadata 'format' is '{}', not 'drc-examples-1'", file->metadata("format", "")));
    const Projection projection = parseProjection(file->metadata("projection", ""));
    const TensorView& radiance = file->tensor("radiance");
    if (radiance.shape.size() != 5 || radiance.shape[2] != 3 || radiance.shape[3] != radiance.shape[4] ||
        radiance.shape[1] < 1 || radiance.shape[3] < 1 || radiance.shape[3] > 1024)
        throw Error(where, "tensor 'radiance' is not [N][R][3][S][S]");
    const int64_t n = radiance.shape[0], r = radiance.shape[1], s = radiance.shape[3];
    if (file->tensor("normal").shape != radiance.shape) throw Error(where, "tensor 'normal' is not [N][R][3][S][S]");
    if (file->tensor("distance").shape != std::vector<int64_t>{n, r, 1, s, s})
        throw Error(where, "tensor 'distance' is not [N][R][1][S][S]");
    if (file->tensor("target").shape != std::vector<int64_t>{n, 3, s, s})
        throw Error(where, "tensor 'target' is not [N][3][S][S]");
    if (!shards_.empty() && (projection != projection_ || s != mapSize_))
        throw Error(where,
                    fmt::format("{} maps of {}x{}; the shards before it have {} maps of {}x{}",
                                projectionName(projection), s, s, projectionName(projection_), mapSize_, mapSize_));
    projection_ = projection;
    mapSize_ = int(s);
    const auto shard = uint32_t(shards_.size());
    shards_.push_back({std::move(file), "", int(r)});
    const SafetensorsFile& kept = *shards_.back().file;
    shards_.back().scene = kept.metadata("scene", fs::path(path).stem().string());
    for (int64_t i = 0; i < n; ++i) entries_.push_back({shard, uint32_t(i)});
}

std::set<std::string> Dataset::scenes() const {
    std::set<std::string> names;
    for (const Shard& shard : shards_) names.insert(shard.scene);
    return names;
}

std::string Dataset::contentHash() const {
    std::string all;
    for (const Shard& shard : shards_) all += shard.file->contentHash();
    return fmt::format("{:016x}", hashName(all));
}

void Dataset::load(size_t i, int realisation, Example& example) const {
    const Entry entry = entries_.at(i);
    const Shard& shard = shards_[entry.shard];
    example.resize(mapSize_);
    const size_t texels = size_t(mapSize_) * mapSize_;
    const size_t map = size_t(entry.index) * size_t(shard.realisations) + size_t(realisation);
    shard.file->tensor("radiance").toFloat(map * 3 * texels, 3 * texels, example.radiance.data());
    shard.file->tensor("normal").toFloat(map * 3 * texels, 3 * texels, example.normal.data());
    shard.file->tensor("distance").toFloat(map * texels, texels, example.distance.data());
    shard.file->tensor("target").toFloat(entry.index * 3 * texels, 3 * texels, example.target.data());
}

Split splitByScene(const Dataset& dataset, const std::vector<std::string>& names, double fraction) {
    Split split;
    const std::set<std::string> scenes = dataset.scenes();
    for (const std::string& name : names) {
        if (!scenes.count(name)) throw Error(fmt::format("no example is of the validation scene '{}'", name));
        split.validationScenes.insert(name);
    }
    if (names.empty() && fraction > 0 && scenes.size() > 1) {
        const auto byHash = [](const std::string& a, const std::string& b) { return hashName(a) < hashName(b); };
        for (const std::string& scene : scenes)
            if (double(hashName(scene) >> 11) * 0x1p-53 < fraction) split.validationScenes.insert(scene);
        if (split.validationScenes.empty())
            split.validationScenes.insert(*std::min_element(scenes.begin(), scenes.end(), byHash));
        if (split.validationScenes.size() == scenes.size())
            split.validationScenes.erase(*std::max_element(scenes.begin(), scenes.end(), byHash));
    }
    if (split.validationScenes.size() == scenes.size())
        throw Error("every scene is a validation scene: nothing is left to learn from");
    for (size_t i = 0; i < dataset.size(); ++i)
        (split.validationScenes.count(dataset.scene(i)) ? split.validation : split.training).push_back(i);
    if (split.validation.empty() && fraction > 0 && split.training.size() > 1) {
        logWarning("all examples are of one scene: validation is on other points of the same scene");
        const size_t kept = std::clamp<size_t>(size_t((1 - fraction) * double(dataset.size())), 1, dataset.size() - 1);
        split.validation.assign(split.training.begin() + std::ptrdiff_t(kept), split.training.end());
        split.training.resize(kept);
    }
    return split;
}

}  // namespace drc
