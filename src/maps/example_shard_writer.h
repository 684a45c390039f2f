// Writes a shard of training examples (shard_format.h), or continues an unfinished one.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "maps/shard_format.h"

namespace drc {

// Locks the file, so that no other writer can open it.
class ExampleShardWriter {
  public:
    // Continues an existing file after its last sound record in viewpoint order, and cuts off a record that an
    // interrupted program wrote only in part. A complete shard is left unchanged. Throws Error, beginning with the
    // path, if the file is not a shard, has other settings (the message names the first difference), is being written
    // by another program, or cannot be written.
    ExampleShardWriter(const std::string& path, const ShardHeader& header);
    ~ExampleShardWriter();
    ExampleShardWriter(const ExampleShardWriter&) = delete;
    ExampleShardWriter& operator=(const ExampleShardWriter&) = delete;

    // Index of the next viewpoint to write; equals the number of viewpoints if the shard is complete.
    int next() const { return next_; }
    bool finished() const { return finished_; }

    // Appends the record of viewpoint next(): the result of encodeExample(), or an empty string if the viewpoint gave
    // no example. After the last viewpoint, completes the shard and flushes it to disk. Throws Error, beginning with
    // the path, if writing fails; a later writer can continue the file.
    void append(std::string_view example);

  private:
    void open();
    void resume();
    void write(std::string_view bytes);
    void end();
    [[noreturn]] void fail(const std::string& message) const;

    std::string path_;
    ShardHeader header_;
    int fd_ = -1;
    uint64_t size_ = 0;  // size of the sound part of the file, bytes
    int next_ = 0;
    bool finished_ = false;
};

}  // namespace drc
