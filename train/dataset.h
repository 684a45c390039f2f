// A data set made of the examples that `drc reference` writes (cache/example_source.h).
#pragma once
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "augmentation.h"
#include "maps/example_source.h"

namespace drc {

// Examples are read on demand, so that a data set may be larger than memory.
class Dataset {
  public:
    // Opens everything below the given folders (or files). Shards that cannot be read, or whose projection or map size
    // differs from that of the first, are skipped with a warning. Throws drc::Error if none remain.
    explicit Dataset(const std::vector<std::string>& paths);

    size_t size() const { return entries_.size(); }
    int mapSize() const { return mapSize_; }
    Projection projection() const { return projection_; }
    int skippedShards() const { return skipped_; }
    // Number of realisations of example i; at least 1.
    int realisations(size_t i) const { return shards_[entries_[i].shard]->inputs(); }
    const std::string& scene(size_t i) const { return shards_[entries_[i].shard]->scene(); }
    std::set<std::string> scenes() const;
    // Hash of the contents of all shards, recorded with the weights.
    std::string contentHash() const;

    void load(size_t i, int realisation, Example& example) const;

  private:
    struct Entry {
        uint32_t shard, index;
    };
    void addShard(const std::string& path);

    std::vector<std::unique_ptr<ExampleSource>> shards_;
    std::vector<Entry> entries_;
    int mapSize_ = 0;
    Projection projection_ = Projection::EqualArea;
    int skipped_ = 0;
};

// Indices of the examples for training and for validation. No scene is in both.
struct Split {
    std::vector<size_t> training, validation;
    std::set<std::string> validationScenes;
};

// The scenes in `names` are for validation. If `names` is empty, the scenes whose hashed name is below `fraction` are,
// so that adding scenes does not move others from one set to the other. Each set gets at least one scene; a data set
// with a single scene is split by example, with a warning. Throws drc::Error for a name that no example has.
Split splitByScene(const Dataset& dataset, const std::vector<std::string>& names, double fraction);

}  // namespace drc
