#include "pbrt/ply_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "base/error.h"
#include "base/log.h"
#include "base/memory.h"
#include "pbrt/gzip.h"
#include "pbrt/mapped_file.h"
#include "pbrt/ply_header.h"

namespace drc::pbrt {
namespace {

static_assert(std::endian::native == std::endian::little, "BinaryValues swaps bytes for big-endian files only");

[[noreturn]] void failPly(const std::string& path, const std::string& what) {
    throw Error({path, 0, 0}, "the PLY file " + what);
}

// Readers of binary and of ASCII values. Both have next(type), which returns the value as a double; a double represents
// all PLY types exactly.
template <bool kSwap>
class BinaryValues {
  public:
    BinaryValues(std::string_view data, const std::string& path)
        : at_(data.data()), end_(at_ + data.size()), path_(path) {}

    double next(PlyType type) {
        switch (type) {
            case PlyType::Int8:
                return read<int8_t>();
            case PlyType::UInt8:
                return read<uint8_t>();
            case PlyType::Int16:
                return read<int16_t>();
            case PlyType::UInt16:
                return read<uint16_t>();
            case PlyType::Int32:
                return read<int32_t>();
            case PlyType::UInt32:
                return read<uint32_t>();
            case PlyType::Float32:
                return double(read<float>());
            case PlyType::Float64:
                return read<double>();
        }
        return 0;
    }
    // Maximum number of values that the file may still contain.
    uint64_t left(PlyType type) const { return uint64_t(end_ - at_) / sizeOf(type); }

  private:
    template <typename T>
    T read() {
        if (size_t(end_ - at_) < sizeof(T)) failPly(path_, "is cut short: its data end too early");
        char bytes[sizeof(T)];
        for (size_t i = 0; i < sizeof(T); ++i) bytes[i] = at_[kSwap ? sizeof(T) - 1 - i : i];
        at_ += sizeof(T);
        T value;
        std::memcpy(&value, bytes, sizeof(T));
        return value;
    }

    const char* at_;
    const char* end_;
    const std::string& path_;
};

class AsciiValues {
  public:
    AsciiValues(std::string_view data, const std::string& path)
        : at_(data.data()), end_(at_ + data.size()), path_(path) {}

    double next(PlyType) {
        while (at_ < end_ && static_cast<unsigned char>(*at_) <= ' ') ++at_;
        if (at_ == end_) failPly(path_, "is cut short: its data end too early");
        if (*at_ == '+') ++at_;
        double value = 0;
        const auto [stop, error] = std::from_chars(at_, end_, value);
        const bool ends = stop == end_ || static_cast<unsigned char>(*stop) <= ' ';
        if (error == std::errc::invalid_argument || !ends) {
            const char* wordEnd = at_;
            while (wordEnd < end_ && wordEnd - at_ < 40 && static_cast<unsigned char>(*wordEnd) > ' ') ++wordEnd;
            failPly(path_, "has '" + std::string(at_, wordEnd) + "' where a number should be");
        }
        if (error == std::errc::result_out_of_range) value = std::strtod(std::string(at_, stop).c_str(), nullptr);
        at_ = stop;
        return value;
    }
    uint64_t left(PlyType) const { return uint64_t(end_ - at_ + 1) / 2; }

  private:
    const char* at_;
    const char* end_;
    const std::string& path_;
};

// The meaning of a vertex property: an index into {x, y, z, nx, ny, nz, u, v}, or kSkip.
constexpr int kNormal = 3, kUv = 6, kSlots = 8, kSkip = kSlots;
using SlotNames = std::array<std::string_view, kSlots>;

// The property names to read, by slot. A file may have several pairs of texture coordinates; like pbrt, this uses the
// first pair in the order of kUvNames.
SlotNames slotNamesFor(const PlyElement& vertex) {
    const auto has = [&](std::string_view name) {
        return std::any_of(vertex.properties.begin(), vertex.properties.end(),
                           [&](const PlyProperty& p) { return !p.isList && p.name == name; });
    };
    SlotNames names = {"x", "y", "z", "nx", "ny", "nz", "u", "v"};
    static constexpr std::array<std::string_view, 2> kUvNames[] = {
        {"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}};
    for (const auto& pair : kUvNames)
        if (has(pair[0]) && has(pair[1])) {
            names[kUv] = pair[0];
            names[kUv + 1] = pair[1];
            break;
        }
    return names;
}

// Number of vertices or indices to read between two calls of MemoryClaim::taken().
constexpr size_t kTakenTogether = size_t(1) << 16;

template <typename Values>
class MeshReader {
  public:
    MeshReader(const PlyHeader& header, Values values, const std::string& path)
        : header_(header), values_(values), path_(path) {}

    TriangleMesh read() {
        bool hasVertices = false, hasFaces = false;
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex" && !hasVertices) {
                readVertices(element);
                hasVertices = true;
            } else if (element.name == "face" && !hasFaces) {
                readFaces(element);
                hasFaces = true;
            } else {
                for (uint64_t i = 0; i < element.count; ++i)
                    for (const PlyProperty& property : element.properties) skip(property);
            }
        }
        if (!hasVertices) failPly(path_, "has no element 'vertex'");
        if (!hasFaces) failPly(path_, "has no element 'face'");
        for (const uint32_t index : mesh_.indices)
            if (index >= mesh_.positions.size())
                failPly(path_, "has a face with vertex " + std::to_string(index) + ", but only " +
                                   std::to_string(mesh_.positions.size()) + " vertices");
        if (emptyFaces_ > 0)
            logWarning({path_, 0, 0}, "the PLY file has " + std::to_string(emptyFaces_) +
                                          " faces of less than three corners; they are left out");
        return std::move(mesh_);
    }

  private:
    void readVertices(const PlyElement& element) {
        const SlotNames names = slotNamesFor(element);
        const auto slotOf = [&](const std::string& name) {
            return int(std::find(names.begin(), names.end(), name) - names.begin());
        };
        std::vector<int> slots;
        std::array<bool, kSlots + 1> present{};
        for (const PlyProperty& property : element.properties) {
            const int slot = property.isList ? kSkip : slotOf(property.name);
            // If two properties have the same meaning, the second one is skipped.
            slots.push_back(present[size_t(slot)] ? kSkip : slot);
            present[size_t(slot)] = true;
        }
        if (!present[0] || !present[1] || !present[2]) failPly(path_, "has vertices without x, y and z");
        const bool normals = present[kNormal] && present[kNormal + 1] && present[kNormal + 2];
        const bool uvs = present[kUv] && present[kUv + 1];
        if (element.count > std::numeric_limits<uint32_t>::max()) failPly(path_, "has more than 2^32 vertices");

        const size_t count = size_t(element.count);
        const double bytes = sizeof(Vec3) * (normals ? 2 : 1) + (uvs ? sizeof(Vec2) : 0);
        MemoryClaim memory(double(count) * bytes, path_);
        mesh_.positions.resize(count);
        if (normals) mesh_.normals.resize(count);
        if (uvs) mesh_.uvs.resize(count);
        std::array<float, kSlots + 1> v{};
        for (size_t i = 0; i < count; ++i) {
            if (i % kTakenTogether == 0) memory.taken(double(i) * bytes);
            for (size_t p = 0; p < slots.size(); ++p) {
                if (element.properties[p].isList)
                    skip(element.properties[p]);
                else
                    v[size_t(slots[p])] = float(values_.next(element.properties[p].type));
            }
            mesh_.positions[i] = Vec3(v[0], v[1], v[2]);
            if (normals) mesh_.normals[i] = Vec3(v[3], v[4], v[5]);
            if (uvs) mesh_.uvs[i] = Vec2(v[6], v[7]);
        }
    }

    void readFaces(const PlyElement& element) {
        bool found = false;
        for (const PlyProperty& p : element.properties) found = found || isCorners(p);
        if (!found) failPly(path_, "has faces without a list 'vertex_indices'");
        reserveIndices(size_t(element.count) * 3);
        for (uint64_t i = 0; i < element.count; ++i)
            for (const PlyProperty& property : element.properties) {
                if (isCorners(property))
                    readCorners(property);
                else
                    skip(property);
            }
        indexMemory_.reset();
    }

    static bool isCorners(const PlyProperty& p) {
        return p.isList && (p.name == "vertex_indices" || p.name == "vertex_index");
    }

    void readCorners(const PlyProperty& property) {
        const uint64_t n = listLength(property);
        if (n < 3) {
            // A degenerate face; pbrt drops it as well.
            for (uint64_t i = 0; i < n; ++i) values_.next(property.type);
            ++emptyFaces_;
            return;
        }
        const uint32_t first = corner(property.type);
        const uint32_t second = corner(property.type);
        uint32_t previous = corner(property.type);
        addTriangle(first, second, previous);
        for (uint64_t i = 3; i < n; ++i) {
            const uint32_t next = corner(property.type);
            // pbrt's order of corners, which determines the texture coordinates of meshes without any.
            addTriangle(next, first, previous);
            previous = next;
        }
    }

    void reserveIndices(size_t count) {
        indexMemory_.emplace(double(count) * sizeof(uint32_t), path_);
        mesh_.indices.reserve(count);
    }

    // Indices are claimed as they grow: triangles may need twelve times as many bytes as a list of small integers.
    void addTriangle(uint32_t a, uint32_t b, uint32_t c) {
        std::vector<uint32_t>& indices = mesh_.indices;
        if (indices.capacity() - indices.size() < 3) reserveIndices(2 * indices.capacity() + 3);
        indices.insert(indices.end(), {a, b, c});
        if (indices.size() % kTakenTogether < 3) indexMemory_->taken(double(indices.size()) * sizeof(uint32_t));
    }

    uint32_t corner(PlyType type) {
        const double value = values_.next(type);
        if (!(value >= 0 && value <= double(std::numeric_limits<uint32_t>::max())) || value != std::trunc(value))
            failPly(path_, "has a face with an impossible vertex");
        return uint32_t(value);
    }

    uint64_t listLength(const PlyProperty& property) {
        const double n = values_.next(property.countType);
        if (!(n >= 0 && n <= double(values_.left(property.type))))
            failPly(path_, "is cut short: a list of it has no end");
        return uint64_t(n);
    }

    void skip(const PlyProperty& property) {
        const uint64_t n = property.isList ? listLength(property) : 1;
        for (uint64_t i = 0; i < n; ++i) values_.next(property.type);
    }

    const PlyHeader& header_;
    Values values_;
    const std::string& path_;
    TriangleMesh mesh_;
    std::optional<MemoryClaim> indexMemory_;  // for the capacity of mesh_.indices while the file is read
    uint64_t emptyFaces_ = 0;
};

}  // namespace

TriangleMesh readPly(const std::string& path) {
    const MappedFile file(path, "PLY file");
    const bool packed = isGzip(file.text());
    const std::string unpacked = packed ? gunzip(file.text(), path) : "";
    const std::string_view text = packed ? std::string_view(unpacked) : file.text();
    const PlyHeader header = parsePlyHeader(text, path);
    const std::string_view data = text.substr(header.dataOffset);
    switch (header.format) {
        case PlyFormat::Ascii:
            return MeshReader(header, AsciiValues(data, path), path).read();
        case PlyFormat::LittleEndian:
            return MeshReader(header, BinaryValues<false>(data, path), path).read();
        case PlyFormat::BigEndian:
            return MeshReader(header, BinaryValues<true>(data, path), path).read();
    }
    return {};
}

}  // namespace drc::pbrt
