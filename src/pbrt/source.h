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

// The UTF-8 byte order mark, which Windows editors put before the text. It is not part of the text.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// A file, or a text in memory, that is being read. Must outlive all positions in it.
class Source {
  public:
    // Maps the file, or decompresses it if it is gzipped. Throws Error if it cannot be read, is larger than `most`
    // bytes, or is UTF-16 text. `what` is used in messages.
    static std::unique_ptr<Source> fromFile(const std::string& path, const std::string& what = "scene file",
                                            uint64_t most = limits::kFileBytes);
    // Reads a pipe, or standard input for "-", to its end. Relative paths in it start in the working folder. Throws
    // Error if it cannot be read.
    static std::unique_ptr<Source> fromPipe(const std::string& path);
    // fromPipe() if the path is "-" or that of a named pipe, otherwise fromFile().
    static std::unique_ptr<Source> open(const std::string& path);
    // name is used in place of a file name; relative paths start in directory.
    static std::unique_ptr<Source> fromText(std::string text, std::string name, std::string directory);

    const std::string& name() const { return name_; }
    const std::string& directory() const { return directory_; }
    std::string_view text() const { return file_ ? file_->text() : std::string_view(text_); }

  private:
    friend struct SourcePos;
    // The number of the line that contains a byte, counted from 0, and the offset where this line begins.
    struct Line {
        size_t number, start;
    };
    Line lineAt(size_t offset) const;

    std::string name_, directory_, text_;
    std::unique_ptr<MappedFile> file_;
    // Start offsets of all lines, computed at the first use and kept, because a file that causes one warning often
    // causes thousands.
    mutable std::vector<size_t> lineStarts_;
    mutable std::once_flag linesFound_;
};

// A byte offset in a source. Line and column are computed only on demand, so that tokens are cheap.
struct SourcePos {
    const Source* source = nullptr;
    size_t offset = 0;

    // Line and column count from 1; the column counts bytes.
    SourceLocation location() const;
    // "line 3 of room.pbrt", for messages that refer to a second location.
    std::string lineOfFile() const;
    // The line, shortened to a readable length, with a caret below it.
    std::string excerpt() const;
};

// Throws Error at pos, with an excerpt.
[[noreturn]] void fail(const SourcePos& pos, const std::string& message);
// Returns the result of f. An Error from f without a location (for instance for a file that cannot be opened) is thrown
// again with the location pos.
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
// Like warn(), but logs each message only for the first location.
void warnOnce(const SourcePos& pos, const std::string& message);

}  // namespace drc::pbrt
