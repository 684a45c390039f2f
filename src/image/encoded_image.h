// A picture as its file holds it, and what the decoders of all formats share: limits, memory, and one form of error.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/limits.h"
#include "base/memory.h"

namespace drc {

struct EncodedImage {
    std::string_view bytes;
    std::string path;  // for messages
    int64_t mostPixels = limits::kImagePixels;
};

// Throws Error "cannot read PATH: what".
[[noreturn]] void failDecoding(const EncodedImage& encoded, std::string_view what);

// Throws Error on a size that no picture has or that is beyond the limits. Holds back memory for all that the picture
// will take until it is what is rendered with: its floats, then the colours, a copy of them and their coarser levels;
// and for `extraBytes` more, of the decoder itself. Keep it while the picture is read, no longer: pictures are read one
// after the other, before the meshes, and nothing else is made until the colours have been.
[[nodiscard]] MemoryClaim claimMemory(const EncodedImage& encoded, int64_t width, int64_t height, int64_t channels,
                                      double extraBytes = 0);

// Reads on from the start of a file's bytes. What is missing is an Error.
class ByteReader {
  public:
    explicit ByteReader(const EncodedImage& encoded) : encoded_(encoded) {}

    size_t left() const { return encoded_.bytes.size() - at_; }
    // Throws Error if the file has fewer left: before a picture is made, for a header of a few bytes must not ask for
    // gigabytes.
    void require(size_t count) const;
    uint8_t byte() { return take(1)[0]; }
    uint16_t littleEndian16();
    uint32_t littleEndian32();
    // The next count bytes.
    std::span<const uint8_t> take(size_t count);
    // Those, without going past them. Fewer at the end of the file.
    std::span<const uint8_t> peek(size_t count) const;
    // Up to the next such byte, which is taken but not returned.
    std::string_view until(char end);

  private:
    const EncodedImage& encoded_;
    size_t at_ = 0;
};

// Integers of a file as [0, 1]. By the reciprocal, as most libraries do: half of the 8-bit values differ in the last
// digit from a division's.
inline float fromByte(uint8_t value) { return float(value) * (1 / 255.f); }
inline float fromWord(uint16_t value) { return float(value) * (1 / 65535.f); }

}  // namespace drc
