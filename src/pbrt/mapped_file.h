// A whole file as read-only memory: mapped, or copied if the file is small.
#pragma once
#include <memory>
#include <string>
#include <string_view>

#include "base/limits.h"

namespace drc::pbrt {

class MappedFile {
  public:
    // Throws Error, with the path and the system's reason, if the file cannot be read, is a folder, pipe or device, or
    // is larger than `most` bytes. `what` is used in messages ("scene file", ...).
    MappedFile(const std::string& path, const std::string& what, uint64_t most = limits::kFileBytes);
    ~MappedFile();
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;

    std::string_view text() const { return {data_, size_}; }

  private:
    const char* data_ = nullptr;
    size_t size_ = 0;
    std::unique_ptr<char[]> copy_;  // contents of a small file
};

}  // namespace drc::pbrt
