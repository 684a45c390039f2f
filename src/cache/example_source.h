// Where examples are read from: one scene's, wherever and however they are stored.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "cache/example_record.h"

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
    int inputs() const { return inputs_; }   // realisations of each example, at least 1
    int count() const { return count_; }     // examples that can be loaded
    bool guides() const { return guides_; }  // whether CapturedMap::albedo and direct are there
    // One line that begins with the path: what of it cannot be used. Empty if nothing is wrong.
    const std::string& damage() const { return damage_; }

    // Example `index` with the inputs [first, first + count), all of which exist. The buffers of `example` are reused;
    // nothing else is kept, and any number of threads may load. Throws Error that begins with the path if the file is
    // no longer what it was.
    virtual void load(int index, int first, int count, TrainingExample& example) const = 0;
    // 16 hexadecimal digits that tell one content from another. Not cryptographic.
    virtual std::string contentHash() const = 0;

  protected:
    std::string path_, scene_, damage_;
    MapLayout layout_{Projection::EqualArea, 32};
    int inputs_ = 1, count_ = 0;
    bool guides_ = true;
};

// What openExamples can open, sorted by path: files as named; of folders, every shard and every folder of PFM files
// (iispt_folder.h) in them, at any depth. Throws Error for a path
// that does not exist.
std::vector<std::string> findExamples(const std::vector<std::string>& paths);

// Reads everything once, to know what can be used; warns in one line if that is not all. Throws Error that begins with
// the path if it holds no examples as `drc reference` writes them.
std::unique_ptr<ExampleSource> openExamples(const std::string& path);

}  // namespace drc
