#include "image/encoded_image.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.h"
#include "math/vec.h"

namespace drc {

void failDecoding(const EncodedImage& encoded, std::string_view what) {
    throw Error(fmt::format("cannot read {}: {}", encoded.path, what));
}

MemoryClaim claimMemory(const EncodedImage& encoded, int64_t width, int64_t height, int64_t channels,
                        double extraBytes) {
    const int64_t mostPixels = std::min(encoded.mostPixels, limits::kImagePixels);
    if (width <= 0 || height <= 0 || channels <= 0)
        failDecoding(encoded, fmt::format("its size is {}x{} with {} channels", width, height, channels));
    if (width > limits::kImageSide || height > limits::kImageSide || width * height > mostPixels ||
        channels > limits::kImageChannels)
        failDecoding(encoded,
                     fmt::format("its size is {}x{} with {} channels; at most {} a side, {} in all and {} "
                                 "channels are read",
                                 width, height, channels, limits::kImageSide, mostPixels, limits::kImageChannels));
    const double bytesPerPixel = double(channels) * sizeof(float) + 3 * sizeof(Rgb);
    return MemoryClaim(double(width) * double(height) * bytesPerPixel + extraBytes,
                       fmt::format("the picture {}, of {}x{} pixels,", encoded.path, width, height));
}

std::span<const uint8_t> ByteReader::peek(size_t count) const {
    const auto* first = reinterpret_cast<const uint8_t*>(encoded_.bytes.data()) + at_;
    return {first, std::min(count, left())};
}

void ByteReader::require(size_t count) const {
    if (count > left()) failDecoding(encoded_, fmt::format("it is cut short after {} bytes", encoded_.bytes.size()));
}

std::span<const uint8_t> ByteReader::take(size_t count) {
    require(count);
    const auto taken = peek(count);
    at_ += count;
    return taken;
}

uint16_t ByteReader::littleEndian16() {
    const auto b = take(2);
    return uint16_t(b[0] | b[1] << 8);
}

uint32_t ByteReader::littleEndian32() {
    const uint32_t low = littleEndian16();
    return low | uint32_t(littleEndian16()) << 16;
}

std::string_view ByteReader::until(char end) {
    const size_t stop = encoded_.bytes.find(end, at_);
    if (stop == std::string_view::npos) require(left() + 1);
    const std::string_view text = encoded_.bytes.substr(at_, stop - at_);
    at_ = stop + 1;
    return text;
}

}  // namespace drc
