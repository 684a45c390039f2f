// Safetensors files, which store the network's weights: named tensors and a map of strings. Layout: the header's length
// in 8 bytes (little endian), a JSON header, the raw data.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/mapped_file.h"

namespace drc {

enum class DType { F32, F16, BF16 };
size_t bytesPerElement(DType type);

using StringMap = std::map<std::string, std::string>;

// A tensor in an open file, row-major. Valid while the SafetensorsFile lives.
struct TensorView {
    DType type = DType::F32;
    std::vector<int64_t> shape;
    const std::byte* data = nullptr;
    size_t elements = 0;

    // Converts elements [first, first + count) to float.
    void toFloat(size_t first, size_t count, float* out) const;
    std::vector<float> toFloat() const;
};

// A memory-mapped file. The constructor checks everything that reading a tensor relies on. It throws drc::Error, one
// line that begins with the file name, if the file is truncated, has overlapping tensors, or is invalid in another way.
class SafetensorsFile {
  public:
    explicit SafetensorsFile(const std::string& path);

    const std::string& path() const { return path_; }
    const StringMap& metadata() const { return metadata_; }
    // The value of a metadata key; fallback if it is absent.
    std::string metadata(const std::string& key, const std::string& fallback) const;
    const std::map<std::string, TensorView>& tensors() const { return tensors_; }
    bool has(const std::string& name) const { return tensors_.count(name) != 0; }
    // Throws drc::Error if there is no such tensor.
    const TensorView& tensor(const std::string& name) const;
    // A 64-bit hash of the content, as 16 hexadecimal digits. Not cryptographic.
    std::string contentHash() const;

  private:
    void parse();
    [[noreturn]] void fail(const std::string& message) const;

    std::string path_;
    MappedFile file_;
    StringMap metadata_;
    std::map<std::string, TensorView> tensors_;
};

// A tensor to write. `data` contains floats, which are converted to `type` with rounding to nearest even.
struct TensorToWrite {
    std::string name;
    std::vector<int64_t> shape;
    const float* data = nullptr;
    DType type = DType::F32;
};

// Writes a file, whole or not at all. Throws drc::Error if it cannot be written.
void writeSafetensors(const std::string& path, const std::vector<TensorToWrite>& tensors, const StringMap& metadata);

// The hash that contentHash() returns in hexadecimal.
uint64_t hashBytes(const void* data, size_t size);

}  // namespace drc
