#include "image/png.h"

#include <fmt/core.h>
#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <csetjmp>
#include <cstring>
#include <vector>

#include "base/error.h"
#include "image/color.h"

// libpng reports an error by longjmp. Therefore, after setjmp, each function below calls nothing but libpng and has no
// objects with destructors: the reader and the writer own all resources, and no jump skips their destructors.

namespace drc {
namespace {

struct Message {
    char text[160] = {};
};

[[noreturn]] void keepMessage(png_structp png, png_const_charp text) {
    auto* message = static_cast<Message*>(png_get_error_ptr(png));
    std::strncpy(message->text, text, sizeof(message->text) - 1);
    png_longjmp(png, 1);
}

void ignoreWarning(png_structp, png_const_charp) {}

class PngReader {
  public:
    explicit PngReader(const EncodedImage& encoded) : encoded_(encoded) {
        png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &message_, keepMessage, ignoreWarning);
        if (png_) info_ = png_create_info_struct(png_);
        if (!info_) failDecoding(encoded, "libpng cannot start");
    }
    ~PngReader() { png_destroy_read_struct(&png_, info_ ? &info_ : nullptr, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    void readHeader() {
        if (!readHeaderOrJump()) fail();
    }
    void readRow(png_bytep row) {
        if (!readRowOrJump(row)) fail();
    }
    void readEnd() {
        if (!readEndOrJump()) fail();
    }

    int64_t width() const { return png_get_image_width(png_, info_); }
    int64_t height() const { return png_get_image_height(png_, info_); }
    int channels() const { return png_get_channels(png_, info_); }
    int bits() const { return png_get_bit_depth(png_, info_); }
    size_t rowBytes() const { return png_get_rowbytes(png_, info_); }
    int passes() const { return passes_; }

  private:
    bool readHeaderOrJump() {
        if (setjmp(png_jmpbuf(png_))) return false;
        png_set_read_fn(png_, this, &PngReader::readBytes);
        png_set_user_limits(png_, limits::kImageSide, limits::kImageSide);
        // Skips chunks that do not change the pixels, such as text and colour profiles.
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
        png_read_info(png_, info_);
        png_set_expand(png_);
        if constexpr (std::endian::native == std::endian::little) png_set_swap(png_);
        passes_ = png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        return true;
    }
    bool readRowOrJump(png_bytep row) {
        if (setjmp(png_jmpbuf(png_))) return false;
        png_read_row(png_, row, nullptr);
        return true;
    }
    bool readEndOrJump() {
        if (setjmp(png_jmpbuf(png_))) return false;
        png_read_end(png_, nullptr);
        return true;
    }
    static void readBytes(png_structp png, png_bytep to, size_t count) {
        auto* reader = static_cast<PngReader*>(png_get_io_ptr(png));
        const size_t left = reader->encoded_.bytes.size() - reader->at_;
        if (count > left) png_error(png, "it is cut short");
        std::memcpy(to, reader->encoded_.bytes.data() + reader->at_, count);
        reader->at_ += count;
    }
    [[noreturn]] void fail() const { failDecoding(encoded_, message_.text); }

    const EncodedImage& encoded_;
    size_t at_ = 0;
    Message message_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    int passes_ = 1;
};

class PngWriter {
  public:
    explicit PngWriter(const std::string& path) : path_(path) {
        png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, &message_, keepMessage, ignoreWarning);
        if (png_) info_ = png_create_info_struct(png_);
        if (!info_) fail();
    }
    ~PngWriter() { png_destroy_write_struct(&png_, info_ ? &info_ : nullptr); }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;

    void writeHeader(int width, int height, bool hasAlpha, int bits, const PngTexts& texts) {
        for (const auto& [keyword, text] : texts) {
            if (!isKeyword(keyword)) {
                std::strncpy(message_.text, "a keyword of its notes is not one", sizeof(message_.text) - 1);
                fail();
            }
            png_text note{};
            note.compression = isAscii(text) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
            note.key = const_cast<char*>(keyword.c_str());  // libpng copies both
            note.text = const_cast<char*>(text.c_str());
            note.text_length = isAscii(text) ? text.size() : 0;
            note.itxt_length = isAscii(text) ? 0 : text.size();
            notes_.push_back(note);
        }
        const int type = hasAlpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB;
        if (!writeHeaderOrJump(png_uint_32(width), png_uint_32(height), type, bits)) fail();
    }
    void writeRow(png_const_bytep row) {
        if (!writeRowOrJump(row)) fail();
    }
    std::string finish() {
        if (!writeEndOrJump()) fail();
        return std::move(bytes_);
    }

  private:
    bool writeHeaderOrJump(png_uint_32 width, png_uint_32 height, int type, int bits) {
        constexpr int kCompression = 6;
        if (setjmp(png_jmpbuf(png_))) return false;
        png_set_write_fn(png_, this, &PngWriter::writeBytes, nullptr);
        png_set_IHDR(png_, info_, width, height, bits, type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                     PNG_FILTER_TYPE_DEFAULT);
        png_set_compression_level(png_, kCompression);
        // Fix the strategy: libpng's own choice changes sizes by a few percent, and reports compare the sizes of
        // pictures.
        png_set_compression_strategy(png_, Z_DEFAULT_STRATEGY);
        png_set_sRGB_gAMA_and_cHRM(png_, info_, PNG_sRGB_INTENT_ABSOLUTE);
        if (!notes_.empty()) png_set_text(png_, info_, notes_.data(), int(notes_.size()));
        png_write_info(png_, info_);
        return true;
    }
    bool writeRowOrJump(png_const_bytep row) {
        if (setjmp(png_jmpbuf(png_))) return false;
        png_write_row(png_, row);
        return true;
    }
    bool writeEndOrJump() {
        if (setjmp(png_jmpbuf(png_))) return false;
        png_write_end(png_, info_);
        return true;
    }
    // Exceptions must not propagate through libpng, which is C.
    static void writeBytes(png_structp png, png_bytep from, size_t count) {
        bool isWritten = true;
        try {
            static_cast<PngWriter*>(png_get_io_ptr(png))->bytes_.append(reinterpret_cast<const char*>(from), count);
        } catch (const std::exception&) {
            isWritten = false;
        }
        if (!isWritten) png_error(png, "there is not enough memory for it");
    }
    [[noreturn]] void fail() const { throw Error(fmt::format("cannot write {}: {}", path_, message_.text)); }

    static bool isAscii(std::string_view text) {
        return std::all_of(text.begin(), text.end(), [](char c) { return c > 0; });
    }
    static bool isKeyword(std::string_view text) {
        return !text.empty() && text.size() < 80 && text.front() != ' ' && text.back() != ' ' &&
               std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
    }

    const std::string& path_;
    std::string bytes_;
    std::vector<png_text> notes_;
    Message message_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

std::vector<std::string> channelNames(int channels) {
    std::vector<std::string> names =
        channels < 3 ? std::vector<std::string>{"Y"} : std::vector<std::string>{"R", "G", "B"};
    if (channels % 2 == 0) names.push_back("A");
    return names;
}

void toFloats(const uint8_t* row, int bits, std::span<float> values) {
    for (size_t i = 0; i < values.size(); ++i) {
        if (bits == 16) {
            uint16_t word;
            std::memcpy(&word, row + i * sizeof(word), sizeof(word));
            values[i] = fromWord(word);
        } else {
            values[i] = fromByte(row[i]);
        }
    }
}

uint32_t bigEndian32(std::string_view bytes) {
    uint32_t value = 0;
    for (size_t i = 0; i < 4; ++i) value = value << 8 | uint8_t(bytes[i]);
    return value;
}

// Calls f(name, data) for each complete chunk. The layout of a file and of its chunks: sections 5.2 and 5.3 of the PNG
// specification, third edition.
template <typename F>
void forEachChunk(std::string_view bytes, const F& f) {
    constexpr size_t kSignature = 8, kAround = 12;  // length, name and checksum of a chunk
    std::string_view rest = bytes.substr(std::min(kSignature, bytes.size()));
    while (rest.size() >= kAround && bigEndian32(rest) <= rest.size() - kAround) {
        const std::string_view name = rest.substr(4, 4), data = rest.substr(8, bigEndian32(rest));
        rest.remove_prefix(kAround + data.size());
        f(name, data);
    }
}

// The file's gamma; 0 if its integers count as sRGB-encoded: the file declares sRGB, gives no gamma, has a colour
// profile (which is not read), or has the gamma that programs write for sRGB. Sections 11.3.2 and 4.2 of the
// specification.
float gammaOf(std::string_view bytes) {
    float gamma = 0;
    bool isSrgb = false, isBeforePixels = true;
    forEachChunk(bytes, [&](std::string_view name, std::string_view data) {
        isBeforePixels &= name != "IDAT";
        if (!isBeforePixels) return;
        isSrgb |= name == "sRGB" || name == "iCCP" || name == "cICP";
        if (name == "gAMA" && data.size() == 4) gamma = float(bigEndian32(data)) / 100000;
    });
    constexpr float kOfSrgb = 1 / 2.2f, kLeast = .1f, kMost = 10;
    const bool isLikeSrgb = std::abs(gamma - kOfSrgb) < .02f;
    return isSrgb || isLikeSrgb || gamma < kLeast || gamma > kMost ? 0.f : gamma;
}

}  // namespace

ImageFile decodePng(const EncodedImage& encoded) {
    PngReader reader(encoded);
    reader.readHeader();
    // Each pass of an interlaced picture fills in some of its pixels, so all rows are kept until the last pass.
    const bool isInterlaced = reader.passes() > 1;
    const double bytes = isInterlaced ? double(reader.rowBytes()) * double(reader.height()) : 0;
    const MemoryClaim memory = claimMemory(encoded, reader.width(), reader.height(), reader.channels(), bytes);
    const int width = int(reader.width()), height = int(reader.height());

    ImageFile file;
    file.image = Image(width, height, channelNames(reader.channels()));
    file.encoding = reader.bits() == 16 ? Encoding::UInt16 : Encoding::UInt8;
    std::vector<uint8_t> rows(reader.rowBytes() * size_t(isInterlaced ? height : 1));
    for (int pass = 0; pass < reader.passes(); ++pass) {
        for (int y = 0; y < height; ++y) {
            uint8_t* row = rows.data() + (isInterlaced ? reader.rowBytes() * size_t(y) : 0);
            reader.readRow(row);
            if (pass + 1 == reader.passes())
                toFloats(row, reader.bits(), {file.image.pixel(0, y), size_t(width) * size_t(reader.channels())});
        }
    }
    reader.readEnd();
    file.gamma = gammaOf(encoded.bytes);
    return file;
}

PngTexts decodePngTexts(const EncodedImage& encoded) {
    PngTexts texts;
    forEachChunk(encoded.bytes, [&](std::string_view name, std::string_view data) {
        const size_t end = data.find('\0');
        if (end == std::string_view::npos || end == 0) return;
        std::string text;
        // Section 11.3.3.
        if (name == "tEXt") {
            text = data.substr(end + 1);
            for (char& c : text) c = uint8_t(c) < 128 ? c : '?';
        } else if (name == "iTXt" && data.size() > end + 3 && data[end + 1] == 0) {
            // Two flags, the language and the translated keyword precede the text.
            const size_t language = data.find('\0', end + 3);
            const size_t keyword = language == std::string_view::npos ? language : data.find('\0', language + 1);
            if (keyword == std::string_view::npos) return;
            text = data.substr(keyword + 1);
        } else {
            return;
        }
        texts[std::string(data.substr(0, end))] = std::move(text);
    });
    return texts;
}

std::string encodePng(const Image& linear, const std::string& path, const PngTexts& texts, const Image* alpha,
                      PngBits bits) {
    if (linear.empty()) throw Error(fmt::format("cannot write {}: the image is empty", path));
    PngWriter writer(path);
    const bool isWide = bits == PngBits::Sixteen;
    writer.writeHeader(linear.width(), linear.height(), alpha != nullptr, isWide ? 16 : 8, texts);
    std::vector<uint8_t> row;
    row.reserve(size_t(linear.width()) * 8);
    const auto add = [&](float encoded) {
        if (!isWide) return row.push_back(toByte(encoded));
        const auto word = uint16_t(clamp01(encoded) * 65535 + .5f);
        row.push_back(uint8_t(word >> 8)), row.push_back(uint8_t(word));
    };
    for (int y = 0; y < linear.height(); ++y) {
        row.clear();
        for (int x = 0; x < linear.width(); ++x) {
            const Rgb c = linear.rgb(x, y);
            for (int i = 0; i < 3; ++i) add(srgbEncode(c[i]));
            if (alpha) add(alpha->at(x, y, 0));
        }
        writer.writeRow(row.data());
    }
    return writer.finish();
}

}  // namespace drc
