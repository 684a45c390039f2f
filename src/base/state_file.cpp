#include "base/state_file.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/checksum.h"
#include "base/error.h"

namespace drc {
namespace {

constexpr size_t kBuffer = 1 << 16;

}  // namespace

StateWriter::StateWriter(const std::string& path, const std::string& header)
    : file_(path), sum_(checksum(header, kChecksumStart)) {
    buffer_.reserve(kBuffer);
    file_.write(header + "\n");
}

void StateWriter::bytes(std::span<const std::byte> data) {
    while (!data.empty()) {
        const size_t count = std::min(data.size(), kBuffer - buffer_.size());
        buffer_.append(reinterpret_cast<const char*>(data.data()), count);
        data = data.subspan(count);
        if (buffer_.size() == kBuffer) flush();
    }
}

void StateWriter::flush() {
    sum_ = checksum(buffer_, sum_);
    file_.write(buffer_);
    buffer_.clear();
}

void StateWriter::commit() {
    flush();
    file_.write({reinterpret_cast<const char*>(&sum_), sizeof(sum_)});
    file_.commit();
}

StateReader::StateReader(const std::string& path, const std::string& kind, const std::string& header)
    : path_(path), file_(path) {
    const std::string_view text = file_.bytes();
    if (!text.starts_with(kind)) throw Error(fmt::format("{}: not a {}", path, kind));
    if (!text.starts_with(header + "\n"))
        throw Error(fmt::format("{}: a {} of another scene, other settings or another version", path, kind));
    rest_ = text.substr(header.size() + 1);
    uint64_t stored = 0;
    if (rest_.size() < sizeof(stored)) fail("it ends too early");
    std::memcpy(&stored, rest_.data() + rest_.size() - sizeof(stored), sizeof(stored));
    rest_.remove_suffix(sizeof(stored));
    if (checksum(rest_, checksum(header, kChecksumStart)) != stored) fail("its checksum is wrong");
}

void StateReader::bytes(std::span<std::byte> to) {
    if (to.size() > rest_.size()) fail("it ends too early");
    std::memcpy(to.data(), rest_.data(), to.size());
    rest_.remove_prefix(to.size());
}

void StateReader::finish() const {
    if (!rest_.empty()) fail(fmt::format("it has {} bytes too many", rest_.size()));
}

void StateReader::fail(const std::string& why) const {
    throw Error(fmt::format("{}: the file is damaged: {}", path_, why));
}

std::string stateHeader(const std::string& path, const std::string& kind) {
    const MappedFile file(path);
    if (!file.bytes().starts_with(kind)) throw Error(fmt::format("{}: not a {}", path, kind));
    return std::string(file.bytes().substr(0, file.bytes().find('\n')));
}

}  // namespace drc
