// An encoded picture, and what the decoders of all formats share: limits, memory claims and the form of error messages.
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

// Throws Error if the size is not positive or is beyond the limits. Reserves the memory that the picture takes until it
// is ready for rendering: its floats; three Rgb per pixel for a texture's colours, a copy of them and their mip levels,
// which covers other uses too; and `extraBytes` for the decoder. Hold the claim while the picture is read, and no
// longer. Claims for pictures that are read at the same time add up.
[[nodiscard]] MemoryClaim claimMemory(const EncodedImage& encoded, int64_t width, int64_t height, int64_t channels,
                                      double extraBytes = 0);

// Reads a file's bytes from the start. Throws Error where bytes are missing.
class ByteReader {
  public:
    explicit ByteReader(const EncodedImage& encoded) : encoded_(encoded) {}

    size_t left() const { return encoded_.bytes.size() - at_; }
    // Throws Error if fewer bytes are left. Call it before allocating a picture, because a file of a few bytes must not
    // make the decoder allocate gigabytes.
    void require(size_t count) const;
    uint8_t byte() { return take(1)[0]; }
    uint16_t littleEndian16();
    uint32_t littleEndian32();
    // The next `count` bytes.
    std::span<const uint8_t> take(size_t count);
    // Like take(), but without moving past the bytes. Returns fewer at the end of the file.
    std::span<const uint8_t> peek(size_t count) const;
    // The bytes up to the next `end`, which is consumed but not returned.
    std::string_view until(char end);

  private:
    const EncodedImage& encoded_;
    size_t at_ = 0;
};

// Integers of a file, mapped to [0, 1]. Multiplies by the reciprocal, as most libraries do: for half of the 8-bit
// values, a division would differ in the last digit.
inline float fromByte(uint8_t value) { return float(value) * (1 / 255.f); }
inline float fromWord(uint16_t value) { return float(value) * (1 / 65535.f); }

}  // namespace drc
