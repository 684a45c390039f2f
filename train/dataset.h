// The examples of `drc reference` (cache/example_source.h) as one set.
#pragma once
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "augmentation.h"
#include "cache/example_source.h"

namespace drc {

// Examples are read when asked for, so that a data set may be larger than memory.
class Dataset {
  public:
    // All that is under the folders (or files) named. What cannot be read is reported as a warning and skipped, as are
    // shards whose projection or map size is not that of the first; throws drc::Error if nothing is left.
    explicit Dataset(const std::vector<std::string>& paths);

    size_t size() const { return entries_.size(); }
    int mapSize() const { return mapSize_; }
    Projection projection() const { return projection_; }
    int skippedShards() const { return skipped_; }
    // Realisations of example i; at least 1.
    int realisations(size_t i) const { return shards_[entries_[i].shard]->inputs(); }
    const std::string& scene(size_t i) const { return shards_[entries_[i].shard]->scene(); }
    std::set<std::string> scenes() const;
    // Changes when any shard changes: for the provenance of weights.
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

// Example indices for training and for validation, which share no scene.
struct Split {
    std::vector<size_t> training, validation;
    std::set<std::string> validationScenes;
};

// Scenes named in `names` validate; if it is empty, those whose name's hash falls below `fraction` do, so that a scene
// keeps its side when others join. At least one scene on each side; a data set of a single scene is cut in two by
// example, with a warning. Throws drc::Error for a name that no example has.
Split splitByScene(const Dataset& dataset, const std::vector<std::string>& names, double fraction);

}  // namespace drc
