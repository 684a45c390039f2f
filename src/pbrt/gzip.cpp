#include "pbrt/gzip.h"

#include <zlib.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "base/error.h"
#include "base/memory.h"

namespace drc::pbrt {
namespace {

constexpr int kGzipFormat = 16 + MAX_WBITS;  // only gzip, no bare zlib streams
// Unpacks in chunks of a few times the packed size: scenes have thousands of small files, and touching the pages of a
// large buffer for the first time would cost more than unpacking.
constexpr size_t kLeastChunk = size_t(1) << 12, kMostChunk = size_t(1) << 20;
constexpr size_t kUsualRatio = 4;

class Inflater {
  public:
    Inflater() {
        if (inflateInit2(&stream, kGzipFormat) != Z_OK) throw Error("zlib cannot be used");
    }
    ~Inflater() { inflateEnd(&stream); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    z_stream stream{};
};

}  // namespace

bool isGzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

std::string gunzip(std::string_view bytes, const std::string& path, const GunzipLimit& limit) {
    const size_t most = std::max(limit.bytes, bytes.size() * limit.ratio);
    Inflater inflater;
    z_stream& z = inflater.stream;
    std::string result;
    std::optional<MemoryClaim> memory;  // for the capacity of `result`
    const size_t chunk = std::clamp(kUsualRatio * bytes.size(), kLeastChunk, kMostChunk);
    const auto unpacked = std::make_unique_for_overwrite<char[]>(chunk);
    size_t read = 0;
    const auto failGzip = [&](const std::string& what) { throw Error(path + ": the gzip stream " + what); };
    for (;;) {
        if (z.avail_in == 0) {
            const size_t next = std::min(kMostChunk, bytes.size() - read);
            z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + read));
            z.avail_in = uInt(next);
            read += next;
        }
        z.next_out = reinterpret_cast<Bytef*>(unpacked.get());
        z.avail_out = uInt(chunk);
        const int status = inflate(&z, Z_NO_FLUSH);
        const size_t size = chunk - z.avail_out;
        if (result.capacity() - result.size() < size) {
            const size_t more = 2 * result.capacity() + chunk;
            memory.emplace(double(more), path + ", unpacked,");
            result.reserve(more);
        }
        result.append(unpacked.get(), size);
        if (memory) memory->taken(double(result.size()));
        const bool atEnd = z.avail_in == 0 && read == bytes.size();
        if (result.size() > most)
            failGzip("grows beyond " + std::to_string(most >> 20) + " MiB, from " + std::to_string(bytes.size()) +
                     " bytes: this is no mesh or scene");
        if (status == Z_STREAM_END) {
            if (atEnd) return result;
            inflateReset(&z);  // a file may consist of several concatenated streams
        } else if (status == Z_BUF_ERROR || (status == Z_OK && atEnd && z.avail_out > 0)) {
            if (atEnd) failGzip("is cut short");
        } else if (status != Z_OK) {
            failGzip(std::string("is damaged") + (z.msg != nullptr ? std::string(": ") + z.msg : ""));
        }
    }
}

}  // namespace drc::pbrt
