// Names of surfaces in the scene file, shown to a user who picks a surface. Rendering does not depend on them.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace drc {

// The views that SurfaceNames::at() returns refer to strings owned by the table.
struct SurfaceName {
    std::string_view material;      // the material's name in the file; empty: unnamed
    std::string_view materialKind;  // "matte", "glass", ...
    std::string_view shapeKind;     // "plymesh", "sphere", ...
    std::string_view meshFile;      // file of the mesh, as named in the scene file; empty: not from a file
    std::string_view file;          // file that contains the shape's directive
    int line = 0;                   // line of the directive in `file`, from 1
};

// One row of string indices and a line number per shape of the file. Each distinct string is stored once, because there
// are far fewer strings than shapes.
class SurfaceNames {
  public:
    // The index of a surface that has no row.
    static constexpr uint32_t kNone = ~uint32_t(0);

    SurfaceNames() = default;
    // Not copyable: strings_ points to the keys of this object's map.
    SurfaceNames(const SurfaceNames&) = delete;
    SurfaceNames& operator=(const SurfaceNames&) = delete;
    SurfaceNames(SurfaceNames&&) = default;
    SurfaceNames& operator=(SurfaceNames&&) = default;

    // Adds a row and returns its index. Copies the strings that the table does not contain yet.
    uint32_t add(const SurfaceName& name);
    // Returns empty strings for kNone.
    SurfaceName at(uint32_t index) const;
    size_t size() const { return rows_.size(); }

  private:
    struct Row {
        uint32_t material, materialKind, shapeKind, meshFile, file;
        int32_t line;
    };
    uint32_t keep(std::string_view text);

    std::vector<Row> rows_;
    std::map<std::string, uint32_t, std::less<>> indices_;  // position of each string in strings_
    std::vector<const std::string*> strings_;               // the keys of indices_
};

}  // namespace drc
