#include "image/exr_writer.h"

#include <OpenEXR/ImfAttribute.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOpaqueAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <deque>
#include <memory>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/parallel.h"

namespace drc {
namespace {

// The file is encoded in memory first, so that a failing disk is noticed in one place, with the system's own reason.
class MemoryOutput final : public Imf::OStream {
  public:
    MemoryOutput() : OStream("memory") {}
    void write(const char c[], int n) override {
        const size_t count = static_cast<size_t>(n);
        if (at_ + count > bytes_.size()) bytes_.resize(at_ + count);
        std::memcpy(bytes_.data() + at_, c, count);
        at_ += count;
    }
    uint64_t tellp() override { return at_; }
    void seekp(uint64_t at) override { at_ = static_cast<size_t>(at); }
    const std::string& bytes() const { return bytes_; }

  private:
    std::string bytes_;
    size_t at_ = 0;
};

// Lets OpenEXR read the bytes of one attribute.
class AttributeStream final : public Imf::IStream {
  public:
    explicit AttributeStream(const std::string& bytes) : IStream("attribute"), bytes_(bytes) {}
    bool read(char c[], int n) override {
        if (n < 0 || size_t(n) > bytes_.size() - at_) throw Error("an attribute is cut short");
        std::memcpy(c, bytes_.data() + at_, size_t(n));
        at_ += size_t(n);
        return at_ < bytes_.size();
    }
    uint64_t tellg() override { return at_; }
    void seekg(uint64_t at) override { at_ = std::min(size_t(at), bytes_.size()); }

  private:
    const std::string& bytes_;
    size_t at_ = 0;
};

void insertAttribute(Imf::Header& header, const std::string& name, const ExrAttribute& attribute) {
    constexpr int kVersion = 2;  // of the file format
    const char* type = attribute.type.c_str();
    const std::unique_ptr<Imf::Attribute> made(Imf::Attribute::knownType(type) ? Imf::Attribute::newAttribute(type)
                                                                               : new Imf::OpaqueAttribute(type));
    AttributeStream stream(attribute.value);
    made->readValueFrom(stream, int(attribute.value.size()), kVersion);
    header.insert(name, *made);
}

half toHalf(float x, bool keepsInfinity) {
    constexpr float kMax = 65504;
    return std::isnan(x) || (keepsInfinity && std::isinf(x)) ? half(x) : half(std::clamp(x, -kMax, kMax));
}

Imf::Header makeHeader(const Image& first, const ExrMetadata& metadata, const ExrWindow& window,
                       const ExrStorage& storage) {
    const Imath::V2i corner(window.displayX, window.displayY), start = corner + Imath::V2i(window.x, window.y);
    const Imath::Box2i data(start, start + Imath::V2i(first.width() - 1, first.height() - 1));
    Imath::Box2i display = data;
    if (window.fullWidth > 0 && window.fullHeight > 0)
        display = Imath::Box2i(corner, corner + Imath::V2i(window.fullWidth - 1, window.fullHeight - 1));
    Imf::Header header(display, data, 1, Imath::V2f(0, 0), 1, Imf::INCREASING_Y, Imf::Compression(storage.compression));
    for (const auto& [name, attribute] : storage.attributes) insertAttribute(header, name, attribute);
    for (const auto& [key, value] : metadata) header.insert(key, Imf::StringAttribute(value));
    return header;
}

// A channel as it is stored: its type, and its values one after another. Floats are not copied; they are written from
// the image.
struct StoredChannel {
    Imf::PixelType type = Imf::FLOAT;
    std::vector<half> halves;
    std::vector<uint32_t> integers;
};

// wasHalf: the channel was stored as halves in the file that was read, so its infinities are kept.
StoredChannel storedChannel(const Image& image, size_t channel, bool isHalf, bool wasHalf, bool isInteger) {
    StoredChannel stored;
    const size_t channels = size_t(image.channels());
    const auto value = [&](size_t pixel) { return image.data()[pixel * channels + channel]; };
    if (isInteger) {
        constexpr float kEnd = 4294967296.f;
        stored.type = Imf::UINT;
        stored.integers.resize(image.pixelCount());
        for (size_t i = 0; i < image.pixelCount(); ++i) {
            const float v = value(i);
            // Values that are no integers any more, for instance after filtering, are stored as floats.
            if (!(v >= 0 && v < kEnd && v == std::floor(v))) return {};
            stored.integers[i] = uint32_t(v);
        }
    } else if (isHalf || wasHalf) {
        stored.type = Imf::HALF;
        stored.halves.resize(image.pixelCount());
        for (size_t i = 0; i < image.pixelCount(); ++i) stored.halves[i] = toHalf(value(i), wasHalf);
    }
    return stored;
}

std::string encodeLayers(const std::vector<ExrLayer>& layers, const ExrMetadata& metadata, const ExrWindow& window,
                         const ExrStorage& storage) {
    const Image& first = *layers.front().image;
    Imf::Header header = makeHeader(first, metadata, window, storage);
    Imf::FrameBuffer frame;
    std::deque<StoredChannel> kept;  // must live until the file is written
    const auto width = static_cast<size_t>(first.width());
    for (const auto& layer : layers) {
        const Image& image = *layer.image;
        const size_t channels = static_cast<size_t>(image.channels());
        for (size_t c = 0; c < channels; ++c) {
            const std::string& channel = image.channelNames()[c];
            const std::string name = layer.name.empty() ? channel : fmt::format("{}.{}", layer.name, channel);
            if (header.channels().findChannel(name)) throw Error(fmt::format("two channels are called {}", name));
            const StoredChannel& stored = kept.emplace_back(storedChannel(
                image, c, layer.half, storage.halfChannels.contains(name), storage.integerChannels.contains(name)));
            header.channels().insert(name, Imf::Channel(stored.type));
            const auto insert = [&](const void* values, size_t pixel) {
                frame.insert(name, Imf::Slice::Make(stored.type, values, header.dataWindow(), pixel, pixel * width));
            };
            if (stored.type == Imf::HALF)
                insert(stored.halves.data(), sizeof(half));
            else if (stored.type == Imf::UINT)
                insert(stored.integers.data(), sizeof(uint32_t));
            else
                insert(image.data().data() + c, channels * sizeof(float));
        }
    }
    MemoryOutput stream;
    {
        if (Imf::globalThreadCount() != threadCount()) Imf::setGlobalThreadCount(threadCount());
        Imf::OutputFile file(stream, header, threadCount());
        file.setFrameBuffer(frame);
        file.writePixels(first.height());
    }
    return stream.bytes();
}

// path: for messages.
std::string encodeFor(const std::string& path, const std::vector<ExrLayer>& layers, const ExrMetadata& metadata,
                      const ExrWindow& window, const ExrStorage& storage) {
    if (layers.empty()) throw Error(fmt::format("cannot write {}: it has no layers", path));
    for (const auto& layer : layers) {
        if (!layer.image || layer.image->empty())
            throw Error(fmt::format("cannot write {}: the layer \"{}\" is empty", path, layer.name));
        if (layer.image->width() != layers[0].image->width() || layer.image->height() != layers[0].image->height())
            throw Error(fmt::format("cannot write {}: the layer \"{}\" is {}, the first is {}", path, layer.name,
                                    sizeString(*layer.image), sizeString(*layers[0].image)));
    }
    try {
        return encodeLayers(layers, metadata, window, storage);
    } catch (const std::exception& e) {
        throw Error(fmt::format("cannot write {}: {}", path, e.what()));
    }
}

}  // namespace

std::string encodeExr(const std::vector<ExrLayer>& layers, const ExrMetadata& metadata, const ExrWindow& window,
                      const ExrStorage& storage) {
    return encodeFor("an EXR", layers, metadata, window, storage);
}

void writeExr(const std::string& path, const std::vector<ExrLayer>& layers, const ExrMetadata& metadata,
              const ExrWindow& window, const ExrStorage& storage) {
    writeFileAtomically(path, encodeFor(path, layers, metadata, window, storage));
}

void writeExr(const std::string& path, const Image& image, const ExrMetadata& metadata) {
    writeExr(path, {{"", &image}}, metadata);
}

}  // namespace drc
