// The bytes of a shard: a file of examples of one scene, as `drc reference` writes it.
//
//     "DRCEXMPL"  u32 version  u32 bytes of JSON  u64 their hash  JSON: what was asked for (ShardHeader)
//     records, one for each viewpoint, in their order:
//         "DRCR"  u32 kind  u32 viewpoint  u32 bytes of data  u32 hash of these four  data: example_record.h
//     a last record that says that there are no more
//
// Little endian. Kinds: 0 an example, 1 a viewpoint that gave none, 2 the end; its "viewpoint" is how many there were.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "cache/projection.h"

namespace drc {

inline constexpr const char* kShardExtension = ".examples";

// What a shard is made with; shards with equal headers have equal contents.
struct ShardHeader {
    std::string scene;
    MapLayout layout{Projection::EqualArea, 32};
    int inputs = 1;         // realisations of each example
    int targetSamples = 0;  // per texel of the target
    uint64_t seed = 0;
    int viewpoints = 0;     // asked for
    int tiles = 0;          // they are a grid of tiles x tiles; 0: spread without one
    uint64_t settings = 0;  // hash of whatever else the examples follow from
};

std::string headerJson(const ShardHeader& header);
// Throws Error, without a file's name.
ShardHeader parseHeaderJson(std::string_view json);

std::string shardHeaderBytes(const ShardHeader& header);
// Sets `records` to where the first record begins. Throws Error, without a file's name.
ShardHeader parseShardHeader(std::string_view shard, size_t& records);
// "--spp 64, not 32": the first setting of `there` that is not the one asked for; empty if all are alike.
std::string firstDifference(const ShardHeader& there, const ShardHeader& asked);

enum class RecordKind : uint32_t { Example, None, End };

// A record's place in its shard.
struct ShardRecord {
    RecordKind kind;
    uint32_t viewpoint;
    size_t begin, size;  // of the data
    size_t end() const { return begin + size; }
};

// What stands before a record's data.
std::string recordHeaderBytes(RecordKind kind, uint32_t viewpoint, uint32_t size);
inline constexpr size_t kRecordHeaderBytes = 20;
// The record that begins at `at`; nothing if none does, or if it goes beyond the end. Its data may be damaged.
std::optional<ShardRecord> parseRecord(std::string_view shard, size_t at);
// Where at or after `from` the next record begins; npos: nowhere.
size_t findRecord(std::string_view shard, size_t from);

}  // namespace drc
