#include "image/image_layers.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.h"

namespace drc {
namespace {

std::string title(const std::string& layer) { return layer.empty() ? "the beauty" : layer; }

// The given channels of a picture under other names.
Image select(const Image& image, const std::vector<int>& channels, std::vector<std::string> names) {
    Image selected(image.width(), image.height(), std::move(names));
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            for (size_t c = 0; c < channels.size(); ++c) selected.at(x, y, int(c)) = image.at(x, y, channels[c]);
    return selected;
}

}  // namespace

std::string layerOfChannel(const std::string& channel) {
    const size_t dot = channel.rfind('.');
    return dot == std::string::npos ? "" : channel.substr(0, dot);
}

std::string suffixOfChannel(const std::string& channel) { return channel.substr(channel.rfind('.') + 1); }

std::vector<std::string> layerNames(const Image& image) {
    std::vector<std::string> names;
    for (const std::string& channel : image.channelNames())
        if (const std::string layer = layerOfChannel(channel);
            std::find(names.begin(), names.end(), layer) == names.end())
            names.push_back(layer);
    return names;
}

std::string layerList(const Image& image) {
    std::string list;
    for (const std::string& layer : layerNames(image)) list += (list.empty() ? "" : ", ") + title(layer);
    return list;
}

std::optional<Image> layerOf(const Image& image, const std::string& layer) {
    std::vector<int> channels;
    std::vector<std::string> names;
    for (int c = 0; c < image.channels(); ++c) {
        const std::string& channel = image.channelNames()[size_t(c)];
        if (layerOfChannel(channel) != layer) continue;
        channels.push_back(c);
        names.push_back(suffixOfChannel(channel));
    }
    if (channels.empty()) return std::nullopt;
    return select(image, channels, std::move(names));
}

Image rgbOfLayer(const Image& image, const std::string& layer) {
    const std::string prefix = layer.empty() ? "" : layer + ".";
    const std::vector<int> rgb{image.channelIndex(prefix + "R"), image.channelIndex(prefix + "G"),
                               image.channelIndex(prefix + "B")};
    if (std::all_of(rgb.begin(), rgb.end(), [](int c) { return c >= 0; })) return select(image, rgb, {"R", "G", "B"});
    if (const int y = image.channelIndex(prefix + "Y"); layer.empty() && y >= 0)
        return select(image, {y, y, y}, {"R", "G", "B"});
    const std::optional<Image> other = layerOf(image, layer);
    if (layer.empty() || !other)
        throw Error(fmt::format("it has {}; its layers are: {}",
                                layer.empty() ? "no channels R, G and B" : fmt::format("no layer \"{}\"", layer),
                                layerList(image)));
    return other->toRgb();
}

void setBeauty(Image& image, const Image& rgb) {
    const int r = image.channelIndex("R"), g = image.channelIndex("G"), b = image.channelIndex("B");
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const Rgb c = rgb.rgb(x, y);
            image.at(x, y, r) = c.x, image.at(x, y, g) = c.y, image.at(x, y, b) = c.z;
        }
}

Image withoutLayers(const Image& image, const std::vector<std::string>& layers) {
    std::vector<int> channels;
    std::vector<std::string> names;
    for (int c = 0; c < image.channels(); ++c) {
        const std::string& channel = image.channelNames()[size_t(c)];
        if (std::find(layers.begin(), layers.end(), layerOfChannel(channel)) != layers.end()) continue;
        channels.push_back(c);
        names.push_back(channel);
    }
    return select(image, channels, std::move(names));
}

}  // namespace drc
