// `drc image info`.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "app/image_output.h"
#include "app/image_subcommands.h"
#include "image/auto_exposure.h"
#include "image/channel_statistics.h"
#include "image/exr_matrix.h"
#include "image/image_layers.h"
#include "image/object_placements.h"
#include "image/picture_file.h"
#include "image/picture_window.h"

namespace drc {
namespace {

struct InfoOptions {
    std::vector<std::string> inputs;
    std::string layer;
    bool json = false;
};

// How an EXR stores a channel.
const char* typeName(const PictureFile& file, const std::string& channel) {
    return file.storage.halfChannels.contains(channel)      ? "halves"
           : file.storage.integerChannels.contains(channel) ? "integers"
                                                            : "floats";
}

std::string encodingName(const PictureFile& file) {
    if (file.encoding != Encoding::Float) return file.encoding == Encoding::UInt16 ? "16 bits, sRGB" : "8 bits, sRGB";
    std::set<std::string> names;
    for (const std::string& channel : file.image.channelNames()) names.insert(typeName(file, channel));
    return fmt::format("{}", fmt::join(names, ", "));
}

// "the beauty (part rgba), depth".
std::string layersOf(const PictureFile& file) {
    std::string list = layerList(file.image);
    constexpr std::string_view kBeauty = "the beauty";
    if (!file.beautyPart.empty() && list.starts_with(kBeauty))
        list.insert(kBeauty.size(), fmt::format(" (part {})", file.beautyPart));
    return list;
}

bool hasColours(const Image& image) {
    return image.channelIndex("Y") >= 0 ||
           (image.channelIndex("R") >= 0 && image.channelIndex("G") >= 0 && image.channelIndex("B") >= 0);
}

// Replaces control characters, so that any text from a file stays on one line.
std::string printable(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < ' ' || c == 127) c = ' ';
    return text;
}

// An attribute that is no string: a matrix by its rows, as the file has it for row vectors, others by their type.
std::string valueOf(const PictureFile& file, const std::string& name, const ExrAttribute& attribute) {
    if (const std::optional<Transform> matrix = matrixIn(file.storage.attributes, name)) {
        std::vector<std::string> rows;
        for (int row = 0; row < 4; ++row)
            rows.push_back(fmt::format("{:g} {:g} {:g} {:g}", matrix->at(0, row), matrix->at(1, row),
                                       matrix->at(2, row), matrix->at(3, row)));
        return fmt::format("{}", fmt::join(rows, ", "));
    }
    if (name == ObjectPlacements::kAttribute)
        return fmt::format("the places of {} objects", ObjectPlacements::in(file.storage.attributes).size());
    return fmt::format("{} of {} bytes", attribute.type, attribute.value.size());
}

void printText(const PictureFile& file) {
    const Image& image = file.image;
    fmt::print("{}\n  size      {} x {} pixels", file.path, image.width(), image.height());
    const ExrWindow& w = file.window;
    if (!isWhole(image, w)) fmt::print(", at ({}, {}) of {} x {}", w.x, w.y, w.fullWidth, w.fullHeight);
    fmt::print("\n  values    {}\n  layers    {}\n", encodingName(file), printable(layersOf(file)));
    if (hasColours(image))
        fmt::print("  exposure  {:+.2f} stops by --auto-exposure\n", autoExposure(rgbOfLayer(image, "")));
    for (const auto& [key, text] : file.metadata)
        if (!text.empty()) fmt::print("  {} = {}\n", printable(key), printable(text));
    for (const auto& [name, attribute] : file.storage.attributes)
        fmt::print("  {} = {}\n", printable(name), printable(valueOf(file, name, attribute)));
    const auto statistics = channelStatistics(image);
    size_t width = 7;
    for (const std::string& name : image.channelNames()) width = std::max(width, name.size());
    fmt::print("  {:<{}} {:>12} {:>12} {:>12} {:>8} {:>8}\n", "channel", width, "min", "mean", "max", "NaN",
               "infinite");
    for (size_t c = 0; c < statistics.size(); ++c) {
        const ChannelStatistics& s = statistics[c];
        fmt::print("  {:<{}} {:>12.6g} {:>12.6g} {:>12.6g} {:>8} {:>8}\n", printable(image.channelNames()[c]), width,
                   s.min, s.mean, s.max, s.nan, s.infinite);
    }
}

nlohmann::ordered_json jsonOf(const PictureFile& file) {
    nlohmann::ordered_json json;
    json["path"] = file.path;
    json["width"] = file.image.width();
    json["height"] = file.image.height();
    json["values"] = encodingName(file);
    if (file.window.fullWidth > 0)
        json["window"] = {file.window.x, file.window.y, file.window.fullWidth, file.window.fullHeight};
    json["layers"] = layerNames(file.image);
    if (hasColours(file.image)) json["auto_exposure"] = autoExposure(rgbOfLayer(file.image, ""));
    json["metadata"] = file.metadata;
    for (const auto& [name, attribute] : file.storage.attributes) {
        json["attributes"][name]["type"] = attribute.type;
        if (const std::optional<Transform> matrix = matrixIn(file.storage.attributes, name))
            for (int i = 0; i < 16; ++i) json["attributes"][name]["value"].push_back(matrix->at(i % 4, i / 4));
    }
    const auto statistics = channelStatistics(file.image);
    for (size_t c = 0; c < statistics.size(); ++c) {
        const ChannelStatistics& s = statistics[c];
        json["channels"][file.image.channelNames()[c]] = {
            {"min", s.min}, {"mean", s.mean}, {"max", s.max}, {"nan", s.nan}, {"infinite", s.infinite}};
        if (file.encoding == Encoding::Float)
            json["channels"][file.image.channelNames()[c]]["type"] = typeName(file, file.image.channelNames()[c]);
    }
    return json;
}

void info(const InfoOptions& options) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const std::string& path : options.inputs) {
        PictureFile file = readPictureFile(path);
        if (!options.layer.empty()) file.image = partOf(file, options.layer);
        if (options.json)
            all.push_back(jsonOf(file));
        else
            printText(file);
    }
    // Metadata need not be UTF-8.
    constexpr auto kReplace = nlohmann::ordered_json::error_handler_t::replace;
    if (options.json) fmt::print("{}\n", all.dump(-1, ' ', false, kReplace));
}

}  // namespace

void addImageInfo(CLI::App& image) {
    const auto options = std::make_shared<InfoOptions>();
    CLI::App* command = image.add_subcommand("info", "Print size, layers, metadata and statistics of pictures");
    command->add_option("PICTURE", options->inputs, "Pictures to read")->required();
    command->add_option("--layer", options->layer,
                        "The layer or the channel to print the statistics of, in place of all");
    command->add_flag("--json", options->json, "Print a JSON array with an object for each picture");
    command->footer(
        "Values are linear: integers are decoded from sRGB. Minimum, mean and maximum are of the finite ones.\n\n"
        "Example: drc image info render.exr");
    command->callback([options] { info(*options); });
}

}  // namespace drc
