#include "maps/shard_format.h"

#include <fmt/core.h>

#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/limits.h"
#include "neural/safetensors.h"

namespace drc {
namespace {

static_assert(std::endian::native == std::endian::little, "shards are little endian");

using Json = nlohmann::ordered_json;

constexpr std::string_view kMagic = "DRCEXMPL", kRecordMagic = "DRCR";
constexpr uint32_t kVersion = 2;
constexpr size_t kPreambleBytes = 24;

template <typename T>
void append(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

template <typename T>
T numberAt(std::string_view bytes, size_t at) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof(value));
    return value;
}

int wholeNumber(const Json& json, const char* key, int least, int most) {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_number_integer() || *found < least || *found > most)
        throw Error(fmt::format("its header's '{}' is not a whole number from {} to {}", key, least, most));
    return found->get<int>();
}

std::string word(const Json& json, const char* key) {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_string()) throw Error(fmt::format("its header's '{}' is not a string", key));
    return found->get<std::string>();
}

uint32_t recordHash(std::string_view four) { return uint32_t(hashBytes(four.data(), four.size())); }

}  // namespace

std::string headerJson(const ShardHeader& h) {
    const Json json{{"scene", h.scene},
                    {"projection", projectionName(h.layout.projection())},
                    {"map_size", h.layout.size()},
                    {"inputs", h.inputs},
                    {"target_spp", h.targetSamples},
                    {"target_deviation", "upper estimate: samples are taken for independent, and are stratified"},
                    {"seed", h.seed},
                    {"viewpoints", h.viewpoints},
                    {"tiles", h.tiles},
                    {"settings", fmt::format("{:016x}", h.settings)}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

ShardHeader parseHeaderJson(std::string_view text) {
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object()) throw Error("its header is damaged");
    const auto seed = json.find("seed");
    return {.scene = word(json, "scene"),
            .layout = MapLayout(projectionFromName(word(json, "projection")),
                                wholeNumber(json, "map_size", 1, limits::kExampleMapSize)),
            .inputs = wholeNumber(json, "inputs", 1, limits::kExampleInputs),
            .targetSamples = wholeNumber(json, "target_spp", 1, 1 << 30),
            .seed = seed != json.end() && seed->is_number_unsigned() ? seed->get<uint64_t>() : 0,
            .viewpoints = wholeNumber(json, "viewpoints", 1, 1 << 30),
            .tiles = wholeNumber(json, "tiles", 0, 1 << 15),
            .settings = std::strtoull(word(json, "settings").c_str(), nullptr, 16)};
}

std::string shardHeaderBytes(const ShardHeader& header) {
    const std::string json = headerJson(header);
    if (json.size() > limits::kShardHeaderBytes) throw Error("the scene's name is too long");
    std::string bytes(kMagic);
    append(bytes, kVersion);
    append(bytes, uint32_t(json.size()));
    append(bytes, hashBytes(json.data(), json.size()));
    return bytes + json;
}

ShardHeader parseShardHeader(std::string_view shard, size_t& records) {
    if (shard.substr(0, kMagic.size()) != kMagic) throw Error("not a file of examples as `drc reference` writes them");
    if (shard.size() < kPreambleBytes) throw Error("it ends within its header");
    const auto version = numberAt<uint32_t>(shard, 8), size = numberAt<uint32_t>(shard, 12);
    if (version != kVersion)
        throw Error(fmt::format("examples of version {}; this program reads version {}", version, kVersion));
    if (size > limits::kShardHeaderBytes || size > shard.size() - kPreambleBytes)
        throw Error("it ends within its header");
    const std::string_view bytes = shard.substr(kPreambleBytes, size);
    if (numberAt<uint64_t>(shard, 16) != hashBytes(bytes.data(), bytes.size())) throw Error("its header is damaged");
    records = kPreambleBytes + size;
    return parseHeaderJson(bytes);
}

std::string firstDifference(const ShardHeader& there, const ShardHeader& asked) {
    const auto differ = [](const char* option, const auto& a, const auto& b) {
        return a == b ? std::string() : fmt::format("{} {}, not {}", option, a, b);
    };
    for (const std::string& difference :
         {differ("the scene", there.scene, asked.scene),
          differ("--projection", std::string(projectionName(there.layout.projection())),
                 std::string(projectionName(asked.layout.projection()))),
          differ("--map-size", there.layout.size(), asked.layout.size()),
          differ("--inputs", there.inputs, asked.inputs), differ("--spp", there.targetSamples, asked.targetSamples),
          differ("--seed", there.seed, asked.seed), differ("--tiles", there.tiles, asked.tiles),
          differ("--viewpoints", there.viewpoints, asked.viewpoints)})
        if (!difference.empty()) return difference;
    return there.settings == asked.settings ? "" : "another scene file of that name, or by another version of drc";
}

std::string recordHeaderBytes(RecordKind kind, uint32_t viewpoint, uint32_t size) {
    std::string bytes(kRecordMagic);
    append(bytes, uint32_t(kind));
    append(bytes, viewpoint);
    append(bytes, size);
    append(bytes, recordHash(bytes));
    return bytes;
}

std::optional<ShardRecord> parseRecord(std::string_view shard, size_t at) {
    if (at > shard.size() || shard.size() - at < kRecordHeaderBytes) return std::nullopt;
    const std::string_view head = shard.substr(at, kRecordHeaderBytes);
    const auto kind = numberAt<uint32_t>(head, 4), size = numberAt<uint32_t>(head, 12);
    if (head.substr(0, 4) != kRecordMagic || kind > uint32_t(RecordKind::End) ||
        numberAt<uint32_t>(head, 16) != recordHash(head.substr(0, 16)) || size > shard.size() - at - kRecordHeaderBytes)
        return std::nullopt;
    return ShardRecord{RecordKind(kind), numberAt<uint32_t>(head, 8), at + kRecordHeaderBytes, size};
}

size_t findRecord(std::string_view shard, size_t from) {
    for (size_t at = shard.find(kRecordMagic, from); at != shard.npos; at = shard.find(kRecordMagic, at + 1))
        if (parseRecord(shard, at)) return at;
    return shard.npos;
}

}  // namespace drc
