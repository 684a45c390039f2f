#include "pbrt/source.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "base/log.h"
#include "pbrt/gzip.h"

namespace drc::pbrt {
namespace {

// Limits the excerpt, because meshes are often written as a single line of megabytes.
constexpr size_t kExcerptWidth = 100;

void checkEncoding(const Source& source) {
    const std::string_view text = source.text();
    const auto isZero = [&](size_t i) { return i < text.size() && text[i] == '\0'; };
    const bool marked = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
    // UTF-16 without a byte order mark: in plain English text every other byte is zero.
    const bool unmarked =
        text.size() >= 4 && isZero(0) == isZero(2) && isZero(1) == isZero(3) && isZero(0) != isZero(1);
    if (marked || unmarked)
        throw Error({source.name(), 1, 1},
                    "the text is in UTF-16; save the file as UTF-8 (or convert it: iconv -f UTF-16 -t UTF-8)");
}

}  // namespace

std::unique_ptr<Source> Source::fromPipe(const std::string& path) {
    const bool isStandard = path == "-";
    const std::string name = isStandard ? "<standard input>" : path;
    std::ifstream stream(isStandard ? "/dev/stdin" : path, std::ios::binary);
    const auto failed = [&](int reason) {
        throw Error("cannot read the scene from " + name + ": " + std::strerror(reason));
    };
    if (!stream) failed(errno);
    std::string text;
    for (std::vector<char> buffer(size_t(1) << 20); stream;) {
        stream.read(buffer.data(), std::streamsize(buffer.size()));
        text.append(buffer.data(), size_t(stream.gcount()));
        if (text.size() > limits::kFileBytes) failed(EFBIG);
    }
    if (stream.bad()) failed(EIO);
    if (isGzip(text)) text = gunzip(text, name);
    auto source = fromText(std::move(text), name, "");
    checkEncoding(*source);
    return source;
}

std::unique_ptr<Source> Source::fromFile(const std::string& path, const std::string& what, uint64_t most) {
    auto source = std::make_unique<Source>();
    source->file_ = std::make_unique<MappedFile>(path, what, most);
    if (isGzip(source->file_->text())) {
        source->text_ = gunzip(source->file_->text(), path);
        source->file_ = nullptr;
        if (source->text_.size() > most)
            throw Error("cannot read " + what + " '" + path + "': " + std::strerror(EFBIG));
    }
    source->name_ = path;
    source->directory_ = std::filesystem::path(path).parent_path().string();
    checkEncoding(*source);
    return source;
}

std::unique_ptr<Source> Source::open(const std::string& path) {
    std::error_code ignored;
    const bool isPipe = path == "-" || std::filesystem::is_fifo(path, ignored);
    return isPipe ? fromPipe(path) : fromFile(path);
}

std::unique_ptr<Source> Source::fromText(std::string text, std::string name, std::string directory) {
    auto source = std::make_unique<Source>();
    source->text_ = std::move(text);
    source->name_ = std::move(name);
    source->directory_ = std::move(directory);
    return source;
}

Source::Line Source::lineAt(size_t offset) const {
    std::call_once(linesFound_, [this] {
        const std::string_view all = text();
        lineStarts_.push_back(all.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
        for (size_t i = all.find('\n'); i != std::string_view::npos; i = all.find('\n', i + 1))
            lineStarts_.push_back(i + 1);
    });
    const auto after = std::upper_bound(lineStarts_.begin(), lineStarts_.end(), std::max(offset, lineStarts_[0]));
    return {size_t(after - lineStarts_.begin()) - 1, after[-1]};
}

SourceLocation SourcePos::location() const {
    if (source == nullptr) return {};
    const Source::Line line = source->lineAt(offset);
    return {source->name(), 1 + int(line.number), 1 + int(std::max(offset, line.start) - line.start)};
}

std::string SourcePos::lineOfFile() const {
    const SourceLocation at = location();
    return "line " + std::to_string(at.line) + " of " + at.file;
}

std::string SourcePos::excerpt() const {
    if (source == nullptr) return "";
    const std::string_view text = source->text();
    const size_t lineStart = source->lineAt(std::min(offset, text.size())).start;
    const size_t at = std::max(std::min(offset, text.size()), lineStart);
    const size_t lineEnd = std::min(text.find('\n', at), text.size());

    size_t first = lineStart, last = lineEnd;
    if (last - first > kExcerptWidth) {
        if (at - lineStart > kExcerptWidth / 2) first = at - kExcerptWidth / 2;
        last = std::min(lineEnd, first + kExcerptWidth);
    }
    std::string line = first > lineStart ? "..." : "";
    std::string marker(line.size(), ' ');
    for (size_t i = first; i < last; ++i) {
        const char c = text[i];
        const bool control = static_cast<unsigned char>(c) < 32 && c != '\t';
        if (c == '\r') continue;
        line += control ? '?' : c;
        // Tabs are copied so that the caret is aligned whatever their width. Continuation bytes of UTF-8 have no width.
        if (i < at && (static_cast<unsigned char>(c) & 0xC0) != 0x80) marker += c == '\t' ? '\t' : ' ';
    }
    if (last < lineEnd) line += "...";
    return "    " + line + "\n    " + marker + "^";
}

void fail(const SourcePos& pos, const std::string& message) { throw Error(pos.location(), message, pos.excerpt()); }

void warn(const SourcePos& pos, const std::string& message) { logWarning(pos.location(), message); }
void warnOnce(const SourcePos& pos, const std::string& message) { logWarningOnce(pos.location(), message); }

}  // namespace drc::pbrt
