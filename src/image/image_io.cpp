#include "image/image_io.h"

// fmt first: OpenImageIO brings a copy of its own, whose functions would otherwise stand in this file's object, and
// every program that formats a string would link OpenImageIO for them.
// clang-format off
#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/printf.h>
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
// clang-format on

#include <filesystem>
#include <fstream>
#include <memory>
#include <new>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/limits.h"
#include "base/memory.h"
#include "image/color.h"
#include "image/pfm.h"

namespace drc {
namespace {

[[noreturn]] void failReading(const std::string& path, std::string reason) {
    while (!reason.empty() && (reason.back() == '\n' || reason.back() == '.')) reason.pop_back();
    throw Error(fmt::format("cannot read {}: {}", path, reason.empty() ? "the file is damaged" : reason));
}

// OpenImageIO's own words for a missing file depend on the format that it guesses from the name. Pipes and devices keep
// whoever opens them waiting, or have no end.
void requireFile(const std::string& path) {
    std::error_code ec;
    const auto status = std::filesystem::status(path, ec);
    if (!std::filesystem::exists(status)) failReading(path, "No such file or directory");
    if (std::filesystem::is_directory(status)) failReading(path, "Is a directory");
    if (!std::filesystem::is_regular_file(status)) failReading(path, "Not a file but a device");
    if (std::filesystem::file_size(path, ec) > limits::kPictureBytes) failReading(path, "File too large");
}

// For all that the picture will take until it is what is rendered with: the floats, then the colours, a copy of them
// and their coarser levels. It holds that back while the picture is read, no longer: pictures are read one after the
// other, before the meshes, and nothing else is made until the colours have been.
MemoryClaim claimFor(const std::string& path, double width, double height, double channels) {
    constexpr double kBytesPerChannel = sizeof(float), kBytesPerPixel = 3 * sizeof(Rgb);
    return MemoryClaim(width * height * (channels * kBytesPerChannel + kBytesPerPixel),
                       fmt::format("the picture {}, of {}x{} pixels,", path, width, height));
}

bool beginsAsPfm(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    char magic[4] = {};
    in.read(magic, sizeof(magic));
    return in.gcount() == sizeof(magic) && isPfm(std::string_view(magic, sizeof(magic)));
}

std::unique_ptr<OIIO::ImageInput> open(const std::string& path) {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);  // the stored colours, not those multiplied by alpha
    auto input = OIIO::ImageInput::open(path, &config);
    if (!input) failReading(path, OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    const std::string size =
        fmt::format("its size is {}x{}x{} with {} channels", spec.width, spec.height, spec.depth, spec.nchannels);
    if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0 || spec.depth > 1) failReading(path, size);
    if (spec.width > limits::kImageSide || spec.height > limits::kImageSide ||
        int64_t(spec.width) * spec.height > limits::kImagePixels || spec.nchannels > limits::kImageChannels)
        failReading(path, fmt::format("{}; at most {} a side, {} in all and {} channels are read", size,
                                      limits::kImageSide, limits::kImagePixels, limits::kImageChannels));
    return input;
}

Encoding encodingOf(const OIIO::ImageSpec& spec) {
    if (spec.format.is_floating_point()) return Encoding::Float;
    return spec.format.size() == 1 ? Encoding::UInt8 : Encoding::UInt16;
}

std::string encodePngBytes(const std::vector<uint8_t>& bytes, int width, int height, const std::string& path) {
    OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("png:compressionLevel", 6);
    std::vector<unsigned char> encoded;
    OIIO::Filesystem::IOVecOutput memory(encoded);
    auto output = OIIO::ImageOutput::create("png");
    if (!output || !output->set_ioproxy(&memory) || !output->open("image.png", spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, bytes.data()) || !output->close())
        throw Error(fmt::format("cannot write {}: {}", path, output ? output->geterror() : OIIO::geterror()));
    return std::string(encoded.begin(), encoded.end());
}

std::string encodePngFor(const Image& linear, const std::string& path) {
    if (linear.empty()) throw Error(fmt::format("cannot write {}: the image is empty", path));
    std::vector<uint8_t> bytes;
    bytes.reserve(linear.pixelCount() * 3);
    for (int y = 0; y < linear.height(); ++y) {
        for (int x = 0; x < linear.width(); ++x) {
            const Rgb c = linear.rgb(x, y);
            for (int i = 0; i < 3; ++i) bytes.push_back(toByte(srgbEncode(c[i])));
        }
    }
    return encodePngBytes(bytes, linear.width(), linear.height(), path);
}

}  // namespace

namespace {

ImageFile readAnyFormat(const std::string& path) {
    if (beginsAsPfm(path)) {
        std::error_code ignored;
        const double pixels = double(std::filesystem::file_size(path, ignored)) / (3 * sizeof(float));
        const MemoryClaim memory = claimFor(path, pixels, 1, 3);
        return {decodePfm(readFile(path), path), Encoding::Float};
    }
    const auto input = open(path);
    const OIIO::ImageSpec spec = input->spec();
    const MemoryClaim memory = claimFor(path, spec.width, spec.height, spec.nchannels);
    ImageFile file{Image(spec.width, spec.height, spec.channelnames), encodingOf(spec)};
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, file.image.data().data()))
        failReading(path, input->geterror());
    return file;
}

}  // namespace

ImageFile readImageFile(const std::string& path) {
    requireFile(path);
    try {
        return readAnyFormat(path);
    } catch (const std::bad_alloc&) {
        failReading(path, "there is not enough memory for it");
    } catch (const Error& error) {
        if (std::string_view(error.what()).find(path) != std::string_view::npos) throw;
        failReading(path, error.what());
    } catch (const std::exception& error) {  // of a format's own library
        failReading(path, error.what());
    }
}

Image readImage(const std::string& path, Encoding* encoding) {
    ImageFile file = readImageFile(path);
    if (encoding) *encoding = file.encoding;
    return std::move(file.image);
}

Image readLinearRgb(const std::string& path) {
    const ImageFile file = readImageFile(path);
    // A render's file may list its layers in any order; the beauty is what has no layer name.
    const int r = file.image.channelIndex("R"), g = file.image.channelIndex("G"), b = file.image.channelIndex("B");
    Image rgb = file.image.toRgb();
    if (r >= 0 && g >= 0 && b >= 0) {
        for (int y = 0; y < rgb.height(); ++y)
            for (int x = 0; x < rgb.width(); ++x)
                rgb.setRgb(x, y, Rgb(file.image.at(x, y, r), file.image.at(x, y, g), file.image.at(x, y, b)));
    }
    if (file.isSrgbEncoded())
        for (float& v : rgb.data()) v = srgbDecode(v);
    return rgb;
}

std::string encodePng(const Image& linear) { return encodePngFor(linear, "a PNG"); }

void writePng(const std::string& path, const Image& linear) { writeFileAtomically(path, encodePngFor(linear, path)); }

}  // namespace drc
