// Files of named tensors, the format of the measured materials in the RGL database (https://rgl.epfl.ch/materials):
// "tensor_file", the version 1.0, and for each field its name, type, offset and shape. Little-endian.
#pragma once
#include <map>
#include <span>
#include <string>
#include <vector>

#include "pbrt/mapped_file.h"

namespace drc::pbrt {

class TensorFile {
  public:
    enum class Type : uint8_t {
        UInt8 = 1,
        Int8,
        UInt16,
        Int16,
        UInt32,
        Int32,
        UInt64,
        Int64,
        Float16,
        Float32,
        Float64
    };
    struct Field {
        Type type;
        std::vector<uint64_t> shape;
        uint64_t count;          // product of the shape
        std::string_view bytes;  // the field's data, a view of the file
    };

    // Reads the list of fields. Throws Error, in one line with the file's name, if the file is damaged.
    explicit TensorFile(const std::string& path);

    uint64_t bytes() const { return file_.text().size(); }
    bool has(const std::string& name) const { return fields_.contains(name); }
    // Throws Error if the field is missing, or does not have this type and number of dimensions.
    const Field& field(const std::string& name, Type type, size_t dimensions) const;
    // The values of a field of type Float32. Throws Error if one is not finite.
    std::vector<float> floats(const std::string& name, size_t dimensions) const;
    [[noreturn]] void bad(const std::string& what) const;

    // The value at an index in the data of a Float32 field, which may have any alignment.
    static float floatAt(const Field& field, uint64_t index);
    // A shape for messages: "4 x 5 x 6".
    static std::string shapeText(std::span<const uint64_t> shape);

  private:
    void readFields();

    std::string path_;
    MappedFile file_;
    std::map<std::string, Field> fields_;
};

}  // namespace drc::pbrt
