// Reads a shard of examples (shard_format.h).
#pragma once
#include <vector>

#include "base/mapped_file.h"
#include "cache/example_source.h"
#include "cache/shard_format.h"

namespace drc {

// The file stays mapped; examples are unpacked when asked for, so that a data set may be larger than memory. The file
// may grow meanwhile, as when `drc reference` still writes it: what came later is not seen.
class ExampleShard final : public ExampleSource {
  public:
    // Checks every record, on all threads. Those that are damaged are left out, see damage(); the sound ones before
    // and after them are there. Throws Error if the header is none.
    explicit ExampleShard(const std::string& path);

    const ShardHeader& header() const { return header_; }
    // Whether every viewpoint is done.
    bool finished() const { return finished_; }
    // Of the records before any damage, in the order of viewpoints: how many, and where the last one ends.
    int leadingRecords() const { return leading_; }
    size_t leadingBytes() const { return leadingBytes_; }

    void load(int index, int first, int count, TrainingExample& example) const override;
    std::string contentHash() const override;

  private:
    void read();
    // All records that say where they are.
    std::vector<ShardRecord> scan();
    bool isSoundRecord(const ShardRecord& record) const;

    MappedFile file_;
    std::string_view bytes_;  // all of it
    ShardHeader header_;
    std::vector<ShardRecord> examples_;
    size_t leadingBytes_ = 0;
    int leading_ = 0;
    int damaged_ = 0;  // places
    bool finished_ = false;
};

// At little cost, by its last bytes; false if there is no such file, or it cannot be read.
bool isFinishedShard(const std::string& path);

}  // namespace drc
