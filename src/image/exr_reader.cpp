#include "image/exr_reader.h"

#include <Imath/ImathBox.h>
#include <OpenEXR/IexBaseExc.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfThreading.h>
#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <vector>

#include "base/error.h"
#include "base/log.h"
#include "base/parallel.h"
#include "image/exr_channels.h"
#include "image/exr_header.h"
#include "image/exr_primaries.h"
#include "image/image_layers.h"

namespace drc {
namespace {

class MemoryInput final : public Imf::IStream {
  public:
    explicit MemoryInput(const EncodedImage& encoded) : IStream(encoded.path.c_str()), bytes_(encoded.bytes) {}
    bool isMemoryMapped() const override { return true; }
    char* readMemoryMapped(int n) override {
        if (n < 0 || uint64_t(n) > bytes_.size() - at_) throw Iex::InputExc("Unexpected end of file.");
        char* const first = const_cast<char*>(bytes_.data()) + at_;  // OpenEXR only reads it
        at_ += size_t(n);
        return first;
    }
    bool read(char to[], int n) override {
        std::memcpy(to, readMemoryMapped(n), size_t(n));
        return at_ < bytes_.size();
    }
    uint64_t tellg() override { return at_; }
    void seekg(uint64_t at) override { at_ = size_t(std::min<uint64_t>(at, bytes_.size())); }

  private:
    std::string_view bytes_;
    size_t at_ = 0;
};

// A part that is read: one that is not deep.
struct FlatPart {
    int index = 0;
    const Imf::Header* header = nullptr;
    const ExrAttributes* attributes = nullptr;
};

std::string nameOf(const Imf::Header& header) { return header.hasName() ? header.name() : ""; }

// The subject of an error message: "its part depth", or "it" for a file with a single part.
std::string subject(const Imf::MultiPartInputFile& file, int part) {
    return file.parts() == 1 ? "it" : fmt::format("its part {}", nameOf(file.header(part)));
}

void requireFullChannels(const EncodedImage& encoded, const Imf::Header& header) {
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it)
        if (const Imf::Channel& channel = it.channel(); channel.xSampling != 1 || channel.ySampling != 1)
            failDecoding(encoded, fmt::format("its channel {} has one value for {}x{} pixels; one for each is read",
                                              it.name(), channel.xSampling, channel.ySampling));
}

std::vector<FlatPart> flatParts(const EncodedImage& encoded, const Imf::MultiPartInputFile& file,
                                const std::vector<ExrAttributes>& attributes) {
    std::vector<FlatPart> flat;
    std::string deep;
    for (int i = 0; i < file.parts(); ++i) {
        const Imf::Header& header = file.header(i);
        if (header.hasType() && !Imf::isImage(header.type())) {
            const std::string fault = fmt::format("{} is a deep picture ({})", subject(file, i), header.type());
            deep += (deep.empty() ? "" : ", ") + fault;
        } else {
            requireFullChannels(encoded, header);
            flat.push_back({i, &header, &attributes.at(size_t(i))});
        }
    }
    if (flat.empty()) failDecoding(encoded, deep);
    if (!deep.empty()) logWarning(fmt::format("{}: {}, which is left out", encoded.path, deep));
    return flat;
}

ExrChannels channelsOf(const std::vector<FlatPart>& parts) {
    std::vector<ExrPartChannels> names;
    for (const FlatPart& part : parts) {
        ExrPartChannels& of = names.emplace_back(ExrPartChannels{nameOf(*part.header), {}});
        const Imf::ChannelList& channels = part.header->channels();
        for (auto it = channels.begin(); it != channels.end(); ++it) of.channels.push_back(it.name());
    }
    return exrChannels(names);
}

struct Window {
    int64_t x0, y0, x1, y1;  // the first pixel, and the last

    int64_t width() const { return x1 - x0 + 1; }
    int64_t height() const { return y1 - y0 + 1; }
};

Window windowOf(const std::vector<FlatPart>& parts) {
    Window all{INT64_MAX, INT64_MAX, INT64_MIN, INT64_MIN};
    for (const FlatPart& part : parts) {
        const Imath::Box2i& data = part.header->dataWindow();
        all = {std::min<int64_t>(all.x0, data.min.x), std::min<int64_t>(all.y0, data.min.y),
               std::max<int64_t>(all.x1, data.max.x), std::max<int64_t>(all.y1, data.max.y)};
    }
    return all;
}

// Parts of one file share their display window.
ExrWindow placeOf(const Window& data, const Imath::Box2i& display) {
    // Avoids overflow for windows near the limits of int, which no renderer writes.
    const auto bounded = [](int64_t value, int limit) { return int(std::clamp<int64_t>(value, -limit, limit)); };
    constexpr int kMost = limits::kFilmSide;
    return {bounded(data.x0 - display.min.x, kMost),
            bounded(data.y0 - display.min.y, kMost),
            bounded(int64_t(display.max.x) - display.min.x + 1, kMost),
            bounded(int64_t(display.max.y) - display.min.y + 1, kMost),
            bounded(display.min.x, kMost),
            bounded(display.min.y, kMost)};
}

// Memory that OpenEXR holds beside the picture: one row of tiles, plus two tiles per thread while unpacking.
double tileBytes(const EncodedImage& encoded, const Imf::Header& header) {
    if (!header.hasTileDescription()) return 0;
    int channels = 0;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it) ++channels;
    const double width = double(header.dataWindow().max.x) - header.dataWindow().min.x + 1;
    const int64_t x = header.tileDescription().xSize, y = header.tileDescription().ySize;
    if (x * y > encoded.mostPixels)
        failDecoding(encoded, fmt::format("its tiles are {}x{}; at most {} pixels are read", x, y, encoded.mostPixels));
    return double(channels) * sizeof(float) * double(y) * (width + 2.0 * double(x) * threadCount());
}

// Reads a part's channels into the corresponding channels of the image, which covers the window `all`.
class PartReader {
  public:
    PartReader(const EncodedImage& encoded, Image& image, const Window& all)
        : encoded_(encoded), image_(image), all_(all) {}

    void read(Imf::MultiPartInputFile& file, const FlatPart& part, const std::vector<ExrChannel>& channels,
              size_t number) {
        const Imath::Box2i& data = part.header->dataWindow();
        const size_t pixel = size_t(image_.channels()) * sizeof(float), row = pixel * size_t(image_.width());
        const size_t width = size_t(data.max.x - data.min.x + 1), count = width * size_t(data.max.y - data.min.y + 1);
        float* const first = image_.pixel(int(data.min.x - all_.x0), int(data.min.y - all_.y0));
        Imf::FrameBuffer frame;
        std::map<size_t, std::vector<uint32_t>> integers;  // by channel index in the image
        for (size_t c = 0; c < channels.size(); ++c) {
            if (channels[c].part != number) continue;
            const std::string& name = channels[c].nameInPart;
            if (part.header->channels()[name].type == Imf::UINT) {
                std::vector<uint32_t>& values = integers[c];
                values.resize(count);
                frame.insert(name, Imf::Slice::Make(Imf::UINT, values.data(), data, 4, 4 * width));
            } else {
                frame.insert(name, Imf::Slice::Make(Imf::FLOAT, first + c, data, pixel, row));
            }
        }
        Imf::InputPart input(file, part.index);
        input.setFrameBuffer(frame);
        input.readPixels(data.min.y, data.max.y);
        for (const auto& [c, values] : integers) setIntegers(values, width, first + c, channels[c].name);
    }

  private:
    void setIntegers(const std::vector<uint32_t>& values, size_t width, float* first, const std::string& name) const {
        const auto channels = size_t(image_.channels());
        bool isExact = true;
        for (size_t i = 0; i < values.size(); ++i) {
            const auto value = float(values[i]);
            isExact &= double(value) == double(values[i]);
            first[(i / width * size_t(image_.width()) + i % width) * channels] = value;
        }
        if (!isExact)
            logWarning(fmt::format("{}: the integers of its channel {} beyond 16777216 are rounded to floats",
                                   encoded_.path, name));
    }

    const EncodedImage& encoded_;
    Image& image_;
    Window all_;
};

// Converts the colours of the part to linear Rec. 709.
void convertPrimaries(const EncodedImage& encoded, const FlatPart& part, const std::vector<ExrChannel>& channels,
                      size_t number, Image& image) {
    const auto found = part.attributes->find("chromaticities");
    if (found == part.attributes->end() || found->second.type != "chromaticities") return;
    std::set<std::string> layers;
    for (const ExrChannel& channel : channels)
        if (const std::string layer = layerOfChannel(channel.name); channel.part == number && !isDataLayer(layer))
            layers.insert(layer);
    try {
        if (const std::optional<RgbMatrix> map = rec709From(found->second))
            for (const std::string& layer : layers) mapColours(image, layer, *map);
    } catch (const Error& error) {
        logWarning(fmt::format("{}: {}; Rec. 709's are assumed", encoded.path, error.what()));
    }
}

// Attributes to write again. Strings are metadata, and attributes of the layout follow from what is written.
ExrAttributes keptAttributes(const ExrAttributes& attributes) {
    static const std::set<std::string_view> kLeft{
        "adoptedNeutral", "channels",       "chromaticities", "chunkCount", "compression",
        "dataWindow",     "deepImageState", "displayWindow",  "lineOrder",  "maxSamplesPerPixel",
        "preview",        "tiles",          "version"};
    ExrAttributes kept;
    for (const auto& [name, attribute] : attributes)
        if (attribute.type != "string" && !kLeft.contains(name)) kept[name] = attribute;
    return kept;
}

ExrStorage storageOf(const std::vector<FlatPart>& parts, const ExrChannels& channels) {
    ExrStorage storage;
    for (const ExrChannel& channel : channels.channels) {
        const Imf::PixelType type = parts[channel.part].header->channels()[channel.nameInPart].type;
        if (type == Imf::HALF) storage.halfChannels.insert(channel.name);
        if (type == Imf::UINT) storage.integerChannels.insert(channel.name);
    }
    const FlatPart& first = parts[channels.beautyPart < parts.size() ? channels.beautyPart : 0];
    storage.compression = first.header->compression();
    storage.attributes = keptAttributes(*first.attributes);
    return storage;
}

// Makes OpenEXR use as many threads as the renderer.
void setThreads() {
    if (Imf::globalThreadCount() != threadCount()) Imf::setGlobalThreadCount(threadCount());
}

}  // namespace

ImageFile decodeExr(const EncodedImage& encoded) {
    const std::vector<ExrAttributes> attributes = requireSoundExrHeaders(encoded);
    setThreads();
    MemoryInput stream(encoded);
    Imf::MultiPartInputFile input(stream);
    const std::vector<FlatPart> parts = flatParts(encoded, input, attributes);
    const ExrChannels channels = channelsOf(parts);
    const Window window = windowOf(parts);
    std::vector<std::string> names;
    for (const ExrChannel& channel : channels.channels) names.push_back(channel.name);
    ImageFile file;
    file.storage = storageOf(parts, channels);
    // Parts are read one after another, so the largest one determines the memory.
    double extraBytes = 0;
    for (const FlatPart& part : parts) extraBytes = std::max(extraBytes, tileBytes(encoded, *part.header));
    extraBytes += double(file.storage.integerChannels.size()) * sizeof(uint32_t) * double(window.width()) *
                  double(window.height());
    const MemoryClaim memory = claimMemory(encoded, window.width(), window.height(), int64_t(names.size()), extraBytes);

    file.image = Image(int(window.width()), int(window.height()), names);
    file.window = placeOf(window, parts[0].header->displayWindow());
    if (parts.size() > 1 && channels.beautyPart < parts.size())
        file.beautyPart = nameOf(*parts[channels.beautyPart].header);
    PartReader reader(encoded, file.image, window);
    for (size_t i = 0; i < parts.size(); ++i) {
        reader.read(input, parts[i], channels.channels, i);
        convertPrimaries(encoded, parts[i], channels.channels, i, file.image);
    }
    return file;
}

ExrMetadata decodeExrMetadata(const EncodedImage& encoded) {
    const std::vector<ExrAttributes> attributes = requireSoundExrHeaders(encoded);
    MemoryInput stream(encoded);
    const Imf::MultiPartInputFile input(stream);
    std::vector<FlatPart> parts;
    for (int i = 0; i < input.parts(); ++i) parts.push_back({i, &input.header(i), &attributes.at(size_t(i))});
    const size_t beauty = channelsOf(parts).beautyPart, first = beauty < parts.size() ? beauty : 0;
    ExrMetadata metadata;
    const auto add = [&](const FlatPart& part, const std::string& prefix) {
        for (const auto& [name, attribute] : *part.attributes) {
            // A part's type, and its name in a file of several parts, describe the file rather than the picture.
            if (attribute.type != "string" || name == "type" || (parts.size() > 1 && name == "name")) continue;
            const auto known = metadata.find(name);
            if (prefix.empty() || known == metadata.end())
                metadata[name] = attribute.value;
            else if (known->second != attribute.value)
                metadata[prefix + name] = attribute.value;
        }
    };
    add(parts[first], "");
    for (size_t i = 0; i < parts.size(); ++i)
        if (i != first) add(parts[i], nameOf(*parts[i].header) + ".");
    return metadata;
}

}  // namespace drc
