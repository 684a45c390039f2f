#include "image/tga.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <vector>

namespace drc {
namespace {

constexpr size_t kHeaderBytes = 18;

struct TgaHeader {
    int identBytes = 0;
    int paletteType = 0;
    int kind = 0;
    int paletteFirst = 0, paletteSize = 0, paletteBits = 0;
    int width = 0, height = 0, bits = 0;
    int alphaBits = 0;
    bool fromRight = false, fromTop = false;

    bool isPacked() const { return (kind & 8) != 0; }
    bool isPalette() const { return (kind & 7) == 1; }
    bool isGrey() const { return (kind & 7) == 3; }
    int bytesPerPixel() const { return (bits + 7) / 8; }
};

TgaHeader readHeader(ByteReader& in) {
    TgaHeader h;
    h.identBytes = in.byte();
    h.paletteType = in.byte();
    h.kind = in.byte();
    h.paletteFirst = in.littleEndian16();
    h.paletteSize = in.littleEndian16();
    h.paletteBits = in.byte();
    in.take(4);  // position on the screen
    h.width = in.littleEndian16();
    h.height = in.littleEndian16();
    h.bits = in.byte();
    const int descriptor = in.byte();
    h.alphaBits = descriptor & 15;
    h.fromRight = (descriptor & 16) != 0;
    h.fromTop = (descriptor & 32) != 0;
    return h;
}

bool isColourDepth(int bits) { return bits == 15 || bits == 16 || bits == 24 || bits == 32; }

// Describes what is impossible in the header; empty if it is valid.
std::string faultOf(const TgaHeader& h) {
    const int kind = h.kind & 7;
    if (h.kind > 11 || kind < 1 || kind > 3) return fmt::format("there is no TGA of kind {}", h.kind);
    if (h.paletteType > 1) return fmt::format("there is no TGA palette of kind {}", h.paletteType);
    const bool fits = h.isPalette() || h.isGrey() ? h.bits == 8 || h.bits == 16 : isColourDepth(h.bits);
    if (!fits) return fmt::format("a TGA of kind {} cannot have {} bits per pixel", h.kind, h.bits);
    if (h.isPalette() && h.paletteType != 1) return "its colours are those of a palette, and it has none";
    if (h.paletteType == 1 && !isColourDepth(h.paletteBits))
        return fmt::format("a TGA's palette cannot have {} bits per colour", h.paletteBits);
    return "";
}

struct Colour {
    uint8_t r, g, b, a;
};

// Five bits repeat their first three, so that 31 becomes 255.
uint8_t fromFiveBits(int v) { return uint8_t(v << 3 | v >> 2); }

Colour colourOf(const uint8_t* p, int bits) {
    if (bits > 16) return {p[2], p[1], p[0], bits == 32 ? p[3] : uint8_t(255)};
    const int v = p[0] | p[1] << 8;
    return {fromFiveBits(v >> 10 & 31), fromFiveBits(v >> 5 & 31), fromFiveBits(v & 31), 255};
}

// Reads the pixels in the file's order, not by rows, because a run may continue beyond the end of a row.
class Pixels {
  public:
    Pixels(ByteReader& in, const TgaHeader& header)
        : in_(in), size_(size_t(header.bytesPerPixel())), isPacked_(header.isPacked()) {}

    const uint8_t* next() {
        if (!isPacked_) return in_.take(size_).data();
        if (left_ == 0) {
            const uint8_t head = in_.byte();
            isRun_ = (head & 128) != 0;
            left_ = (head & 127) + 1;
            if (isRun_) run_ = in_.take(size_).data();
        }
        --left_;
        return isRun_ ? run_ : in_.take(size_).data();
    }

  private:
    ByteReader& in_;
    size_t size_;
    bool isPacked_;
    bool isRun_ = false;
    int left_ = 0;
    const uint8_t* run_ = nullptr;
};

std::vector<Colour> readPalette(ByteReader& in, const TgaHeader& header) {
    if (header.paletteType == 0) return {};
    std::vector<Colour> palette(size_t(header.paletteSize));
    const size_t size = size_t(header.paletteBits + 7) / 8;
    for (Colour& colour : palette) colour = colourOf(in.take(size).data(), header.paletteBits);
    return palette;
}

// The fewest bytes that the pixels can take. A packet covers up to 128 of them.
size_t leastBytes(const TgaHeader& header) {
    const size_t pixels = size_t(header.width) * size_t(header.height), size = size_t(header.bytesPerPixel());
    return header.isPacked() ? (pixels + 127) / 128 * (1 + size) : pixels * size;
}

}  // namespace

bool hasTgaHeader(std::string_view bytes) {
    if (bytes.size() < kHeaderBytes) return false;
    const EncodedImage encoded{bytes, ""};
    ByteReader in(encoded);
    const TgaHeader header = readHeader(in);
    return faultOf(header).empty() && header.width > 0 && header.height > 0;
}

bool hasTgaFooter(std::string_view bytes) {
    using namespace std::string_view_literals;
    return bytes.size() > kHeaderBytes && bytes.ends_with("TRUEVISION-XFILE.\0"sv);
}

ImageFile decodeTga(const EncodedImage& encoded) {
    ByteReader in(encoded);
    const TgaHeader header = readHeader(in);
    if (const std::string fault = faultOf(header); !fault.empty()) failDecoding(encoded, fault);
    std::vector<std::string> names = {"R", "G", "B"};
    if (header.isGrey()) names = {"Y"};
    if (header.isGrey() ? header.bits == 16 && header.alphaBits > 0 : header.bits == 32) names.push_back("A");
    const MemoryClaim memory = claimMemory(encoded, header.width, header.height, int64_t(names.size()));

    in.take(size_t(header.identBytes));
    const std::vector<Colour> palette = readPalette(in, header);
    in.require(leastBytes(header));

    ImageFile file{Image(header.width, header.height, std::move(names)), Encoding::UInt8};
    const int channels = file.image.channels();
    Pixels pixels(in, header);
    for (int row = 0; row < header.height; ++row) {
        const int y = header.fromTop ? row : header.height - 1 - row;
        for (int column = 0; column < header.width; ++column) {
            const int x = header.fromRight ? header.width - 1 - column : column;
            const uint8_t* p = pixels.next();
            std::array<uint8_t, 4> values{};
            if (header.isGrey()) {
                values = {p[0], header.bits == 16 ? p[1] : uint8_t(255), 0, 0};
            } else if (header.isPalette()) {
                const int index = (header.bits == 16 ? p[0] | p[1] << 8 : p[0]) - header.paletteFirst;
                if (index < 0 || index >= int(palette.size()))
                    failDecoding(encoded,
                                 fmt::format("a pixel has colour {} of its palette, which has colours {} to {}",
                                             index + header.paletteFirst, header.paletteFirst,
                                             header.paletteFirst + int(palette.size()) - 1));
                const Colour c = palette[size_t(index)];
                values = {c.r, c.g, c.b, c.a};
            } else {
                const Colour c = colourOf(p, header.bits);
                values = {c.r, c.g, c.b, c.a};
            }
            float* out = file.image.pixel(x, y);
            for (int c = 0; c < channels; ++c) out[c] = fromByte(values[size_t(c)]);
        }
    }
    return file;
}

}  // namespace drc
