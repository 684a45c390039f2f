#include "image/image_io.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <new>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/log.h"
#include "base/mapped_file.h"
#include "image/color.h"
#include "image/exr_reader.h"
#include "image/image_format.h"
#include "image/image_layers.h"
#include "image/jpeg.h"
#include "image/pfm.h"
#include "image/picture_window.h"
#include "image/radiance_hdr.h"
#include "image/tga.h"
#include "image/tiff.h"

namespace drc {
namespace {

[[noreturn]] void failReading(const std::string& path, std::string_view reason) {
    throw Error(fmt::format("cannot read {}: {}", path, reason));
}

// Accepts only regular files: opening a pipe or a device may block, and its data may have no end.
void requireFile(const std::string& path) {
    std::error_code ec;
    const auto status = std::filesystem::status(path, ec);
    if (!std::filesystem::exists(status)) failReading(path, "No such file or directory");
    if (std::filesystem::is_directory(status)) failReading(path, "Is a directory");
    if (!std::filesystem::is_regular_file(status)) failReading(path, "Not a file but a device");
    if (std::filesystem::file_size(path, ec) > limits::kPictureBytes) failReading(path, "File too large");
    if (::access(path.c_str(), R_OK) != 0) failReading(path, std::strerror(errno));
}

// The first line of OpenEXR's message, without the path before the reason.
std::string reasonOf(const std::exception& error, const std::string& path) {
    std::string_view text = error.what();
    const std::string named = fmt::format("\"{}\". ", path);
    if (const size_t at = text.find(named); at != std::string_view::npos) text.remove_prefix(at + named.size());
    text = text.substr(0, text.find('\n'));
    while (text.ends_with('.')) text.remove_suffix(1);
    return text.empty() ? "the file is damaged" : std::string(text);
}

// Calls decode() and converts any exception to an Error that names the path.
template <typename F>
auto decoded(const std::string& path, const F& decode) {
    try {
        return decode();
    } catch (const Error& error) {
        if (std::string_view(error.what()).find(path) != std::string_view::npos) throw;
        failReading(path, error.what());
    } catch (const std::bad_alloc&) {
        failReading(path, "there is not enough memory for it");
    } catch (const std::exception& error) {
        failReading(path, reasonOf(error, path));
    }
}

ImageFile decodePfmFile(const EncodedImage& encoded) {
    const double pixels = double(encoded.bytes.size()) / (3 * sizeof(float));
    const MemoryClaim memory(pixels * (3 * sizeof(float) + 3 * sizeof(Rgb)),
                             fmt::format("the picture {}", encoded.path));
    return {decodePfm(encoded.bytes, encoded.path), Encoding::Float};
}

ImageFile decodeByFormat(const EncodedImage& encoded) {
    if (encoded.bytes.empty()) failDecoding(encoded, "the file is empty");
    switch (imageFormatOf(encoded.bytes, encoded.path)) {
        case ImageFormat::Exr:
            return decodeExr(encoded);
        case ImageFormat::Png:
            return decodePng(encoded);
        case ImageFormat::Jpeg:
            return decodeJpeg(encoded);
        case ImageFormat::Tiff:
            return decodeTiff(encoded);
        case ImageFormat::RadianceHdr:
            return decodeRadianceHdr(encoded);
        case ImageFormat::Tga:
            return decodeTga(encoded);
        case ImageFormat::Pfm:
            return decodePfmFile(encoded);
        case ImageFormat::Unknown:
            break;
    }
    const std::string_view foreign = foreignFormatOf(encoded.bytes);
    failDecoding(encoded, foreign.empty() ? fmt::format("its format is unknown; {}", kFormatsRead)
                                          : fmt::format("it is a {} file; {}", foreign, kFormatsRead));
}

}  // namespace

ImageFile decodeImage(const EncodedImage& encoded) {
    return decoded(encoded.path, [&] { return decodeByFormat(encoded); });
}

ImageFile readImageFile(const std::string& path) {
    requireFile(path);
    const MappedFile file(path);
    return decodeImage({file.bytes(), path});
}

Image readImage(const std::string& path, Encoding* encoding) {
    ImageFile file = readImageFile(path);
    if (encoding) *encoding = file.encoding;
    return std::move(file.image);
}

Image readLinearRgb(const std::string& path) { return linearRgbOf(readImageFile(path)); }

Image linearRgbOf(const ImageFile& file) {
    // A render's file may list its layers in any order; the beauty is the layer without a name.
    Image rgb = beautyOf(file.image).toRgb();
    if (file.isSrgbEncoded())
        for (float& v : rgb.data()) v = decodedValue(file, v);
    return rgb;
}

float decodedValue(const ImageFile& file, float value) {
    return file.gamma > 0 ? std::pow(value, 1 / file.gamma) : srgbDecode(value);
}

ImageFile readTextureFile(const std::string& path) {
    ImageFile file = readImageFile(path);
    file.image = beautyOf(file.image);
    if (file.gamma > 0)
        logWarning(fmt::format("{}: its gamma chunk ({:g}) is not used: its integers are taken as pbrt takes them",
                               path, file.gamma));
    file.gamma = 0;
    if (isWhole(file.image, file.window)) return file;
    if (!overlaps(file.image, file.window)) {
        logWarning(fmt::format("{} has {}, nothing of which is visible; its pixels are taken as the whole", path,
                               placeString(file.image, file.window)));
        return file;
    }
    file.image = placedInWindow(file.image, file.window, path);
    file.window = {};
    return file;
}

ExrMetadata readExrMetadata(const std::string& path) {
    requireFile(path);
    const MappedFile file(path);
    const EncodedImage encoded{file.bytes(), path};
    if (imageFormatOf(encoded.bytes, path) != ImageFormat::Exr) failDecoding(encoded, "it is no EXR file");
    return decoded(path, [&] { return decodeExrMetadata(encoded); });
}

ExrMetadata readMetadata(const std::string& path) {
    requireFile(path);
    const MappedFile file(path);
    const EncodedImage encoded{file.bytes(), path};
    switch (imageFormatOf(encoded.bytes, path)) {
        case ImageFormat::Exr:
            return decoded(path, [&] { return decodeExrMetadata(encoded); });
        case ImageFormat::Png:
            return decodePngTexts(encoded);
        default:
            return {};
    }
}

void writePng(const std::string& path, const Image& linear) { writeFileAtomically(path, encodePng(linear, path)); }

}  // namespace drc
