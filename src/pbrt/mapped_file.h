// A whole file as read-only memory.
#pragma once
#include <string>
#include <string_view>

namespace drc::pbrt {

class MappedFile {
  public:
    // Throws Error with the path and the system's reason. `what` names the file in the message ("scene file", ...).
    MappedFile(const std::string& path, const std::string& what);
    ~MappedFile();
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;

    std::string_view text() const { return {data_, size_}; }

  private:
    const char* data_ = nullptr;
    size_t size_ = 0;
};

}  // namespace drc::pbrt
