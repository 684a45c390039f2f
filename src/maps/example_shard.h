// Reads a shard of examples (shard_format.h).
#pragma once
#include <vector>

#include "base/mapped_file.h"
#include "maps/example_source.h"
#include "maps/shard_format.h"

namespace drc {

// The file is mapped, and examples are decoded on request, so a data set may be larger than memory. The file may grow
// while it is open, for instance while `drc reference` writes it; records appended after opening are not seen.
class ExampleShard final : public ExampleSource {
  public:
    // Checks all records, on all threads. Damaged records are skipped and reported by damage(); all others can be
    // loaded. Throws Error if the header is invalid.
    explicit ExampleShard(const std::string& path);

    const ShardHeader& header() const { return header_; }
    // Whether the shard contains all its viewpoints.
    bool finished() const { return finished_; }
    // The sound records before the first damage, in viewpoint order: their number, and the file offset of their end.
    // Writing can continue at this offset.
    int leadingRecords() const { return leading_; }
    size_t leadingBytes() const { return leadingBytes_; }

    void load(int index, int first, int count, TrainingExample& example) const override;
    std::string contentHash() const override;

  private:
    void read();
    // Finds all records that have an intact header.
    std::vector<ShardRecord> scan();
    bool isSoundRecord(const ShardRecord& record) const;

    MappedFile file_;
    std::string_view bytes_;  // the whole file
    ShardHeader header_;
    std::vector<ShardRecord> examples_;
    size_t leadingBytes_ = 0;
    int leading_ = 0;
    int damaged_ = 0;  // number of damaged records and gaps
    bool finished_ = false;
};

// Whether a shard is complete. Reads only the last bytes of the file. False if the file is missing or unreadable.
bool isFinishedShard(const std::string& path);

}  // namespace drc
