// The file format of a shard, which contains the training examples of one scene as `drc reference` writes them:
//
//     "DRCEXMPL"  u32 version  u32 size of the JSON  u64 hash of the JSON  JSON: the settings (ShardHeader)
//     one record for each viewpoint, in order:
//         "DRCR"  u32 kind  u32 viewpoint  u32 size of the data  u32 hash of these four  data (example_record.h)
//     a final record that marks the end
//
// All numbers are little endian. Kinds: 0 an example; 1 a viewpoint without an example; 2 the end, with the number of
// viewpoints in place of the viewpoint.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "maps/projection.h"

namespace drc {

inline constexpr const char* kShardExtension = ".examples";

// The settings that a shard is made with. Shards with equal headers have equal contents.
struct ShardHeader {
    std::string scene;
    MapLayout layout{Projection::EqualArea, 32};
    int inputs = 1;         // realisations per example
    int targetSamples = 0;  // samples per texel of the target
    uint64_t seed = 0;
    int viewpoints = 0;     // number requested
    int tiles = 0;          // the viewpoints are on a grid of tiles x tiles; 0: spread over the film without a grid
    uint64_t settings = 0;  // hash of everything else that determines the examples
};

std::string headerJson(const ShardHeader& header);
// Throws Error, without a file name, if the JSON is no valid header.
ShardHeader parseHeaderJson(std::string_view json);

std::string shardHeaderBytes(const ShardHeader& header);
// Parses the header of a shard and sets `records` to the offset of the first record. Throws Error, without a file name,
// if it is invalid.
ShardHeader parseShardHeader(std::string_view shard, size_t& records);
// Describes the first setting of `there` that differs from `asked`, as "--spp 64, not 32"; empty if all are equal.
std::string firstDifference(const ShardHeader& there, const ShardHeader& asked);

enum class RecordKind : uint32_t { Example, None, End };

// A record's position in its shard.
struct ShardRecord {
    RecordKind kind;
    uint32_t viewpoint;
    size_t begin, size;  // of the data, bytes
    size_t end() const { return begin + size; }
};

// The bytes that precede a record's data.
std::string recordHeaderBytes(RecordKind kind, uint32_t viewpoint, uint32_t size);
inline constexpr size_t kRecordHeaderBytes = 20;
// The record that begins at offset `at`; none if its header is not intact or it extends beyond the end of the file. Its
// data may still be damaged.
std::optional<ShardRecord> parseRecord(std::string_view shard, size_t at);
// Offset of the first record header at or after `from`; npos if there is none.
size_t findRecord(std::string_view shard, size_t from);

}  // namespace drc
