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
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <tuple>
#include <vector>

#include "base/parallel.h"
#include "image/exr_header.h"

namespace drc {
namespace {

class MemoryStream final : public Imf::IStream {
  public:
    explicit MemoryStream(const EncodedImage& encoded) : IStream(encoded.path.c_str()), bytes_(encoded.bytes) {}
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

// Where a channel stands among those of its layer, "" or "name.".
struct ChannelPlace {
    std::string name, layer;
    int rank = 0;

    auto key() const { return std::tie(layer, rank, name); }
};

std::string lowerCase(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) c = char(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    return lower;
}

// In the order that a picture's channels are thought of, where the file has them sorted by name. Y is a brightness, but
// where there is an X with it or with a Z, a coordinate.
int rankOf(std::string_view suffix, bool isPosition) {
    static constexpr std::string_view kColours[] = {"r",    "red",  "g",  "green", "b",     "blue", "y",
                                                    "real", "imag", "a",  "alpha", "ar",    "ra",   "ag",
                                                    "ga",   "ab",   "ba", "z",     "depth", "zback"};
    static constexpr std::string_view kPositions[] = {"r",  "red", "g",    "green", "b",  "blue",  "x",
                                                      "y",  "z",   "real", "imag",  "a",  "alpha", "ar",
                                                      "ra", "ag",  "ga",   "ab",    "ba", "depth", "zback"};
    const std::span<const std::string_view> order =
        isPosition ? std::span<const std::string_view>(kPositions) : std::span<const std::string_view>(kColours);
    return int(std::find(order.begin(), order.end(), lowerCase(suffix)) - order.begin());
}

std::vector<std::string> orderedChannels(const Imf::ChannelList& channels) {
    std::vector<ChannelPlace> places;
    std::map<std::string, std::string> coordinates;  // of each layer, those of "xyz" that it has
    for (auto it = channels.begin(); it != channels.end(); ++it) {
        const std::string name = it.name();
        const size_t suffix = name.rfind('.') + 1;  // 0 if there is no dot
        places.push_back({name, name.substr(0, suffix)});
        if (const std::string axis = lowerCase(name.substr(suffix)); axis == "x" || axis == "y" || axis == "z")
            coordinates[places.back().layer] += axis;
    }
    for (ChannelPlace& place : places) {
        const std::string& axes = coordinates[place.layer];
        const bool isPosition = axes.starts_with('x') && axes.find_first_of("yz") != std::string::npos;
        place.rank = rankOf(std::string_view(place.name).substr(place.layer.size()), isPosition);
    }
    std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.key() < b.key(); });
    std::vector<std::string> names;
    for (ChannelPlace& place : places) names.push_back(std::move(place.name));
    return names;
}

void requireFlat(const EncodedImage& encoded, const Imf::Header& header) {
    if (header.hasType() && !Imf::isImage(header.type()))
        failDecoding(encoded, fmt::format("it is a deep picture ({})", header.type()));
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it)
        if (const Imf::Channel& channel = it.channel(); channel.xSampling != 1 || channel.ySampling != 1)
            failDecoding(encoded, fmt::format("its channel {} has one value for {}x{} pixels; one for each is read",
                                              it.name(), channel.xSampling, channel.ySampling));
}

// What OpenEXR keeps beside the picture: a row of tiles, and tiles being unpacked.
double tileBytes(const EncodedImage& encoded, const Imf::Header& header, int64_t width, int64_t channels) {
    if (!header.hasTileDescription()) return 0;
    const int64_t x = header.tileDescription().xSize, y = header.tileDescription().ySize;
    if (x * y > encoded.mostPixels)
        failDecoding(encoded, fmt::format("its tiles are {}x{}; at most {} pixels are read", x, y, encoded.mostPixels));
    return double(channels) * sizeof(float) * double(y) * (double(width) + 2.0 * double(x) * threadCount());
}

// With as many threads as all else.
void setThreads() {
    if (Imf::globalThreadCount() != threadCount()) Imf::setGlobalThreadCount(threadCount());
}

}  // namespace

ImageFile decodeExr(const EncodedImage& encoded) {
    requireSoundExrHeaders(encoded);
    setThreads();
    MemoryStream stream(encoded);
    Imf::MultiPartInputFile parts(stream);
    const Imf::Header& header = parts.header(0);
    requireFlat(encoded, header);
    const std::vector<std::string> names = orderedChannels(header.channels());
    const Imath::Box2i window = header.dataWindow();
    const int64_t width = int64_t(window.max.x) - window.min.x + 1, height = int64_t(window.max.y) - window.min.y + 1;
    const auto channels = int64_t(names.size());
    const MemoryClaim memory =
        claimMemory(encoded, width, height, channels, tileBytes(encoded, header, width, channels));

    ImageFile file{Image(int(width), int(height), names), Encoding::Float};
    const size_t pixel = names.size() * sizeof(float);
    Imf::FrameBuffer frame;
    for (size_t c = 0; c < names.size(); ++c)
        frame.insert(names[c],
                     Imf::Slice::Make(Imf::FLOAT, file.image.data().data() + c, window, pixel, pixel * size_t(width)));
    Imf::InputPart part(parts, 0);
    part.setFrameBuffer(frame);
    part.readPixels(window.min.y, window.max.y);
    return file;
}

ExrWindow decodeExrWindow(const EncodedImage& encoded) {
    requireSoundExrHeaders(encoded);
    MemoryStream stream(encoded);
    const Imf::MultiPartInputFile parts(stream);
    const Imath::Box2i data = parts.header(0).dataWindow(), display = parts.header(0).displayWindow();
    // As of windows that are close to the ends of what an int holds, which no renderer writes.
    const auto offset = [&](int a, int b, int limit) {
        return int(std::clamp<int64_t>(int64_t(a) - b, -limit, limit));
    };
    constexpr int kMost = limits::kFilmSide;
    return {offset(data.min.x, display.min.x, kMost), offset(data.min.y, display.min.y, kMost),
            offset(display.max.x, display.min.x, kMost - 1) + 1, offset(display.max.y, display.min.y, kMost - 1) + 1};
}

ExrMetadata decodeExrMetadata(const EncodedImage& encoded) {
    requireSoundExrHeaders(encoded);
    MemoryStream stream(encoded);
    const Imf::MultiPartInputFile parts(stream);
    const Imf::Header& header = parts.header(0);
    ExrMetadata metadata;
    for (auto it = header.begin(); it != header.end(); ++it)
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute()))
            metadata[it.name()] = text->value();
    metadata.erase("type");  // scan lines or tiles: OpenEXR adds it on reading
    return metadata;
}

}  // namespace drc
