// Interface for reading the training examples of one scene, independent of the file format.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "maps/example_record.h"

namespace drc {

class ExampleSource {
  public:
    virtual ~ExampleSource() = default;
    ExampleSource() = default;
    ExampleSource(const ExampleSource&) = delete;
    ExampleSource& operator=(const ExampleSource&) = delete;

    const std::string& path() const { return path_; }
    const std::string& scene() const { return scene_; }
    const MapLayout& layout() const { return layout_; }
    int inputs() const { return inputs_; }   // realisations per example, at least 1
    int count() const { return count_; }     // number of examples that can be loaded
    bool guides() const { return guides_; }  // whether the maps have CapturedMap::albedo and CapturedMap::direct
    // One line that begins with the path and says which examples are unusable. Empty if there is no damage.
    const std::string& damage() const { return damage_; }

    // Loads example `index` with its inputs [first, first + count), which must exist. Reuses the buffers of `example`.
    // Thread-safe. Throws Error, beginning with the path, if the file has changed since it was opened.
    virtual void load(int index, int first, int count, TrainingExample& example) const = 0;
    // A 64-bit hash of the content, as 16 hexadecimal digits. Not cryptographic.
    virtual std::string contentHash() const = 0;

  protected:
    std::string path_, scene_, damage_;
    MapLayout layout_{Projection::EqualArea, 32};
    int inputs_ = 1, count_ = 0;
    bool guides_ = true;
};

// Lists the paths for openExamples(), sorted: files as given; for folders, all shards and all folders of PFM files
// (iispt_folder.h) in them, at any depth. Throws Error for a path that does not exist.
std::vector<std::string> findExamples(const std::vector<std::string>& paths);

// Opens a shard or a folder of PFM files, and reads it once to find the usable examples. Logs one line as a warning if
// some are unusable. Throws Error, beginning with the path, if the contents are not examples in a format that `drc
// reference` writes.
std::unique_ptr<ExampleSource> openExamples(const std::string& path);

}  // namespace drc
