#include "pbrt/tensor_file.h"

#include <fmt/core.h>

#include <bit>
#include <cmath>
#include <cstring>

#include "base/error.h"

namespace drc::pbrt {
namespace {

static_assert(std::endian::native == std::endian::little, "the file is little-endian");

constexpr std::string_view kMagic("tensor_file\0", 12);
constexpr std::string_view kTypeNames[] = {"no type", "uint8",  "int8",  "uint16",  "int16",   "uint32",
                                           "int32",   "uint64", "int64", "float16", "float32", "float64"};
constexpr uint64_t kTypeBytes[] = {0, 1, 1, 2, 2, 4, 4, 8, 8, 2, 4, 8};

// A field's name in a form that is safe to print: at most 40 characters, others than ASCII replaced.
std::string printable(std::string_view name) {
    std::string text;
    for (const char c : name.substr(0, 40)) text += c > ' ' && c < 127 ? c : '?';
    return text;
}

}  // namespace

TensorFile::TensorFile(const std::string& path) : path_(path), file_(path, "BSDF file", limits::kBsdfBytes) {
    readFields();
}

void TensorFile::bad(const std::string& what) const { throw Error({path_, 0, 0}, "the BSDF file " + what); }

std::string TensorFile::shapeText(std::span<const uint64_t> shape) {
    std::string text;
    for (const uint64_t size : shape) text += (text.empty() ? "" : " x ") + std::to_string(size);
    return text.empty() ? "nothing" : text;
}

void TensorFile::readFields() {
    const std::string_view text = file_.text();
    size_t at = 0;
    const auto take = [&](void* to, size_t count, const std::string& what) {
        if (text.size() - at < count)
            bad(fmt::format("is cut short: {} ends at byte {}, and it has {}", what, at + count, text.size()));
        std::memcpy(to, text.data() + at, count);
        at += count;
    };
    if (!text.starts_with(kMagic)) bad("is of another kind: it does not begin with 'tensor_file'");
    at = kMagic.size();
    uint8_t version[2];
    take(version, 2, "its version");
    if (version[0] != 1 || version[1] != 0)
        bad(fmt::format("has the version {}.{}; only 1.0 is supported", version[0], version[1]));
    uint32_t count;
    take(&count, 4, "its number of fields");
    for (uint32_t i = 0; i < count; ++i) {
        const std::string which = fmt::format("field {} of {}", i + 1, count);
        uint16_t nameLength, dimensions;
        take(&nameLength, 2, which);
        std::string name(std::min<size_t>(nameLength, text.size() - at), '\0');
        take(name.data(), nameLength, which);
        Field field;
        uint8_t type;
        uint64_t offset;
        take(&dimensions, 2, which);
        take(&type, 1, which);
        take(&offset, 8, which);
        if (type < 1 || type >= std::size(kTypeBytes))
            bad(fmt::format("has a field '{}' of the unknown type {}", printable(name), type));
        field.type = Type(type);
        field.count = 1;
        uint64_t left = text.size() / kTypeBytes[type];  // number of values for which the file has room
        for (uint16_t d = 0; d < dimensions; ++d) {
            uint64_t size;
            take(&size, 8, which);
            field.shape.push_back(size);
            field.count = size != 0 && field.count > left / size ? left + 1 : field.count * size;
        }
        const uint64_t bytes = field.count * kTypeBytes[type];
        if (field.count > left || offset > text.size() || bytes > text.size() - offset)
            bad(fmt::format("is cut short: its field '{}' ({} of {}, from byte {}) does not fit into its {} bytes",
                            printable(name), shapeText(field.shape), kTypeNames[type], offset, text.size()));
        field.bytes = text.substr(offset, bytes);
        if (!fields_.emplace(name, std::move(field)).second) bad(fmt::format("has two fields '{}'", printable(name)));
    }
}

const TensorFile::Field& TensorFile::field(const std::string& name, Type type, size_t dimensions) const {
    const auto found = fields_.find(name);
    if (found == fields_.end()) bad(fmt::format("has no field '{}'", name));
    const Field& f = found->second;
    if (f.type != type || f.shape.size() != dimensions)
        bad(fmt::format("has a field '{}' of {} dimensions and type {}, not of {} and {}", name, f.shape.size(),
                        kTypeNames[size_t(f.type)], dimensions, kTypeNames[size_t(type)]));
    return f;
}

float TensorFile::floatAt(const Field& field, uint64_t index) {
    float value;
    std::memcpy(&value, field.bytes.data() + index * sizeof(float), sizeof(float));
    return value;
}

std::vector<float> TensorFile::floats(const std::string& name, size_t dimensions) const {
    const Field& f = field(name, Type::Float32, dimensions);
    std::vector<float> values(f.count);
    if (f.count > 0) std::memcpy(values.data(), f.bytes.data(), f.bytes.size());
    for (size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i])) bad(fmt::format("has a value in '{}' (number {}) that is not finite", name, i));
    return values;
}

}  // namespace drc::pbrt
