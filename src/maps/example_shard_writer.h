// Writes a shard of training examples (shard_format.h), or continues an unfinished one.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "maps/shard_format.h"

namespace drc {

// Holds a lock on the file, so that no other writer can open it.
class ExampleShardWriter {
  public:
    // An existing file is continued after its last sound record in viewpoint order; a record that was only partly
    // written when a program ended is cut off. A complete shard is left as it is. Throws Error, beginning with the
    // path, if the file is something else, was made with other settings (the message names the first that differs), is
    // being written by another program, or cannot be written.
    ExampleShardWriter(const std::string& path, const ShardHeader& header);
    ~ExampleShardWriter();
    ExampleShardWriter(const ExampleShardWriter&) = delete;
    ExampleShardWriter& operator=(const ExampleShardWriter&) = delete;

    // Index of the next viewpoint to write; the number of viewpoints if the shard is complete.
    int next() const { return next_; }
    bool finished() const { return finished_; }

    // Appends viewpoint next(): the result of encodeExample(), or an empty string if the viewpoint gave no example.
    // After the last viewpoint the shard is completed and flushed to disk. Throws Error, beginning with the path, if
    // writing fails; the file can be continued after that.
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
