// The memory that this process holds, by use. Large owners register their allocations, so that --stats can show where
// memory is used. memory.h checks allocations in advance.
#pragma once
#include <cstdint>
#include <utility>

namespace drc {

enum class MemoryUse { Accelerator, Textures };

// Add to the memory registered for a use (negative when freed), and read it. Thread-safe.
void addMemoryUse(MemoryUse use, int64_t bytes);
int64_t memoryUse(MemoryUse use);

// Registers memory for the lifetime of this object.
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

// Memory of the whole process in bytes, including the program and its libraries; zeros if the system does not report
// it.
struct ProcessMemory {
    int64_t resident = 0, peak = 0;
};
ProcessMemory processMemory();

}  // namespace drc
