// A file mapped into memory for reading. The system reads only the pages that are accessed.
#pragma once
#include <string>
#include <string_view>

namespace drc {

class MappedFile {
  public:
    // Throws Error, in one line that begins with the path, if the file cannot be opened or is not a regular file.
    explicit MappedFile(const std::string& path);
    ~MappedFile();
    MappedFile(MappedFile&& other) noexcept;
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;
    MappedFile& operator=(MappedFile&&) = delete;

    // The contents, with the length that the file had when it was opened. Valid as long as this object exists.
    std::string_view bytes() const { return bytes_; }

  private:
    std::string_view bytes_;
};

}  // namespace drc
