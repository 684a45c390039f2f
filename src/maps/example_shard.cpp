#include "maps/example_shard.h"

#include <fmt/core.h>

#include <fstream>

#include "base/error.h"
#include "base/parallel.h"
#include "neural/safetensors.h"

namespace drc {
namespace {

constexpr int kGrain = 16;

}  // namespace

ExampleShard::ExampleShard(const std::string& path) : file_(path), bytes_(file_.bytes()) {
    path_ = path;
    try {
        read();
    } catch (const Error& error) {
        throw Error(SourceLocation{path}, error.what());
    }
}

void ExampleShard::read() {
    header_ = parseShardHeader(bytes_, leadingBytes_);
    scene_ = header_.scene;
    layout_ = header_.layout;
    inputs_ = header_.inputs;
    const std::vector<ShardRecord> records = scan();
    std::vector<char> sound(records.size());
    parallelFor(0, int(records.size()), kGrain, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) sound[size_t(i)] = isSoundRecord(records[size_t(i)]);
    });
    bool leading = true;
    for (size_t i = 0; i < records.size(); ++i) {
        const ShardRecord& record = records[i];
        damaged_ += !sound[i];
        // If a record does not begin at the end of the previous one, or has an unexpected viewpoint number, at least
        // one record is missing before it.
        leading = leading && sound[i] && record.begin == leadingBytes_ + kRecordHeaderBytes &&
                  record.viewpoint == uint32_t(leading_);
        if (leading) leadingBytes_ = record.end();
        if (leading && record.kind != RecordKind::End) ++leading_;
        if (sound[i] && record.kind == RecordKind::Example) examples_.push_back(record);
    }
    finished_ = !records.empty() && records.back().kind == RecordKind::End && records.back().end() == bytes_.size() &&
                records.back().viewpoint == uint32_t(header_.viewpoints);
    count_ = int(examples_.size());
    std::string wrong;
    if (damaged_) wrong = fmt::format("{} damaged {}", damaged_, damaged_ == 1 ? "place" : "places");
    if (!finished_)
        wrong += fmt::format("{}not all of its {} viewpoints", wrong.empty() ? "" : ", ", header_.viewpoints);
    if (!wrong.empty()) damage_ = fmt::format("{}: {}; {} examples are usable", path_, wrong, count_);
}

std::vector<ShardRecord> ExampleShard::scan() {
    std::vector<ShardRecord> records;
    for (size_t at = leadingBytes_; at < bytes_.size();) {
        if (const auto record = parseRecord(bytes_, at)) {
            records.push_back(*record);
            at = record->end();
        } else {
            ++damaged_;
            at = std::min(findRecord(bytes_, at), bytes_.size());
        }
    }
    return records;
}

bool ExampleShard::isSoundRecord(const ShardRecord& record) const {
    if (record.kind != RecordKind::Example) return record.size == 0;
    thread_local TrainingExample example;
    try {
        decodeExample(bytes_.substr(record.begin, record.size), layout_, inputs_, 0, inputs_, example);
    } catch (const Error&) {
        return false;
    }
    return uint32_t(example.viewpoint) == record.viewpoint;
}

void ExampleShard::load(int index, int first, int count, TrainingExample& example) const {
    const ShardRecord& record = examples_.at(size_t(index));
    if (first < 0 || count < 0 || first > inputs_ - count) throw Error(SourceLocation{path_}, "no such input");
    try {
        decodeExample(bytes_.substr(record.begin, record.size), layout_, inputs_, first, count, example);
    } catch (const Error& error) {
        throw Error(SourceLocation{path_}, error.what());
    }
}

std::string ExampleShard::contentHash() const {
    return fmt::format("{:016x}", hashBytes(bytes_.data(), bytes_.size()));
}

bool isFinishedShard(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string last(kRecordHeaderBytes, '\0');
    if (!file.seekg(-std::streamoff(last.size()), std::ios::end) ||
        !file.read(last.data(), std::streamsize(last.size())))
        return false;
    const auto record = parseRecord(last, 0);
    return record && record->kind == RecordKind::End;
}

}  // namespace drc
