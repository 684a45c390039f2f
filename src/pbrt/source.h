// The text of a scene file, and places in it.
#pragma once
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/limits.h"
#include "pbrt/mapped_file.h"

namespace drc::pbrt {

// One file, or a text in memory, that is being read. Lives as long as anything refers to places in it.
class Source {
  public:
    // Maps the file, or unpacks it if gzip has compressed it. Throws Error if it cannot be read, or is larger than most
    // bytes. `what` names the file in the message.
    static std::unique_ptr<Source> fromFile(const std::string& path, const std::string& what = "scene file",
                                            uint64_t most = limits::kFileBytes);
    // name stands for the file in messages; directory is where relative paths start.
    static std::unique_ptr<Source> fromText(std::string text, std::string name, std::string directory);

    const std::string& name() const { return name_; }
    const std::string& directory() const { return directory_; }
    std::string_view text() const { return file_ ? file_->text() : std::string_view(text_); }

  private:
    friend struct SourcePos;
    // The number of the line, from 0, that a byte is in, and where that begins.
    struct Line {
        size_t number, start;
    };
    Line lineAt(size_t offset) const;

    std::string name_, directory_, text_;
    std::unique_ptr<MappedFile> file_;
    // Where lines begin; made when first asked for. A file that deserves one warning often deserves thousands.
    mutable std::vector<size_t> lineStarts_;
    mutable std::once_flag linesFound_;
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
// What f returns. An Error of it that has no place in a file of its own (one that cannot be opened) is thrown at pos.
template <typename F>
auto placedAt(const SourcePos& pos, const F& f) -> decltype(f()) {
    try {
        return f();
    } catch (const Error& error) {
        if (!error.where().empty()) throw;
        fail(pos, error.what());
    }
}
// The warning "file:line:column: warning: message".
void warn(const SourcePos& pos, const std::string& message);

}  // namespace drc::pbrt
