#include "neural/safetensors.h"

#include <Imath/half.h>
#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/limits.h"

namespace drc {
namespace {

static_assert(std::endian::native == std::endian::little, "safetensors data are little endian");

constexpr std::pair<const char*, DType> kTypeNames[] = {
    {"F32", DType::F32}, {"F16", DType::F16}, {"BF16", DType::BF16}};

const char* typeName(DType type) {
    for (const auto& [name, t] : kTypeNames)
        if (t == type) return name;
    return "?";
}

uint16_t toBf16(float value) {
    const uint32_t bits = std::bit_cast<uint32_t>(value);
    if ((bits & 0x7fffffffu) > 0x7f800000u)
        return uint16_t(bits >> 16 | 0x40);  // rounding must not turn a NaN into infinity
    return uint16_t((bits + 0x7fffu + (bits >> 16 & 1)) >> 16);
}

}  // namespace

size_t bytesPerElement(DType type) { return type == DType::F32 ? 4 : 2; }

uint64_t hashBytes(const void* data, size_t size) {
    // FNV-1a on words of 8 bytes instead of bytes, with a shift that mixes high bits into low ones.
    constexpr uint64_t kPrime = 0x100000001b3;
    uint64_t h = 0xcbf29ce484222325 ^ size;
    const auto mix = [&h](uint64_t word) {
        h = (h ^ word) * kPrime;
        h ^= h >> 29;
    };
    const auto* p = static_cast<const unsigned char*>(data);
    for (; size >= 8; p += 8, size -= 8) {
        uint64_t word;
        std::memcpy(&word, p, 8);
        mix(word);
    }
    for (; size > 0; ++p, --size) mix(*p);
    mix(0);
    return h;
}

void TensorView::toFloat(size_t first, size_t count, float* out) const {
    if (first > elements || count > elements - first) throw Error("tensor read out of its range");
    const std::byte* from = data + first * bytesPerElement(type);
    if (type == DType::F32) {
        std::memcpy(out, from, count * 4);
        return;
    }
    for (size_t i = 0; i < count; ++i) {
        uint16_t bits;
        std::memcpy(&bits, from + 2 * i, 2);
        out[i] = type == DType::F16 ? imath_half_to_float(bits) : std::bit_cast<float>(uint32_t(bits) << 16);
    }
}

std::vector<float> TensorView::toFloat() const {
    std::vector<float> values(elements);
    toFloat(0, elements, values.data());
    return values;
}

SafetensorsFile::SafetensorsFile(const std::string& path) : path_(path), file_(path) { parse(); }

void SafetensorsFile::fail(const std::string& message) const { throw Error(SourceLocation{path_}, message); }

void SafetensorsFile::parse() {
    const size_t size = file_.bytes().size();
    const auto* file = reinterpret_cast<const std::byte*>(file_.bytes().data());
    if (size < 8) fail(fmt::format("truncated: {} bytes are too few for a safetensors file", size));
    uint64_t headerBytes;
    std::memcpy(&headerBytes, file, 8);
    if (headerBytes > limits::kSafetensorsHeaderBytes)
        fail(fmt::format("not a safetensors file: a header of {} bytes (limit {})", headerBytes,
                         limits::kSafetensorsHeaderBytes));
    if (headerBytes > size - 8)
        fail(fmt::format("truncated: the header needs {} bytes, the file has {}", headerBytes + 8, size));
    const std::byte* data = file + 8 + headerBytes;
    const uint64_t dataBytes = size - 8 - headerBytes;

    const char* text = reinterpret_cast<const char*>(file + 8);
    const auto header = nlohmann::json::parse(text, text + headerBytes, nullptr, false);
    if (!header.is_object()) fail("not a safetensors file: its header is not a JSON object");

    std::vector<std::pair<uint64_t, uint64_t>> ranges;
    for (const auto& [name, entry] : header.items()) {
        if (name == "__metadata__") {
            if (!entry.is_object()) fail("__metadata__ is not an object");
            for (const auto& [key, value] : entry.items()) {
                if (!value.is_string()) fail(fmt::format("metadata '{}' is not a string", key));
                metadata_[key] = value.get<std::string>();
            }
            continue;
        }
        const auto malformed = [this, &tensor = name](const char* what) {
            fail(fmt::format("tensor '{}': {}", tensor, what));
        };
        if (!entry.is_object()) malformed("its description is not an object");
        if (!entry.contains("dtype") || !entry["dtype"].is_string()) malformed("no dtype");
        if (!entry.contains("shape") || !entry["shape"].is_array()) malformed("no shape");
        if (!entry.contains("data_offsets")) malformed("no data_offsets");
        TensorView view;
        const std::string dtype = entry["dtype"].get<std::string>();
        const auto* known = std::find_if(std::begin(kTypeNames), std::end(kTypeNames),
                                         [&](const auto& pair) { return dtype == pair.first; });
        if (known == std::end(kTypeNames))
            fail(fmt::format("tensor '{}': dtype '{}' is not one of F32, F16, BF16", name, dtype));
        view.type = known->second;
        uint64_t elements = 1;
        for (const auto& extent : entry["shape"]) {
            if (!extent.is_number_unsigned()) malformed("an extent of its shape is not a whole number");
            const auto value = extent.get<uint64_t>();
            if (value > uint64_t(INT64_MAX) || __builtin_mul_overflow(elements, value, &elements))
                malformed("its shape is too large");
            view.shape.push_back(int64_t(value));
        }
        const auto& offsets = entry["data_offsets"];
        if (!offsets.is_array() || offsets.size() != 2 || !offsets[0].is_number_unsigned() ||
            !offsets[1].is_number_unsigned())
            malformed("data_offsets are not two whole numbers");
        const auto begin = offsets[0].get<uint64_t>(), end = offsets[1].get<uint64_t>();
        if (begin > end) malformed("data_offsets are in the wrong order");
        if (end > dataBytes)
            fail(fmt::format("truncated: tensor '{}' ends at byte {} of the data, the file has {}", name, end,
                             dataBytes));
        uint64_t bytes;
        if (__builtin_mul_overflow(elements, uint64_t(bytesPerElement(view.type)), &bytes) || bytes != end - begin)
            malformed("its shape and the size of its data disagree");
        view.elements = elements;
        view.data = data + begin;
        ranges.emplace_back(begin, end);
        tensors_.emplace(name, std::move(view));
    }
    std::sort(ranges.begin(), ranges.end());
    uint64_t reached = 0;
    for (const auto& [begin, end] : ranges) {
        if (begin != reached) fail(begin < reached ? "two tensors overlap" : "a hole between two tensors");
        reached = end;
    }
    if (reached != dataBytes) fail(fmt::format("{} bytes after the last tensor", dataBytes - reached));
}

std::string SafetensorsFile::metadata(const std::string& key, const std::string& fallback) const {
    const auto found = metadata_.find(key);
    return found == metadata_.end() ? fallback : found->second;
}

const TensorView& SafetensorsFile::tensor(const std::string& name) const {
    const auto found = tensors_.find(name);
    if (found == tensors_.end()) fail(fmt::format("no tensor '{}'", name));
    return found->second;
}

std::string SafetensorsFile::contentHash() const {
    return fmt::format("{:016x}", hashBytes(file_.bytes().data(), file_.bytes().size()));
}

void writeSafetensors(const std::string& path, const std::vector<TensorToWrite>& tensors, const StringMap& metadata) {
    nlohmann::ordered_json header;
    if (!metadata.empty()) header["__metadata__"] = metadata;
    uint64_t offset = 0;
    std::vector<size_t> elements;
    for (const TensorToWrite& t : tensors) {
        size_t count = 1;
        for (int64_t extent : t.shape) count *= size_t(extent);
        elements.push_back(count);
        const uint64_t end = offset + count * bytesPerElement(t.type);
        header[t.name] = {{"dtype", typeName(t.type)}, {"shape", t.shape}, {"data_offsets", {offset, end}}};
        offset = end;
    }
    std::string text = header.is_null() ? "{}" : header.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    text.resize((text.size() + 7) / 8 * 8, ' ');

    AtomicFile file(path);
    const auto write = [&file](const void* data, size_t bytes) {
        file.write(std::string_view(static_cast<const char*>(data), bytes));
    };
    const uint64_t headerBytes = text.size();
    write(&headerBytes, 8);
    write(text.data(), text.size());
    std::vector<uint16_t> block;
    for (size_t i = 0; i < tensors.size(); ++i) {
        const TensorToWrite& t = tensors[i];
        if (t.type == DType::F32) {
            write(t.data, elements[i] * 4);
            continue;
        }
        constexpr size_t kBlock = 1 << 16;
        for (size_t first = 0; first < elements[i]; first += kBlock) {
            block.resize(std::min(kBlock, elements[i] - first));
            for (size_t j = 0; j < block.size(); ++j) {
                const float value = t.data[first + j];
                block[j] = t.type == DType::F16 ? imath_float_to_half(value) : toBf16(value);
            }
            write(block.data(), block.size() * 2);
        }
    }
    file.commit();
}

}  // namespace drc
