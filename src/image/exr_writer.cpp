#include "image/exr_writer.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/parallel.h"

namespace drc {
namespace {

// The file is made in memory first: then a failing disk shows in one place, with the system's own reason.
class MemoryStream final : public Imf::OStream {
  public:
    MemoryStream() : OStream("memory") {}
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

half toHalf(float x) {
    constexpr float kMax = 65504;
    return std::isnan(x) ? half(x) : half(std::clamp(x, -kMax, kMax));
}

Imf::Header makeHeader(const Image& first, const ExrMetadata& metadata, const ExrWindow& window) {
    const Imath::Box2i data(Imath::V2i(window.x, window.y),
                            Imath::V2i(window.x + first.width() - 1, window.y + first.height() - 1));
    Imath::Box2i display = data;
    if (window.fullWidth > 0 && window.fullHeight > 0)
        display = Imath::Box2i(Imath::V2i(0, 0), Imath::V2i(window.fullWidth - 1, window.fullHeight - 1));
    Imf::Header header(display, data, 1, Imath::V2f(0, 0), 1, Imf::INCREASING_Y, Imf::ZIP_COMPRESSION);
    for (const auto& [key, value] : metadata) header.insert(key, Imf::StringAttribute(value));
    return header;
}

std::string encodeLayers(const std::vector<ExrLayer>& layers, const ExrMetadata& metadata, const ExrWindow& window) {
    const Image& first = *layers.front().image;
    Imf::Header header = makeHeader(first, metadata, window);
    Imf::FrameBuffer frame;
    std::vector<std::vector<half>> halves;  // kept until the file is written
    halves.reserve(layers.size());
    const auto rows = static_cast<size_t>(first.width());
    for (const auto& layer : layers) {
        const Image& image = *layer.image;
        const size_t channels = static_cast<size_t>(image.channels());
        if (layer.half) {
            halves.emplace_back(image.data().size());
            std::transform(image.data().begin(), image.data().end(), halves.back().begin(), toHalf);
        }
        for (size_t c = 0; c < channels; ++c) {
            const std::string& channel = image.channelNames()[c];
            const std::string name = layer.name.empty() ? channel : fmt::format("{}.{}", layer.name, channel);
            if (header.channels().findChannel(name)) throw Error(fmt::format("two channels are called {}", name));
            const Imf::PixelType type = layer.half ? Imf::HALF : Imf::FLOAT;
            const size_t size = layer.half ? sizeof(half) : sizeof(float);
            const void* data = layer.half ? static_cast<const void*>(halves.back().data() + c)
                                          : static_cast<const void*>(image.data().data() + c);
            header.channels().insert(name, Imf::Channel(type));
            frame.insert(name,
                         Imf::Slice::Make(type, data, header.dataWindow(), size * channels, size * channels * rows));
        }
    }
    MemoryStream stream;
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
                      const ExrWindow& window) {
    if (layers.empty()) throw Error(fmt::format("cannot write {}: it has no layers", path));
    for (const auto& layer : layers) {
        if (!layer.image || layer.image->empty())
            throw Error(fmt::format("cannot write {}: the layer \"{}\" is empty", path, layer.name));
        if (layer.image->width() != layers[0].image->width() || layer.image->height() != layers[0].image->height())
            throw Error(fmt::format("cannot write {}: the layer \"{}\" is {}, the first is {}", path, layer.name,
                                    sizeString(*layer.image), sizeString(*layers[0].image)));
    }
    try {
        return encodeLayers(layers, metadata, window);
    } catch (const std::exception& e) {
        throw Error(fmt::format("cannot write {}: {}", path, e.what()));
    }
}

}  // namespace

std::string encodeExr(const std::vector<ExrLayer>& layers, const ExrMetadata& metadata, const ExrWindow& window) {
    return encodeFor("an EXR", layers, metadata, window);
}

void writeExr(const std::string& path, const std::vector<ExrLayer>& layers, const ExrMetadata& metadata,
              const ExrWindow& window) {
    writeFileAtomically(path, encodeFor(path, layers, metadata, window));
}

void writeExr(const std::string& path, const Image& image, const ExrMetadata& metadata) {
    writeExr(path, {{"", &image}}, metadata);
}

}  // namespace drc
