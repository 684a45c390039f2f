#include "image/image_format.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "image/pfm.h"
#include "image/tga.h"
#include "image/tiff.h"

namespace drc {
namespace {

using namespace std::string_view_literals;

// The signature of a format: the bytes `mark` at `offset`.
struct Mark {
    std::string_view format;
    size_t offset;
    std::string_view mark;
};

constexpr Mark kForeign[] = {
    {"GIF", 0, "GIF8"},
    {"BMP", 0, "BM"},
    {"WebP", 8, "WEBP"},
    {"DPX", 0, "SDPX"},
    {"DPX", 0, "XPDS"},
    {"Cineon", 0, "\x80\x2a\x5f\xd7"},
    {"PNM", 0, "P1\n"},
    {"PNM", 0, "P2\n"},
    {"PNM", 0, "P3\n"},
    {"PNM", 0, "P4\n"},
    {"PNM", 0, "P5\n"},
    {"PNM", 0, "P6\n"},
    {"JPEG 2000", 0, "\0\0\0\x0cjP  "sv},
    {"JPEG 2000", 0, "\xff\x4f\xff\x51"},
    {"JPEG XL", 0, "\0\0\0\x0cJXL "sv},
    {"JPEG XL", 0, "\xff\x0a"},
    {"AVIF", 4, "ftypavif"},
    {"HEIF", 4, "ftyphei"},
    {"HEIF", 4, "ftypmif1"},
    {"Photoshop", 0, "8BPS"},
    {"DDS", 0, "DDS "},
    {"KTX", 1, "KTX "},
    {"SGI", 0, "\x01\xda"},
    {"FITS", 0, "SIMPLE  ="},
    {"Ptex", 0, "Ptex"},
    {"IFF", 0, "FOR4"},
    {"ICO", 0, "\0\0\1\0"sv},
};

bool hasMark(std::string_view bytes, size_t offset, std::string_view mark) {
    return bytes.size() >= offset + mark.size() && bytes.substr(offset, mark.size()) == mark;
}

bool isNamedTga(std::string_view path) {
    const size_t dot = path.rfind('.');
    std::string extension(dot == std::string_view::npos ? "" : path.substr(dot + 1));
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return extension == "tga" || extension == "tpic" || extension == "icb" || extension == "vda" || extension == "vst";
}

}  // namespace

ImageFormat imageFormatOf(std::string_view bytes, std::string_view path) {
    if (bytes.starts_with("\x76\x2f\x31\x01")) return ImageFormat::Exr;
    if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return ImageFormat::Png;
    if (bytes.starts_with("\xff\xd8\xff")) return ImageFormat::Jpeg;
    if (isTiff(bytes)) return ImageFormat::Tiff;
    if (bytes.starts_with("#?")) return ImageFormat::RadianceHdr;
    if (isPfm(bytes)) return ImageFormat::Pfm;
    if (hasTgaFooter(bytes)) return ImageFormat::Tga;
    // A file that is a TGA by its name alone, and that no other format claims, is a damaged TGA.
    if (isNamedTga(path) && (hasTgaHeader(bytes) || foreignFormatOf(bytes).empty())) return ImageFormat::Tga;
    return ImageFormat::Unknown;
}

std::string_view foreignFormatOf(std::string_view bytes) {
    for (const Mark& known : kForeign)
        if (hasMark(bytes, known.offset, known.mark)) return known.format;
    return {};
}

}  // namespace drc
