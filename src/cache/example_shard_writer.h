// Writes a shard of examples (shard_format.h), or what is missing of it.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "cache/shard_format.h"

namespace drc {

// While it lives, no other writer can have the same file.
class ExampleShardWriter {
  public:
    // A file that is there is continued after its last sound record in the order of viewpoints: one that was half
    // written when the program ended is cut off. A finished one is left as it is. Throws Error that begins with the
    // path if the file is something else, was made with other settings (it says which), is being written by another
    // program, or cannot be written.
    ExampleShardWriter(const std::string& path, const ShardHeader& header);
    ~ExampleShardWriter();
    ExampleShardWriter(const ExampleShardWriter&) = delete;
    ExampleShardWriter& operator=(const ExampleShardWriter&) = delete;

    // The first viewpoint that is not done; all of them if it is finished.
    int next() const { return next_; }
    bool finished() const { return finished_; }

    // Viewpoint next(): what encodeExample made of it, or nothing if it gave no example. After the last one, the shard
    // is finished and on the disk. Throws Error that begins with the path if it cannot be written; the file can be
    // continued then.
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
    uint64_t size_ = 0;  // of what is sound, bytes
    int next_ = 0;
    bool finished_ = false;
};

}  // namespace drc
