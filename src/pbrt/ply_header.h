// The header of a PLY file: its elements, their properties, and the encoding.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace drc::pbrt {

enum class PlyFormat { Ascii, LittleEndian, BigEndian };
enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };
size_t sizeOf(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float32;  // type of the value, or of a list's items
    bool isList = false;
    PlyType countType = PlyType::UInt8;  // type of a list's length
};

struct PlyElement {
    std::string name;
    uint64_t count = 0;
    std::vector<PlyProperty> properties;
    // Minimum size of an element in bytes: lists may be empty, and an ASCII value needs at least a digit and a blank.
    uint64_t minimumSize(PlyFormat format) const;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
    size_t dataOffset = 0;  // offset of the first byte after the header
};

// Throws Error "path: ..." if the header is malformed or promises more data than the file contains.
PlyHeader parsePlyHeader(std::string_view file, const std::string& path);

}  // namespace drc::pbrt
