#include "image/image_layers.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.h"
#include "base/suggest.h"

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

std::vector<int> channelsOfLayer(const Image& image, const std::string& layer) {
    std::vector<int> channels;
    for (int c = 0; c < image.channels(); ++c)
        if (layerOfChannel(image.channelNames()[size_t(c)]) == layer) channels.push_back(c);
    return channels;
}

[[noreturn]] void failToFind(const Image& image, const std::string& name) {
    const std::string list = layerAndChannelList(image);
    if (name.empty()) throw Error(fmt::format("it has no channels R, G and B; its layers are: {}", list));
    const std::vector<std::string> layers = layerNames(image);
    std::vector<std::string_view> names(layers.begin(), layers.end());
    names.insert(names.end(), image.channelNames().begin(), image.channelNames().end());
    throw Error(
        fmt::format("it has no layer or channel \"{}\"; its layers are: {}{}", name, list, suggestion(name, names)));
}

// Indices of three channels, or of one.
std::vector<int> colourChannels(const Image& image, const std::string& layer) {
    std::vector<int> all = channelsOfLayer(image, layer), rgb;
    for (const char* colour : {"R", "G", "B"})
        if (const int c = image.channelIndex(layer.empty() ? colour : layer + "." + colour); c >= 0) rgb.push_back(c);
    if (rgb.size() == 3) return rgb;
    if (const int y = image.channelIndex("Y"); layer.empty() && y >= 0) return {y};
    if (const int c = image.channelIndex(layer); all.empty() && c >= 0) return {c};
    if (layer.empty() || all.empty()) failToFind(image, layer);
    all.resize(all.size() < 3 ? 1 : 3);
    return all;
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

std::string layerAndChannelList(const Image& image) {
    std::string list;
    for (const std::string& layer : layerNames(image)) {
        std::string channels;
        for (const int c : channelsOfLayer(image, layer))
            channels += (channels.empty() ? "" : ", ") + suffixOfChannel(image.channelNames()[size_t(c)]);
        list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", title(layer), channels);
    }
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

Image beautyOf(const Image& image) {
    const int r = image.channelIndex("R"), g = image.channelIndex("G"), b = image.channelIndex("B"),
              y = image.channelIndex("Y"), a = image.channelIndex("A");
    std::vector<int> channels;
    if (r >= 0 && g >= 0 && b >= 0)
        channels = {r, g, b};
    else if (y >= 0)
        channels = {y};
    else
        return image;
    if (a >= 0) channels.push_back(a);
    std::vector<std::string> names;
    for (const int c : channels) names.push_back(image.channelNames()[size_t(c)]);
    return select(image, channels, std::move(names));
}

Image rgbOfLayer(const Image& image, const std::string& layer) {
    const std::vector<int> channels = colourChannels(image, layer);
    return select(image, {channels.front(), channels[channels.size() / 2], channels.back()}, {"R", "G", "B"});
}

void setRgbOfLayer(Image& image, const std::string& layer, const Image& rgb) {
    const std::vector<int> channels = colourChannels(image, layer);
    if (channels.size() < 3) throw Error(fmt::format("{} has one channel, not three", title(layer)));
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const Rgb c = rgb.rgb(x, y);
            for (int i = 0; i < 3; ++i) image.at(x, y, channels[size_t(i)]) = c[i];
        }
}

Image partOfLayer(const Image& image, const std::string& layer) {
    std::vector<int> channels = channelsOfLayer(image, layer);
    if (channels.empty()) channels = colourChannels(image, layer);
    std::vector<std::string> names;
    for (const int c : channels) names.push_back(image.channelNames()[size_t(c)]);
    return select(image, channels, std::move(names));
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
