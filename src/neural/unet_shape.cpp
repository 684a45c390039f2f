#include "neural/unet_shape.h"

#include <fmt/core.h>

#include <charconv>

#include "base/error.h"

namespace drc {
namespace {

constexpr const char* kArchitecture = "drc-unet-1";

int readInt(const SafetensorsFile& file, const std::string& key, int low, int high, int fallback) {
    const std::string text = file.metadata(key, fallback ? std::to_string(fallback) : "");
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < low || value > high)
        throw Error(SourceLocation{file.path()},
                    fmt::format("metadata '{}' is '{}', not a whole number from {} to {}", key, text, low, high));
    return value;
}

}  // namespace

std::vector<ConvShape> UNetShape::convs() const {
    std::vector<ConvShape> list;
    for (int l = 0; l < levels; ++l) {
        const int c = channels(l);
        list.push_back({fmt::format("enc{}.0", l), l == 0 ? inputs : channels(l - 1), c, 3});
        list.push_back({fmt::format("enc{}.1", l), c, c, 3});
    }
    for (int l = levels - 2; l >= 0; --l) {
        const int c = channels(l);
        list.push_back({fmt::format("dec{}.0", l), c + channels(l + 1), c, 3});
        list.push_back({fmt::format("dec{}.1", l), c, c, 3});
    }
    list.push_back({"out", width, outputs, 1});
    return list;
}

size_t UNetShape::parameterCount() const {
    size_t count = 0;
    for (const ConvShape& conv : convs()) count += conv.weightCount() + size_t(conv.out);
    return count;
}

double UNetShape::macs() const {
    double total = 0;
    for (const ConvShape& conv : convs()) {
        const int level = conv.name == "out" ? 0 : conv.name[3] - '0';
        total += double(conv.weightCount()) * sizeAt(level) * sizeAt(level);
    }
    return total;
}

StringMap UNetShape::toMetadata() const {
    return {{"architecture", kArchitecture},
            {"width", std::to_string(width)},
            {"levels", std::to_string(levels)},
            {"size", std::to_string(size)},
            {"inputs", std::to_string(inputs)}};
}

UNetShape UNetShape::fromMetadata(const SafetensorsFile& file) {
    const std::string architecture = file.metadata("architecture", "");
    if (architecture != kArchitecture)
        throw Error(SourceLocation{file.path()},
                    fmt::format("its architecture is '{}'; this program runs '{}'", architecture, kArchitecture));
    UNetShape shape;
    shape.width = readInt(file, "width", 1, 512, 0);
    shape.levels = readInt(file, "levels", 1, 8, 4);
    shape.size = readInt(file, "size", 1, 1024, 32);
    shape.inputs = readInt(file, "inputs", 7, 7, 7);
    if (shape.size % (1 << (shape.levels - 1)) != 0)
        throw Error(SourceLocation{file.path()},
                    fmt::format("a size of {} cannot be halved {} times", shape.size, shape.levels - 1));
    return shape;
}

}  // namespace drc
