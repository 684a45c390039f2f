#include "image/pfm.h"

#include <fmt/core.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "base/error.h"
#include "base/limits.h"

namespace drc {
namespace {

bool isSpace(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }

// The next word; leaves `bytes` at the white space after it.
std::string_view nextWord(std::string_view& bytes) {
    while (!bytes.empty() && isSpace(bytes.front())) bytes.remove_prefix(1);
    size_t n = 0;
    while (n < bytes.size() && n < 32 && !isSpace(bytes[n])) ++n;
    const auto word = bytes.substr(0, n);
    bytes.remove_prefix(n);
    return word;
}

template <typename T>
T nextNumber(std::string_view& bytes, const std::string& path, const char* what) {
    std::string_view word = nextWord(bytes);
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    T value{};
    const auto [end, ec] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (ec != std::errc() || end != word.data() + word.size())
        throw Error(fmt::format("cannot read {}: its {} is not a number", path, what));
    return value;
}

}  // namespace

bool isPfm(std::string_view bytes) {
    return bytes.size() > 3 && bytes[0] == 'P' && (bytes[1] == 'F' || bytes[1] == 'f') && isSpace(bytes[2]);
}

Image decodePfm(std::string_view bytes, const std::string& path, PfmOrder order) {
    if (!isPfm(bytes)) throw Error(fmt::format("cannot read {}: it is no PFM file", path));
    const bool colour = nextWord(bytes) == "PF";
    const int width = nextNumber<int>(bytes, path, "width"), height = nextNumber<int>(bytes, path, "height");
    const float scale = nextNumber<float>(bytes, path, "scale");
    if (width <= 0 || height <= 0 || width > limits::kImageSide || height > limits::kImageSide)
        throw Error(fmt::format("cannot read {}: its size is {}x{}", path, width, height));
    if (scale == 0 || !std::isfinite(scale)) throw Error(fmt::format("cannot read {}: its scale is {}", path, scale));
    if (!bytes.empty()) bytes.remove_prefix(1);  // exactly one white space stands before the data

    const size_t channels = colour ? 3 : 1;
    const size_t rowBytes = size_t(width) * channels * sizeof(float);
    if (bytes.size() < rowBytes * size_t(height))
        throw Error(fmt::format("cannot read {}: it ends after {} of {} bytes of pixels", path, bytes.size(),
                                rowBytes * size_t(height)));
    Image image(width, height, colour ? std::vector<std::string>{"R", "G", "B"} : std::vector<std::string>{"Y"});
    const bool little = (scale < 0) == (order == PfmOrder::AsNamed);
    const bool swap = little != (std::endian::native == std::endian::little);
    for (int y = 0; y < height; ++y) {
        const char* row = bytes.data() + rowBytes * size_t(height - 1 - y);
        float* out = image.pixel(0, y);
        for (size_t i = 0; i < size_t(width) * channels; ++i) {
            uint32_t word;
            std::memcpy(&word, row + i * sizeof(word), sizeof(word));
            if (swap) word = __builtin_bswap32(word);
            out[i] = std::bit_cast<float>(word) * std::abs(scale);
        }
    }
    return image;
}

std::string encodePfm(const Image& image) {
    static_assert(std::endian::native == std::endian::little);
    const int channels = image.channels() < 3 ? 1 : 3;
    std::string bytes = fmt::format("{}\n{} {}\n-1\n", channels == 3 ? "PF" : "Pf", image.width(), image.height());
    for (int y = image.height() - 1; y >= 0; --y)
        for (int x = 0; x < image.width(); ++x)
            bytes.append(reinterpret_cast<const char*>(image.pixel(x, y)), size_t(channels) * sizeof(float));
    return bytes;
}

}  // namespace drc
