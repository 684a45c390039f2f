#include "dataset.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.h"
#include "base/log.h"
#include "neural/safetensors.h"

namespace drc {
namespace {

uint64_t hashName(const std::string& name) { return hashBytes(name.data(), name.size()); }

}  // namespace

Dataset::Dataset(const std::vector<std::string>& paths) {
    const std::vector<std::string> found = findExamples(paths);
    for (const std::string& path : found) {
        try {
            addShard(path);
        } catch (const Error& error) {
            logWarning(fmt::format("{} (shard skipped)", error.what()));
            ++skipped_;
        }
    }
    if (entries_.empty())
        throw Error(found.empty() ? "no examples in the data folders; `drc reference` writes them"
                                  : "no usable example in the data");
}

void Dataset::addShard(const std::string& path) {
    auto shard = openExamples(path);
    const MapLayout& layout = shard->layout();
    if (!shards_.empty() && (layout.projection() != projection_ || layout.size() != mapSize_))
        throw Error(
            SourceLocation{path},
            fmt::format("{0} maps of {1}x{1}; the shards before it have {2} maps of {3}x{3}",
                        projectionName(layout.projection()), layout.size(), projectionName(projection_), mapSize_));
    projection_ = layout.projection();
    mapSize_ = layout.size();
    for (int i = 0; i < shard->count(); ++i) entries_.push_back({uint32_t(shards_.size()), uint32_t(i)});
    shards_.push_back(std::move(shard));
}

std::set<std::string> Dataset::scenes() const {
    std::set<std::string> names;
    for (const auto& shard : shards_)
        if (shard->count() > 0) names.insert(shard->scene());
    return names;
}

std::string Dataset::contentHash() const {
    std::string all;
    for (const auto& shard : shards_) all += shard->contentHash();
    return fmt::format("{:016x}", hashName(all));
}

void Dataset::load(size_t i, int realisation, Example& example) const {
    const Entry entry = entries_.at(i);
    thread_local TrainingExample stored;
    shards_[entry.shard]->load(int(entry.index), realisation, 1, stored);
    example.size = mapSize_;
    example.radiance.swap(stored.inputs.front().radiance);
    example.normal.swap(stored.inputs.front().normal);
    example.distance.swap(stored.inputs.front().distance);
    example.albedo.swap(stored.inputs.front().albedo);
    example.direct.swap(stored.inputs.front().direct);
    example.target.swap(stored.target);
}

Split splitByScene(const Dataset& dataset, const std::vector<std::string>& names, double fraction) {
    Split split;
    const std::set<std::string> scenes = dataset.scenes();
    for (const std::string& name : names) {
        if (!scenes.count(name)) throw Error(fmt::format("there is no example of the validation scene '{}'", name));
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
        throw Error("all scenes are for validation; none is left for training");
    for (size_t i = 0; i < dataset.size(); ++i)
        (split.validationScenes.count(dataset.scene(i)) ? split.validation : split.training).push_back(i);
    if (split.validation.empty() && fraction > 0 && split.training.size() > 1) {
        logWarning("all examples are of one scene; validation uses other points of the same scene");
        const size_t kept = std::clamp<size_t>(size_t((1 - fraction) * double(dataset.size())), 1, dataset.size() - 1);
        split.validation.assign(split.training.begin() + std::ptrdiff_t(kept), split.training.end());
        split.training.resize(kept);
    }
    return split;
}

}  // namespace drc
