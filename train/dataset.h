// Training examples in safetensors shards, as `drc reference` writes them. Tensors (F32, F16 or BF16):
//   radiance [N][R][3][S][S]  R independent noisy maps of each of N points
//   normal   [N][R][3][S][S]  distance [N][R][1][S][S]  what those maps' rays met
//   target   [N][3][S][S]     the converged map
// and metadata: format "drc-examples-1", projection "equal-area" or "latlong", scene, and whatever else.
#pragma once
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "augmentation.h"
#include "neural/safetensors.h"

namespace drc {

// The shards stay mapped; examples are converted when asked for, so that a data set may be larger than memory.
class Dataset {
  public:
    // All *.safetensors under the directories (or files) named. A bad shard is reported as a warning and skipped;
    // throws drc::Error if nothing is left, or if shards differ in projection or map size.
    explicit Dataset(const std::vector<std::string>& paths);

    size_t size() const { return entries_.size(); }
    int mapSize() const { return mapSize_; }
    Projection projection() const { return projection_; }
    int skippedShards() const { return skipped_; }
    // Realisations of example i; at least 1.
    int realisations(size_t i) const { return shards_[entries_[i].shard].realisations; }
    const std::string& scene(size_t i) const { return shards_[entries_[i].shard].scene; }
    std::set<std::string> scenes() const;
    // Changes when any shard changes: for the provenance of weights.
    std::string contentHash() const;

    void load(size_t i, int realisation, Example& example) const;

  private:
    struct Shard {
        std::unique_ptr<SafetensorsFile> file;
        std::string scene;
        int realisations = 1;
    };
    struct Entry {
        uint32_t shard, index;
    };
    void addShard(const std::string& path);

    std::vector<Shard> shards_;
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
