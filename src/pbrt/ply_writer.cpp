#include "pbrt/ply_writer.h"

#include <fmt/core.h>

#include <bit>

#include "base/atomic_file.h"

namespace drc::pbrt {
namespace {

static_assert(std::endian::native == std::endian::little, "values are written as they are in memory");

// Collects bytes, and writes them in large pieces.
class PlyBytes {
  public:
    explicit PlyBytes(const std::string& path) : file_(path) {}

    // value: a number, or a vector of numbers.
    template <typename T>
    void add(const T& value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof(T));
        if (bytes_.size() >= kPiece) flush();
    }
    void addText(std::string_view text) { bytes_ += text; }
    void commit() {
        flush();
        file_.commit();
    }

  private:
    static constexpr size_t kPiece = size_t(1) << 20;
    void flush() {
        file_.write(bytes_);
        bytes_.clear();
    }

    AtomicFile file_;
    std::string bytes_;
};

std::string plyHeader(const TriangleMesh& mesh) {
    std::string text = fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", mesh.positions.size());
    const auto properties = [&](std::initializer_list<const char*> names) {
        for (const char* name : names) text += fmt::format("property float {}\n", name);
    };
    properties({"x", "y", "z"});
    if (!mesh.normals.empty()) properties({"nx", "ny", "nz"});
    if (!mesh.uvs.empty()) properties({"u", "v"});
    return text +
           fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n", mesh.triangleCount());
}

}  // namespace

void writePly(const TriangleMesh& mesh, const std::string& path) {
    PlyBytes out(path);
    out.addText(plyHeader(mesh));
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        out.add(mesh.positions[i]);
        if (!mesh.normals.empty()) out.add(mesh.normals[i]);
        if (!mesh.uvs.empty()) out.add(mesh.uvs[i]);
    }
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        out.add(uint8_t(3));
        for (size_t k = 0; k < 3; ++k) out.add(int32_t(mesh.indices[i + k]));
    }
    out.commit();
}

}  // namespace drc::pbrt
