#include "neural/unet_shape.h"

#include <fmt/core.h>

#include <charconv>

#include "base/error.h"

namespace drc {
namespace {

struct KindName {
    UNetKind kind;
    const char *name, *architecture;
};
constexpr KindName kNames[] = {{UNetKind::Plain, "plain", "drc-unet-1"},
                               {UNetKind::Residual, "residual", "drc-unet-residual-1"},
                               {UNetKind::Separable, "separable", "drc-unet-separable-1"},
                               {UNetKind::Paper, "paper", "paper-unet-1"}};

const KindName& namesOf(UNetKind kind) {
    for (const KindName& n : kNames)
        if (n.kind == kind) return n;
    throw Error("unknown kind of network");
}

std::string listed(const char* KindName::*name) {
    std::string list;
    for (const KindName& n : kNames) list += fmt::format("{}'{}'", list.empty() ? "" : ", ", n.*name);
    return list;
}

int readInt(const SafetensorsFile& file, const std::string& key, int low, int high, int fallback) {
    const std::string text = file.metadata(key, fallback ? std::to_string(fallback) : "");
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < low || value > high)
        throw Error(SourceLocation{file.path()},
                    fmt::format("metadata '{}' is '{}', not a whole number from {} to {}", key, text, low, high));
    return value;
}

// Generates the layers in order. Every function returns the number of the value that its last layer computes.
class Writer {
  public:
    explicit Writer(const UNetShape& shape) : shape_(shape), channels_{shape.inputs}, sizes_{shape.size} {}

    int maxPool(int source) { return add({LayerOp::MaxPool, source, size(source) / 2}, channels(source)); }
    int upsample(int source) { return add({LayerOp::Upsample, source, 2 * size(source)}, channels(source)); }
    int conv(const std::string& name, int skip, int source, int out, int kernel, float slope, int addTo = -1) {
        Layer layer{LayerOp::Conv, source, size(source)};
        layer.conv = {name, channels(source) + (skip < 0 ? 0 : channels(skip)), out, kernel};
        layer.skip = skip, layer.add = addTo, layer.slope = slope;
        return add(layer, out);
    }
    // A block of the shape's kind, applied to the concatenation of `skip` (if any) and `source`. `last`: output
    // channels of the second convolution in a Paper block.
    int block(const std::string& name, int skip, int source, int out, int last, bool affine) {
        const auto part = [&](const char* suffix) { return name + suffix; };
        switch (shape_.kind) {
            case UNetKind::Plain:
                return conv(part(".1"), -1, conv(part(".0"), skip, source, out, 3, kLeakySlope), out, 3, kLeakySlope);
            case UNetKind::Residual: {
                const int inner = conv(part(".0"), skip, source, out, 3, kLeakySlope);
                const int straight = conv(part(".straight"), skip, source, out, 1, 1);
                return conv(part(".1"), -1, inner, out, 3, kLeakySlope, straight);
            }
            case UNetKind::Separable: {
                int x = conv(part(".in"), skip, source, out, 1, kLeakySlope);
                for (const char* i : {".0", ".1"}) {
                    x = depthwise(part(i) + ".space", x);
                    x = conv(part(i) + ".channels", -1, x, out, 1, kLeakySlope);
                }
                return x;
            }
            case UNetKind::Paper: {
                const int inner = conv(part(".0"), skip, source, out, 3, kLeakySlope);
                layers_.back().conv.affine = affine;
                return conv(part(".1"), -1, inner, last, 3, kLeakySlope);
            }
        }
        return source;
    }
    std::vector<Layer> take() { return std::move(layers_); }

  private:
    int channels(int value) const { return channels_[size_t(value)]; }
    int size(int value) const { return sizes_[size_t(value)]; }
    int depthwise(const std::string& name, int source) {
        Layer layer{LayerOp::Conv, source, size(source)};
        layer.conv = {name, channels(source), channels(source), 3, true};
        return add(layer, channels(source));
    }
    int add(const Layer& layer, int channels) {
        layers_.push_back(layer);
        channels_.push_back(channels);
        sizes_.push_back(layer.size);
        return int(layers_.size());
    }

    const UNetShape& shape_;
    std::vector<Layer> layers_;
    std::vector<int> channels_, sizes_;  // of each value, by its number
};

}  // namespace

std::string unetKindName(UNetKind kind) { return namesOf(kind).name; }

UNetKind parseUNetKind(const std::string& name) {
    for (const KindName& n : kNames)
        if (name == n.name) return n.kind;
    throw Error(fmt::format("the network's kind is one of {}, not '{}'", listed(&KindName::name), name));
}

std::vector<Layer> UNetShape::layers() const {
    Writer net(*this);
    std::vector<int> skips;
    int x = 0;
    const int deepest = levels - 1;
    for (int l = 0; l < levels; ++l) {
        if (l > 0) x = net.maxPool(x);
        const int c = channels(l), last = l == deepest && l > 0 ? channels(l - 1) : c;
        x = net.block(fmt::format("enc{}", l), -1, x, c, last, l > 0);
        skips.push_back(x);
    }
    for (int l = deepest - 1; l >= 0; --l) {
        const int c = channels(l), last = l > 0 ? channels(l - 1) : c;
        x = net.block(fmt::format("dec{}", l), skips[size_t(l)], net.upsample(x), c, last, l > 0);
    }
    net.conv("out", -1, x, outputs, 1, 0);
    return net.take();
}

std::vector<ConvShape> UNetShape::convs() const {
    std::vector<ConvShape> list;
    for (const Layer& layer : layers())
        if (layer.op == LayerOp::Conv) list.push_back(layer.conv);
    return list;
}

size_t UNetShape::parameterCount() const {
    size_t count = 0;
    for (const ConvShape& conv : convs()) count += conv.parameterCount();
    return count;
}

double UNetShape::macs() const {
    double total = 0;
    for (const Layer& layer : layers())
        if (layer.op == LayerOp::Conv) total += double(layer.conv.weightCount()) * layer.size * layer.size;
    return total;
}

StringMap UNetShape::toMetadata() const {
    return {{"architecture", namesOf(kind).architecture},
            {"width", std::to_string(width)},
            {"levels", std::to_string(levels)},
            {"size", std::to_string(size)},
            {"inputs", std::to_string(inputs)}};
}

UNetShape UNetShape::fromMetadata(const SafetensorsFile& file) {
    const std::string architecture = file.metadata("architecture", "");
    UNetShape shape;
    bool known = false;
    for (const KindName& n : kNames)
        if (architecture == n.architecture) shape.kind = n.kind, known = true;
    if (!known)
        throw Error(SourceLocation{file.path()}, fmt::format("its architecture is '{}'; this program runs {}",
                                                             architecture, listed(&KindName::architecture)));
    shape.width = readInt(file, "width", 1, 512, 0);
    shape.levels = readInt(file, "levels", 1, 8, 4);
    shape.size = readInt(file, "size", 1, 1024, 32);
    shape.inputs = readInt(file, "inputs", kPlainPlanes, kGuidedPlanes, kPlainPlanes);
    if (shape.inputs != kPlainPlanes && shape.inputs != kGuidedPlanes)
        throw Error(SourceLocation{file.path()},
                    fmt::format("metadata 'inputs' is {}, not {} or {}", shape.inputs, kPlainPlanes, kGuidedPlanes));
    if (shape.size % (1 << (shape.levels - 1)) != 0)
        throw Error(SourceLocation{file.path()},
                    fmt::format("a size of {} cannot be halved {} times", shape.size, shape.levels - 1));
    return shape;
}

}  // namespace drc
