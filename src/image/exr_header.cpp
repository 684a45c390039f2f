#include "image/exr_header.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.h"

namespace drc {
namespace {

struct TypeSize {
    std::string_view type;
    size_t bytes;
};

constexpr TypeSize kTypeSizes[] = {
    {"box2f", 16},
    {"box2i", 16},
    {"chromaticities", 32},
    {"compression", 1},
    {"deepImageState", 1},
    {"double", 8},
    {"envmap", 1},
    {"float", 4},
    {"int", 4},
    {"keycode", 28},
    {"lineOrder", 1},
    {"m33d", 72},
    {"m33f", 36},
    {"m44d", 128},
    {"m44f", 64},
    {"rational", 8},
    {"tiledesc", 9},
    {"timecode", 8},
    {"v2d", 16},
    {"v2f", 8},
    {"v2i", 8},
    {"v3d", 24},
    {"v3f", 12},
    {"v3i", 12},
};

bool hasSizeOfItsType(std::string_view type, ByteReader value) {
    const auto known = std::find_if(std::begin(kTypeSizes), std::end(kTypeSizes),
                                    [&](const TypeSize& entry) { return entry.type == type; });
    if (known != std::end(kTypeSizes)) return value.left() == known->bytes;
    try {
        if (type == "chlist") {
            while (!value.until('\0').empty()) value.take(16);
            return value.left() == 0;
        }
        if (type == "stringvector") {
            while (value.left() > 0) value.take(value.littleEndian32());
            return true;
        }
        if (type == "preview") {
            const uint64_t width = value.littleEndian32(), height = value.littleEndian32();
            return width <= value.left() && height <= value.left() && width * height * 4 == value.left();
        }
    } catch (const Error&) {
        return false;
    }
    return type != "floatvector" || value.left() % sizeof(float) == 0;
}

}  // namespace

std::vector<ExrAttributes> requireSoundExrHeaders(const EncodedImage& encoded) {
    constexpr uint32_t kMultiPart = 1 << 12;
    ByteReader in(encoded);
    in.take(4);  // the magic number
    const bool isMultiPart = (in.littleEndian32() & kMultiPart) != 0;
    std::vector<ExrAttributes> parts;
    // An empty attribute name ends a header. In a file with several parts, an empty header follows the last one.
    do {
        ExrAttributes& attributes = parts.emplace_back();
        for (std::string_view name = in.until('\0'); !name.empty(); name = in.until('\0')) {
            const std::string_view type = in.until('\0');
            const auto bytes = in.take(in.littleEndian32());
            const EncodedImage value{{reinterpret_cast<const char*>(bytes.data()), bytes.size()}, encoded.path};
            if (!hasSizeOfItsType(type, ByteReader(value)))
                failDecoding(encoded, fmt::format("its attribute {} has {} bytes, which no {} has", name.substr(0, 80),
                                                  bytes.size(), type.substr(0, 80)));
            attributes[std::string(name)] = {std::string(type), std::string(value.bytes)};
        }
        in.require(isMultiPart ? 1 : 0);
    } while (isMultiPart && in.peek(1).front() != 0);
    return parts;
}

}  // namespace drc
