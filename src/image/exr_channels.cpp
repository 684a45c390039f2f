#include "image/exr_channels.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <tuple>

namespace drc {
namespace {

// The sort key of a channel: its layer ("" or "name."), its rank within the layer and its name.
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

// Rank of a channel within its layer: the customary order (R, G, B, ...) instead of the file's alphabetical one. Y is a
// luminance, or a coordinate in a layer with X and also Y or Z (isPosition).
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

std::vector<std::string> ordered(const std::vector<std::string>& channels) {
    std::vector<ChannelPlace> places;
    std::map<std::string, std::string> coordinates;  // for each layer, those of "xyz" that it contains
    for (const std::string& name : channels) {
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

size_t beautyOf(const std::vector<ExrPartChannels>& parts) {
    if (parts.size() == 1) return 0;
    const auto firstWith = [&](const std::vector<const char*>& names) {
        const auto hasAll = [&](const ExrPartChannels& part) {
            return std::all_of(names.begin(), names.end(), [&](const char* name) {
                return std::find(part.channels.begin(), part.channels.end(), name) != part.channels.end();
            });
        };
        return size_t(std::find_if(parts.begin(), parts.end(), hasAll) - parts.begin());
    };
    const size_t coloured = firstWith({"R", "G", "B"});
    return coloured < parts.size() ? coloured : firstWith({"Y"});
}

}  // namespace

ExrChannels exrChannels(const std::vector<ExrPartChannels>& parts) {
    ExrChannels all{{}, beautyOf(parts)};
    std::vector<size_t> order;
    if (all.beautyPart < parts.size()) order.push_back(all.beautyPart);
    for (size_t i = 0; i < parts.size(); ++i)
        if (i != all.beautyPart) order.push_back(i);
    std::set<std::string> taken;
    for (const size_t i : order) {
        const std::string number = fmt::format("part{}", i + 1);
        const std::string prefix = (parts[i].part.empty() ? number : parts[i].part) + ".";
        for (const std::string& channel : ordered(parts[i].channels)) {
            // Some programs already write the part's name before its channels' names.
            std::string name = i == all.beautyPart || channel.starts_with(prefix) ? channel : prefix + channel;
            while (!taken.insert(name).second) name = number + "." + name;
            all.channels.push_back({name, i, channel});
        }
    }
    return all;
}

}  // namespace drc
