// The file format of a shard, which holds the training examples of one scene, written by `drc reference`:
//
//     "DRCEXMPL"  u32 version  u32 size of the JSON  u64 hash of the JSON  JSON: the settings (ShardHeader)
//     one record for each viewpoint, in order:
//         "DRCR"  u32 kind  u32 viewpoint  u32 size of the data  u32 hash of these four  data (example_record.h)
//     a final record that marks the end
//
// All numbers are little endian. Kinds: 0 an example; 1 a viewpoint without an example; 2 the end, which stores the
// number of viewpoints in its viewpoint field.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "maps/projection.h"

namespace drc {

inline constexpr const char* kShardExtension = ".examples";

// The settings that produced a shard. Shards with equal headers have equal contents.
struct ShardHeader {
    std::string scene;
    MapLayout layout{Projection::EqualArea, 32};
    int inputs = 1;         // realisations per example
    int targetSamples = 0;  // samples per texel in the target
    uint64_t seed = 0;
    int viewpoints = 0;     // number of viewpoints requested
    int tiles = 0;          // viewpoints lie in the cells of a tiles x tiles grid; 0: spread over the film
    uint64_t settings = 0;  // hash of all other settings that determine the examples
};

std::string headerJson(const ShardHeader& header);
// Throws Error, without a file name, if the JSON is not a valid header.
ShardHeader parseHeaderJson(std::string_view json);

std::string shardHeaderBytes(const ShardHeader& header);
// Parses a shard's header and sets `records` to the offset of the first record. Throws Error, without a file name, if
// the header is invalid.
ShardHeader parseShardHeader(std::string_view shard, size_t& records);
// Describes the first setting in the header `there` that differs from `asked`, such as "--spp 64, not 32"; empty if
// none does.
std::string firstDifference(const ShardHeader& there, const ShardHeader& asked);

enum class RecordKind : uint32_t { Example, None, End };

// A record's position in its shard.
struct ShardRecord {
    RecordKind kind;
    uint32_t viewpoint;
    size_t begin, size;  // offset and size of the data in the shard, bytes
    size_t end() const { return begin + size; }
};

// The bytes that precede a record's data.
std::string recordHeaderBytes(RecordKind kind, uint32_t viewpoint, uint32_t size);
inline constexpr size_t kRecordHeaderBytes = 20;
// Parses the record at offset `at`; none if its header is damaged or it extends beyond the end of the file. Does not
// check the data.
std::optional<ShardRecord> parseRecord(std::string_view shard, size_t at);
// Offset of the first record header at or after `from`; npos if there is none.
size_t findRecord(std::string_view shard, size_t from);

}  // namespace drc
