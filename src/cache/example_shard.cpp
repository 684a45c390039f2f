#include "cache/example_shard.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "base/error.h"
#include "base/parallel.h"
#include "neural/safetensors.h"

namespace drc {
namespace {

constexpr int kGrain = 16;

std::string_view mapFile(const std::string& path) {
    const auto fail = [&](const std::string& message) { throw Error(SourceLocation{path}, message); };
    const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (fd < 0) fail(fmt::format("cannot open: {}", std::strerror(errno)));
    struct stat info = {};
    if (::fstat(fd, &info) != 0 || !S_ISREG(info.st_mode)) {
        ::close(fd);
        fail("not a regular file");
    }
    const auto size = size_t(info.st_size);
    void* address = size ? ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, fd, 0) : nullptr;
    const int reason = errno;
    ::close(fd);
    if (address == MAP_FAILED) fail(fmt::format("cannot read: {}", std::strerror(reason)));
    return {static_cast<const char*>(address), size};
}

void unmap(std::string_view bytes) {
    if (!bytes.empty()) ::munmap(const_cast<char*>(bytes.data()), bytes.size());
}

}  // namespace

ExampleShard::ExampleShard(const std::string& path) : bytes_(mapFile(path)) {
    path_ = path;
    try {
        read();
    } catch (const Error& error) {
        unmap(bytes_);
        throw Error(SourceLocation{path}, error.what());
    } catch (...) {
        unmap(bytes_);
        throw;
    }
}

ExampleShard::~ExampleShard() { unmap(bytes_); }

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
        // A record that is not where the last one ended, or of another viewpoint: something is missing before it.
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
