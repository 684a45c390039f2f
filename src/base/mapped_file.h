// A file's bytes, mapped into memory for reading: what is not looked at is not read.
#pragma once
#include <string>
#include <string_view>

namespace drc {

class MappedFile {
  public:
    // Throws Error, one line that begins with the file's name, if it cannot be opened or is no regular file.
    explicit MappedFile(const std::string& path);
    ~MappedFile();
    MappedFile(MappedFile&& other) noexcept;
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;
    MappedFile& operator=(MappedFile&&) = delete;

    // Those that the file had when it was opened; gone with this object.
    std::string_view bytes() const { return bytes_; }

  private:
    std::string_view bytes_;
};

}  // namespace drc
