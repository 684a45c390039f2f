// The text of a scene file, and places in it.
#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.h"
#include "pbrt/mapped_file.h"

namespace drc::pbrt {

// One file, or a text in memory, that is being read. Lives as long as anything refers to places in it.
class Source {
  public:
    // Maps the file, or unpacks it if gzip has compressed it. Throws Error if it cannot be read.
    static std::unique_ptr<Source> fromFile(const std::string& path);
    // name stands for the file in messages; directory is where relative paths start.
    static std::unique_ptr<Source> fromText(std::string text, std::string name, std::string directory);

    const std::string& name() const { return name_; }
    const std::string& directory() const { return directory_; }
    std::string_view text() const { return file_ ? file_->text() : std::string_view(text_); }

  private:
    std::string name_, directory_, text_;
    std::unique_ptr<MappedFile> file_;
};

// A byte in a source. Line and column are counted only when somebody asks, so that tokens are cheap.
struct SourcePos {
    const Source* source = nullptr;
    size_t offset = 0;

    // Line and column count from 1; the column counts bytes.
    SourceLocation location() const;
    // The line, cut to a readable length, and beneath it a caret.
    std::string excerpt() const;
};

// Throws Error at pos, with an excerpt.
[[noreturn]] void fail(const SourcePos& pos, const std::string& message);
// The warning "file:line:column: warning: message".
void warn(const SourcePos& pos, const std::string& message);

}  // namespace drc::pbrt
