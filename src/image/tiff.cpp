#include "image/tiff.h"

#include <Imath/half.h>
#include <fmt/core.h>
#include <tiffio.h>

#include <algorithm>
#include <bit>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

namespace drc {
namespace {

using namespace std::string_view_literals;

// The file in memory, for libtiff's callbacks, and the first error that libtiff has reported.
struct TiffSource {
    explicit TiffSource(const EncodedImage& of) : encoded(of) {}

    const EncodedImage& encoded;
    uint64_t at = 0;
    std::string error;

    static TiffSource& of(thandle_t handle) { return *static_cast<TiffSource*>(handle); }
    static tmsize_t read(thandle_t handle, void* to, tmsize_t count) {
        TiffSource& source = of(handle);
        const std::string_view bytes = source.encoded.bytes;
        if (source.at >= bytes.size() || count <= 0) return 0;
        const size_t n = std::min(size_t(count), bytes.size() - size_t(source.at));
        std::memcpy(to, bytes.data() + source.at, n);
        source.at += n;
        return tmsize_t(n);
    }
    static tmsize_t write(thandle_t, void*, tmsize_t) { return 0; }
    static toff_t seek(thandle_t handle, toff_t offset, int whence) {
        TiffSource& source = of(handle);
        const uint64_t size = source.encoded.bytes.size();
        source.at = (whence == SEEK_CUR ? source.at : whence == SEEK_END ? size : 0) + offset;
        return source.at;
    }
    static int close(thandle_t) { return 0; }
    static toff_t size(thandle_t handle) { return of(handle).encoded.bytes.size(); }
    static int map(thandle_t handle, void** base, toff_t* size) {
        *base = const_cast<char*>(of(handle).encoded.bytes.data());
        *size = of(handle).encoded.bytes.size();
        return 1;
    }
    static void unmap(thandle_t, void*, toff_t) {}
    // Keeps the first error, because it causes the others.
    static int keepError(TIFF*, void* user, const char*, const char* format, va_list arguments) {
        TiffSource& source = *static_cast<TiffSource*>(user);
        char text[200];
        std::vsnprintf(text, sizeof(text), format, arguments);
        if (source.error.empty()) source.error = text;
        return 1;
    }
    static int ignoreWarning(TIFF*, void*, const char*, const char*, va_list) { return 1; }
};

// Size, sample format and orientation of a picture.
struct TiffLayout {
    uint32_t width = 0, height = 0;
    uint16_t bits = 1, samples = 1, format = SAMPLEFORMAT_UINT, planar = PLANARCONFIG_CONTIG, photometric = 0,
             orientation = ORIENTATION_TOPLEFT, compression = COMPRESSION_NONE;
    int alpha = -1;  // index of the alpha sample; -1: none
    bool isAssociated = false;

    bool isGrey() const { return photometric == PHOTOMETRIC_MINISBLACK || photometric == PHOTOMETRIC_MINISWHITE; }
    bool isFloat() const { return format == SAMPLEFORMAT_IEEEFP; }
    // Whether the samples can be read directly, without libtiff's conversion of colours.
    bool isPlain() const {
        const bool bitsFit = isFloat() ? bits == 16 || bits == 32 || bits == 64
                                       : format == SAMPLEFORMAT_UINT && (bits == 8 || bits == 16);
        return bitsFit && (isGrey() || (photometric == PHOTOMETRIC_RGB && samples >= 3));
    }
    int colours() const { return isGrey() ? 1 : 3; }
    bool isTransposed() const { return orientation >= ORIENTATION_LEFTTOP; }
};

class TiffReader {
  public:
    explicit TiffReader(const EncodedImage& encoded) : encoded_(encoded), source_(encoded) {
        constexpr tmsize_t kMostBytes = tmsize_t(1) << 31;  // of a strip or a tile
        const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(TIFFOpenOptionsAlloc(),
                                                                                   TIFFOpenOptionsFree);
        TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), kMostBytes);
        TIFFOpenOptionsSetErrorHandlerExtR(options.get(), &TiffSource::keepError, &source_);
        TIFFOpenOptionsSetWarningHandlerExtR(options.get(), &TiffSource::ignoreWarning, nullptr);
        tiff_.reset(TIFFClientOpenExt(encoded.path.c_str(), "r", &source_, &TiffSource::read, &TiffSource::write,
                                      &TiffSource::seek, &TiffSource::close, &TiffSource::size, &TiffSource::map,
                                      &TiffSource::unmap, options.get()));
        if (!tiff_) fail();
        readLayout();
    }

    ImageFile read() {
        const TiffLayout& l = layout_;
        const int channels = l.colours() + (l.alpha >= 0);
        const MemoryClaim memory =
            claimMemory(encoded_, l.width, l.height, channels, double(l.width) * double(l.height) * 4);
        std::vector<std::string> names =
            channels < 3 ? std::vector<std::string>{"Y"} : std::vector<std::string>{"R", "G", "B"};
        if (channels % 2 == 0) names.push_back("A");
        ImageFile file;
        file.image =
            l.isTransposed() ? Image(int(l.height), int(l.width), names) : Image(int(l.width), int(l.height), names);
        file.encoding = l.isFloat() && l.isPlain()    ? Encoding::Float
                        : l.bits == 16 && l.isPlain() ? Encoding::UInt16
                                                      : Encoding::UInt8;
        if (!l.isPlain())
            readAsShown(file.image);
        else if (TIFFIsTiled(tiff_.get()))
            readTiles(file.image);
        else
            readRows(file.image);
        if (l.alpha >= 0) multiplyAlpha(file.image);
        return file;
    }

  private:
    [[noreturn]] void fail() const {
        failDecoding(encoded_, source_.error.empty() ? "the file is damaged" : source_.error);
    }

    void readLayout() {
        TIFF* const t = tiff_.get();
        TiffLayout& l = layout_;
        if (!TIFFGetField(t, TIFFTAG_IMAGEWIDTH, &l.width) || !TIFFGetField(t, TIFFTAG_IMAGELENGTH, &l.height))
            failDecoding(encoded_, "it gives no size");
        TIFFGetFieldDefaulted(t, TIFFTAG_BITSPERSAMPLE, &l.bits);
        TIFFGetFieldDefaulted(t, TIFFTAG_SAMPLESPERPIXEL, &l.samples);
        TIFFGetFieldDefaulted(t, TIFFTAG_SAMPLEFORMAT, &l.format);
        TIFFGetFieldDefaulted(t, TIFFTAG_PLANARCONFIG, &l.planar);
        TIFFGetFieldDefaulted(t, TIFFTAG_ORIENTATION, &l.orientation);
        TIFFGetFieldDefaulted(t, TIFFTAG_COMPRESSION, &l.compression);
        if (!TIFFGetField(t, TIFFTAG_PHOTOMETRIC, &l.photometric))
            l.photometric = l.samples < 3 ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB;
        if (l.compression == COMPRESSION_JPEG && l.photometric == PHOTOMETRIC_YCBCR) {
            TIFFSetField(t, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
            l.photometric = PHOTOMETRIC_RGB;
        }
        if (l.format == SAMPLEFORMAT_VOID) l.format = SAMPLEFORMAT_UINT;
        if (l.format != SAMPLEFORMAT_UINT && !l.isFloat())
            failDecoding(encoded_, "its values are signed or complex; unsigned integers and floats are read");
        if (l.bits > 16 && !l.isFloat())
            failDecoding(encoded_, fmt::format("its integers have {} bits; 16 at most are read", l.bits));
        uint16_t extras = 0;
        const uint16_t* kinds = nullptr;
        TIFFGetFieldDefaulted(t, TIFFTAG_EXTRASAMPLES, &extras, &kinds);
        for (int i = 0; i < int(extras) && l.alpha < 0; ++i)
            if (const int sample = l.colours() + i;
                sample < int(l.samples) && (kinds[i] == EXTRASAMPLE_ASSOCALPHA || kinds[i] == EXTRASAMPLE_UNASSALPHA)) {
                l.alpha = sample;
                l.isAssociated = kinds[i] == EXTRASAMPLE_ASSOCALPHA;
            }
    }

    // The pixel of the image for a row and column of the file, according to the orientation.
    float* pixelAt(Image& image, uint32_t column, uint32_t row) const {
        const TiffLayout& l = layout_;
        const bool fromRight = l.orientation == ORIENTATION_TOPRIGHT || l.orientation == ORIENTATION_BOTRIGHT ||
                               l.orientation == ORIENTATION_RIGHTTOP || l.orientation == ORIENTATION_RIGHTBOT;
        const bool fromBottom = l.orientation == ORIENTATION_BOTRIGHT || l.orientation == ORIENTATION_BOTLEFT ||
                                l.orientation == ORIENTATION_RIGHTBOT || l.orientation == ORIENTATION_LEFTBOT;
        int x = int(l.isTransposed() ? row : column), y = int(l.isTransposed() ? column : row);
        if (fromRight) x = image.width() - 1 - x;
        if (fromBottom) y = image.height() - 1 - y;
        return image.pixel(x, y);
    }

    float valueAt(const uint8_t* bytes, size_t index) const {
        const auto load = [&](auto value) {
            std::memcpy(&value, bytes + index * sizeof(value), sizeof(value));
            return value;
        };
        const TiffLayout& l = layout_;
        float value = 0;
        if (l.isFloat())
            value = l.bits == 16   ? float(std::bit_cast<Imath::half>(load(uint16_t())))
                    : l.bits == 32 ? load(float())
                                   : float(load(double()));
        else
            value = l.bits == 16 ? fromWord(load(uint16_t())) : fromByte(bytes[index]);
        return value;
    }

    // Stores `count` pixels of the file's row, starting at (column, row). If planes are separate, only the sample
    // `plane`.
    void store(Image& image, const uint8_t* bytes, uint32_t column, uint32_t row, uint32_t count, int plane) const {
        const TiffLayout& l = layout_;
        const bool isApart = l.planar == PLANARCONFIG_SEPARATE;
        const size_t samples = samplesPerValue();
        for (uint32_t i = 0; i < count; ++i) {
            float* const pixel = pixelAt(image, column + i, row);
            for (int c = 0; c < image.channels(); ++c) {
                const int sample = c < l.colours() ? c : l.alpha;
                if (isApart && sample != plane) continue;
                const float v = valueAt(bytes, i * samples + size_t(isApart ? 0 : sample));
                pixel[c] = l.photometric == PHOTOMETRIC_MINISWHITE && c == 0 ? 1 - v : v;
            }
        }
    }

    size_t samplesPerValue() const { return layout_.planar == PLANARCONFIG_SEPARATE ? 1 : layout_.samples; }
    // The planes to read; only plane 0 if the samples are interleaved.
    std::vector<int> planes() const {
        std::vector<int> planes{0};
        if (layout_.planar != PLANARCONFIG_SEPARATE) return planes;
        for (int c = 1; c < layout_.colours(); ++c) planes.push_back(c);
        if (layout_.alpha >= 0) planes.push_back(layout_.alpha);
        return planes;
    }

    void readRows(Image& image) {
        const tmsize_t size = TIFFScanlineSize(tiff_.get());
        if (size <= 0 || size_t(size) < size_t(layout_.width) * samplesPerValue() * layout_.bits / 8) fail();
        const MemoryClaim memory(double(size), fmt::format("a row of the picture {}", encoded_.path));
        std::vector<uint8_t> row(static_cast<size_t>(size));
        for (const int plane : planes())
            for (uint32_t y = 0; y < layout_.height; ++y) {
                if (TIFFReadScanline(tiff_.get(), row.data(), y, uint16_t(plane)) < 0) fail();
                store(image, row.data(), 0, y, layout_.width, plane);
            }
    }

    void readTiles(Image& image) {
        uint32_t width = 0, height = 0;
        TIFFGetField(tiff_.get(), TIFFTAG_TILEWIDTH, &width);
        TIFFGetField(tiff_.get(), TIFFTAG_TILELENGTH, &height);
        if (width == 0 || height == 0 || int64_t(width) * int64_t(height) > encoded_.mostPixels)
            failDecoding(encoded_, fmt::format("its tiles are {}x{}; at most {} pixels are read", width, height,
                                               encoded_.mostPixels));
        const tmsize_t size = TIFFTileSize(tiff_.get()), rowSize = TIFFTileRowSize(tiff_.get());
        if (size <= 0 || rowSize <= 0 || size_t(rowSize) < size_t(width) * samplesPerValue() * layout_.bits / 8 ||
            size_t(size) < size_t(rowSize) * height)
            fail();
        const MemoryClaim memory(double(size), fmt::format("a tile of the picture {}", encoded_.path));
        std::vector<uint8_t> tile(static_cast<size_t>(size));
        for (const int plane : planes())
            for (uint32_t y = 0; y < layout_.height; y += height)
                for (uint32_t x = 0; x < layout_.width; x += width) {
                    if (TIFFReadTile(tiff_.get(), tile.data(), x, y, 0, uint16_t(plane)) < 0) fail();
                    for (uint32_t row = y; row < std::min(y + height, layout_.height); ++row)
                        store(image, tile.data() + size_t(row - y) * size_t(rowSize), x, row,
                              std::min(width, layout_.width - x), plane);
                }
    }

    // Reads the picture as libtiff converts it to 8-bit RGBA, premultiplied by alpha.
    void readAsShown(Image& image) {
        char reason[1024] = {};
        if (!TIFFRGBAImageOK(tiff_.get(), reason)) failDecoding(encoded_, reason);
        std::vector<uint32_t> pixels(size_t(layout_.width) * layout_.height);
        if (!TIFFReadRGBAImageOriented(tiff_.get(), layout_.width, layout_.height, pixels.data(), layout_.orientation,
                                       1))
            fail();
        for (uint32_t y = 0; y < layout_.height; ++y)
            for (uint32_t x = 0; x < layout_.width; ++x) {
                const uint32_t p = pixels[size_t(y) * layout_.width + x];
                float* const to = pixelAt(image, x, y);
                const uint8_t colours[] = {uint8_t(TIFFGetR(p)), uint8_t(TIFFGetG(p)), uint8_t(TIFFGetB(p))};
                for (int c = 0; c < layout_.colours(); ++c) to[c] = fromByte(colours[c]);
                if (layout_.alpha >= 0) to[layout_.colours()] = fromByte(uint8_t(TIFFGetA(p)));
            }
    }

    void multiplyAlpha(Image& image) const {
        const bool isMultiplied = layout_.isAssociated || !layout_.isPlain();
        if (isMultiplied == layout_.isFloat()) return;
        const int last = image.channels() - 1;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                float* const p = image.pixel(x, y);
                const float alpha = p[last];
                for (int c = 0; c < last; ++c) {
                    if (layout_.isFloat())
                        p[c] *= alpha;
                    else
                        p[c] = alpha > 0 ? std::min(1.f, p[c] / alpha) : 0.f;
                }
            }
    }

    const EncodedImage& encoded_;
    TiffSource source_;
    TiffLayout layout_;
    std::unique_ptr<TIFF, void (*)(TIFF*)> tiff_{nullptr, TIFFClose};
};

}  // namespace

bool isTiff(std::string_view bytes) {
    return bytes.starts_with("II*\0"sv) || bytes.starts_with("MM\0*"sv) || bytes.starts_with("II+\0"sv) ||
           bytes.starts_with("MM\0+"sv);
}

ImageFile decodeTiff(const EncodedImage& encoded) { return TiffReader(encoded).read(); }

}  // namespace drc
