#include "maps/example_shard_writer.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/error.h"
#include "base/limits.h"
#include "base/log.h"
#include "maps/example_shard.h"

namespace drc {

ExampleShardWriter::ExampleShardWriter(const std::string& path, const ShardHeader& header)
    : path_(path), header_(header) {
    try {
        open();
    } catch (...) {
        if (fd_ >= 0) ::close(fd_);
        throw;
    }
}

ExampleShardWriter::~ExampleShardWriter() { ::close(fd_); }

void ExampleShardWriter::fail(const std::string& message) const { throw Error(SourceLocation{path_}, message); }

void ExampleShardWriter::open() {
    fd_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (fd_ < 0) fail(fmt::format("cannot write: {}", std::strerror(errno)));
    if (::flock(fd_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) fail("another program is writing this file");
    const std::string start = shardHeaderBytes(header_);
    std::string there(start.size(), '\0');
    const ssize_t got = ::pread(fd_, there.data(), there.size(), 0);
    if (got < 0) fail(fmt::format("cannot read: {}", std::strerror(errno)));
    // A program that ended while writing the header left only a prefix of the header.
    if (size_t(got) < start.size() && start.compare(0, size_t(got), there, 0, size_t(got)) == 0) {
        if (::ftruncate(fd_, 0) != 0) fail(fmt::format("cannot write: {}", std::strerror(errno)));
        write(start);
        return;
    }
    resume();
}

void ExampleShardWriter::resume() {
    // Complete shards are only checked for their end, because there may be many of them.
    const bool ended = isFinishedShard(path_);
    std::string start(limits::kShardHeaderBytes + 64, '\0');
    const ssize_t got = ::pread(fd_, start.data(), start.size(), 0);
    start.resize(size_t(std::max<ssize_t>(got, 0)));
    size_t records = 0;
    ShardHeader there;
    try {
        there = parseShardHeader(start, records);
    } catch (const Error& error) {
        fail(error.what());
    }
    const std::string difference = firstDifference(there, header_);
    if (!difference.empty())
        fail(fmt::format("made with {}; ask for the same, name another folder, or remove the file", difference));
    if (ended) {
        next_ = header_.viewpoints;
        finished_ = true;
        return;
    }
    const ExampleShard shard(path_);
    next_ = std::min(shard.leadingRecords(), header_.viewpoints);
    size_ = shard.leadingBytes();
    if (::ftruncate(fd_, off_t(size_)) != 0) fail(fmt::format("cannot write: {}", std::strerror(errno)));
    if (next_ == header_.viewpoints) end();
}

void ExampleShardWriter::write(std::string_view bytes) {
    const uint64_t before = size_;
    while (!bytes.empty()) {
        const ssize_t n = ::pwrite(fd_, bytes.data(), bytes.size(), off_t(size_));
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) {
            const int reason = n < 0 ? errno : ENOSPC;
            size_ = before;
            // If truncating fails too, the next run cuts off the partial record.
            if (::ftruncate(fd_, off_t(before)) != 0) logDebug(path_ + ": " + std::strerror(errno));
            fail(fmt::format("cannot write: {}", std::strerror(reason)));
        }
        size_ += uint64_t(n);
        bytes.remove_prefix(size_t(n));
    }
}

void ExampleShardWriter::append(std::string_view example) {
    if (next_ >= header_.viewpoints) fail("it has all its viewpoints already");
    const RecordKind kind = example.empty() ? RecordKind::None : RecordKind::Example;
    write(recordHeaderBytes(kind, uint32_t(next_), uint32_t(example.size())) + std::string(example));
    if (++next_ == header_.viewpoints) end();
}

void ExampleShardWriter::end() {
    write(recordHeaderBytes(RecordKind::End, uint32_t(header_.viewpoints), 0));
    if (::fsync(fd_) != 0 && errno != EINVAL && errno != EROFS && errno != ENOTSUP)
        fail(fmt::format("cannot write: {}", std::strerror(errno)));
    finished_ = true;
}

}  // namespace drc
