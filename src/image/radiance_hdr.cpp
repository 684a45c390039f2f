#include "image/radiance_hdr.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

namespace drc {
namespace {

using Rgbe = std::array<uint8_t, 4>;

// Where the file's rows lie in the picture: "-Y 480 +X 640" is 480 rows from the top down, each from left to right.
struct Layout {
    int rows = 0, rowLength = 0;  // in the file; its rows may be the picture's columns
    bool rowsAreColumns = false;
    bool fromRight = false, fromBottom = false;

    int width() const { return rowsAreColumns ? rows : rowLength; }
    int height() const { return rowsAreColumns ? rowLength : rows; }
};

std::string_view nextHeaderWord(std::string_view& text) {
    const size_t start = std::min(text.find_first_not_of(" \t"), text.size());
    text.remove_prefix(start);
    const std::string_view word = text.substr(0, text.find_first_of(" \t"));
    text.remove_prefix(word.size());
    return word;
}

// Reads an axis such as "+X 640": the sign, the axis 'X' or 'Y', and the size. False if the text is no axis.
bool readAxis(std::string_view& text, char& axis, bool& isPositive, int& size) {
    const std::string_view name = nextHeaderWord(text), number = nextHeaderWord(text);
    if (name.size() != 2 || (name[0] != '+' && name[0] != '-') || (name[1] != 'X' && name[1] != 'Y')) return false;
    isPositive = name[0] == '+';
    axis = name[1];
    const char* const end = number.data() + number.size();
    const auto [stop, error] = std::from_chars(number.data(), end, size);
    return error == std::errc() && stop == end;
}

Layout readLayout(const EncodedImage& encoded, std::string_view line) {
    Layout layout;
    char first = 0, second = 0;
    bool firstUp = false, secondUp = false;
    std::string_view rest = line;
    if (!readAxis(rest, first, firstUp, layout.rows) || !readAxis(rest, second, secondUp, layout.rowLength) ||
        first == second)
        failDecoding(encoded,
                     fmt::format("its size is given as \"{}\", not as \"-Y HEIGHT +X WIDTH\"", line.substr(0, 80)));
    layout.rowsAreColumns = first == 'X';
    layout.fromRight = !(first == 'X' ? firstUp : secondUp);
    layout.fromBottom = first == 'Y' ? firstUp : secondUp;
    return layout;
}

std::string_view nextLine(ByteReader& in) {
    std::string_view line = in.until('\n');
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

Layout readHeader(const EncodedImage& encoded, ByteReader& in) {
    constexpr std::string_view kFormat = "FORMAT=";
    nextLine(in);  // "#?RADIANCE", or another program's name
    for (std::string_view line = nextLine(in); !line.empty(); line = nextLine(in)) {
        if (!line.starts_with(kFormat)) continue;
        line.remove_prefix(kFormat.size());
        if (const std::string_view format = nextHeaderWord(line); format != "32-bit_rle_rgbe")
            failDecoding(encoded, fmt::format("its FORMAT is {}, and 32-bit_rle_rgbe is read", format.substr(0, 80)));
    }
    return readLayout(encoded, nextLine(in));
}

class RowReader {
  public:
    RowReader(const EncodedImage& encoded, ByteReader& in) : encoded_(encoded), in_(in) {}

    void read(std::span<Rgbe> row) {
        constexpr size_t kShortest = 8, kLongest = 0x7fff;  // row lengths that the new encoding may have
        const auto head = in_.peek(4);
        const bool isNew = head.size() == 4 && row.size() >= kShortest && row.size() <= kLongest && head[0] == 2 &&
                           head[1] == 2 && head[2] < 128;
        if (!isNew) return readOld(row);
        in_.take(4);
        if (const int length = head[2] << 8 | head[3]; length != int(row.size()))
            failDecoding(encoded_, fmt::format("a row of {} pixels says that it has {}", row.size(), length));
        for (size_t channel = 0; channel < 4; ++channel) readChannel(row, channel);
    }

  private:
    void readChannel(std::span<Rgbe> row, size_t channel) {
        for (size_t x = 0; x < row.size();) {
            const uint8_t code = in_.byte();
            const bool isRun = code > 128;
            const size_t count = isRun ? code & 127u : code;
            if (count == 0 || count > row.size() - x) failRun(count, row.size() - x);
            const auto values = in_.take(isRun ? 1 : count);
            for (size_t i = 0; i < count; ++i) row[x++][channel] = values[isRun ? 0 : i];
        }
    }

    // A pixel with the mantissas 1, 1, 1 repeats the pixel before it; its exponent is the number of repetitions. In a
    // sequence of such pixels, each number counts 256 times as much as the one before.
    void readOld(std::span<Rgbe> row) {
        int shift = 0;
        for (size_t x = 0; x < row.size();) {
            const auto p = in_.take(4);
            if (p[0] != 1 || p[1] != 1 || p[2] != 1) {
                row[x++] = {p[0], p[1], p[2], p[3]};
                shift = 0;
                continue;
            }
            const size_t count = shift < 24 ? size_t(p[3]) << shift : size_t(p[3]) << 24;
            if (x == 0 || count > row.size() - x) failRun(count, row.size() - x);
            for (size_t i = 0; i < count; ++i, ++x) row[x] = row[x - 1];
            shift += 8;
        }
    }

    [[noreturn]] void failRun(size_t count, size_t room) const {
        failDecoding(encoded_, fmt::format("a run of {} pixels stands where {} are left in the row", count, room));
    }

    const EncodedImage& encoded_;
    ByteReader& in_;
};

}  // namespace

ImageFile decodeRadianceHdr(const EncodedImage& encoded) {
    ByteReader in(encoded);
    const Layout layout = readHeader(encoded, in);
    const MemoryClaim memory = claimMemory(encoded, layout.width(), layout.height(), 3);
    in.require(size_t(layout.rows) * 4);

    ImageFile file{Image(layout.width(), layout.height()), Encoding::Float};
    RowReader reader(encoded, in);
    std::vector<Rgbe> row(size_t(layout.rowLength));
    for (int i = 0; i < layout.rows; ++i) {
        reader.read(row);
        for (int j = 0; j < layout.rowLength; ++j) {
            const int x = layout.rowsAreColumns ? i : j, y = layout.rowsAreColumns ? j : i;
            const Rgbe& p = row[size_t(j)];
            const float scale = p[3] == 0 ? 0.f : std::ldexp(1.f, int(p[3]) - 136);
            file.image.setRgb(layout.fromRight ? layout.width() - 1 - x : x,
                              layout.fromBottom ? layout.height() - 1 - y : y,
                              Rgb(float(p[0]), float(p[1]), float(p[2])) * scale);
        }
    }
    return file;
}

}  // namespace drc
