// The text of a scene file, and positions in it.
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

// Editors on Windows put it before text in UTF-8. It is no part of the text.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// A file, or a text in memory, that is being read. Lives as long as any position in it is used.
class Source {
  public:
    // Maps the file, or decompresses it if it is gzipped. Throws Error if it cannot be read or is larger than `most`
    // bytes, or if it is text in UTF-16. `what` is used in messages.
    static std::unique_ptr<Source> fromFile(const std::string& path, const std::string& what = "scene file",
                                            uint64_t most = limits::kFileBytes);
    // Reads a pipe, or for "-" standard input, to its end. Relative paths in it start in the working folder. Throws
    // Error if it cannot be read.
    static std::unique_ptr<Source> fromPipe(const std::string& path);
    // name is used in place of a file name; relative paths start in directory.
    static std::unique_ptr<Source> fromText(std::string text, std::string name, std::string directory);

    const std::string& name() const { return name_; }
    const std::string& directory() const { return directory_; }
    std::string_view text() const { return file_ ? file_->text() : std::string_view(text_); }

  private:
    friend struct SourcePos;
    // The number, from 0, of the line that contains a byte, and the offset where the line begins.
    struct Line {
        size_t number, start;
    };
    Line lineAt(size_t offset) const;

    std::string name_, directory_, text_;
    std::unique_ptr<MappedFile> file_;
    // Offsets of all lines, computed when first needed. A file that deserves one warning often deserves thousands.
    mutable std::vector<size_t> lineStarts_;
    mutable std::once_flag linesFound_;
};

// A byte offset in a source. Line and column are computed only on demand, so that tokens are cheap.
struct SourcePos {
    const Source* source = nullptr;
    size_t offset = 0;

    // Line and column count from 1; the column counts bytes.
    SourceLocation location() const;
    // "line 3 of room.pbrt", for messages that tell of another place than their own.
    std::string lineOfFile() const;
    // The line, shortened to a readable length, with a caret below it.
    std::string excerpt() const;
};

// Throws Error at pos, with an excerpt.
[[noreturn]] void fail(const SourcePos& pos, const std::string& message);
// Returns what f returns. An Error from f without a position in a file of its own (such as a file that cannot be
// opened) is thrown again at pos.
template <typename F>
auto placedAt(const SourcePos& pos, const F& f) -> decltype(f()) {
    try {
        return f();
    } catch (const Error& error) {
        if (!error.where().empty()) throw;
        fail(pos, error.what());
    }
}
// Logs the warning "file:line:column: warning: message".
void warn(const SourcePos& pos, const std::string& message);
// Like warn(), but logs each message only at the first place that it applies to.
void warnOnce(const SourcePos& pos, const std::string& message);

}  // namespace drc::pbrt
