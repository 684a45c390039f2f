// The memory that this process holds, by use. Large owners note what they allocate, so that --stats can say where the
// memory goes. For checks in advance see memory.h.
#pragma once
#include <cstdint>
#include <utility>

namespace drc {

enum class MemoryUse { Accelerator, Textures };

// Adds to what is noted for the use; negative for what has been freed. Any thread.
void addMemoryUse(MemoryUse use, int64_t bytes);
int64_t memoryUse(MemoryUse use);

// Notes memory for as long as it lives.
class NotedMemory {
  public:
    NotedMemory() = default;
    NotedMemory(MemoryUse use, size_t bytes) : use_(use), bytes_(int64_t(bytes)) { addMemoryUse(use_, bytes_); }
    NotedMemory(NotedMemory&& other) noexcept : use_(other.use_), bytes_(std::exchange(other.bytes_, 0)) {}
    NotedMemory& operator=(NotedMemory&& other) noexcept {
        std::swap(use_, other.use_);
        std::swap(bytes_, other.bytes_);
        return *this;
    }
    ~NotedMemory() {
        if (bytes_ != 0) addMemoryUse(use_, -bytes_);
    }

  private:
    MemoryUse use_ = MemoryUse::Accelerator;
    int64_t bytes_ = 0;
};

// Bytes of the whole process, its program and libraries included; zeros where the system does not tell.
struct ProcessMemory {
    int64_t resident = 0, peak = 0;
};
ProcessMemory processMemory();

}  // namespace drc
