// Names of surfaces in the scene's file, for people who point at one and ask what it is. No light depends on them.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace drc {

// The views are of strings that the table keeps.
struct SurfaceName {
    std::string_view material;      // that the file gives the material; empty: none
    std::string_view materialKind;  // "matte", "glass", ...
    std::string_view shapeKind;     // "plymesh", "sphere", ...
    std::string_view meshFile;      // that the mesh was read from, as the scene's file names it; empty: no such file
    std::string_view file;          // where the shape is
    int line = 0;                   // of that file, from 1
};

// A table with a row of a few numbers for each shape of the file. The strings, of which there are far fewer, are kept
// once each.
class SurfaceNames {
  public:
    // The index of a surface that has no row.
    static constexpr uint32_t kNone = ~uint32_t(0);

    SurfaceNames() = default;
    // The rows point to strings of their own table.
    SurfaceNames(const SurfaceNames&) = delete;
    SurfaceNames& operator=(const SurfaceNames&) = delete;
    SurfaceNames(SurfaceNames&&) = default;
    SurfaceNames& operator=(SurfaceNames&&) = default;

    // The index of the new row. Copies the strings that are new.
    uint32_t add(const SurfaceName& name);
    // All empty for kNone.
    SurfaceName at(uint32_t index) const;
    size_t size() const { return rows_.size(); }

  private:
    struct Row {
        uint32_t material, materialKind, shapeKind, meshFile, file;
        int32_t line;
    };
    uint32_t keep(std::string_view text);

    std::vector<Row> rows_;
    std::map<std::string, uint32_t, std::less<>> indices_;  // of the strings
    std::vector<const std::string*> strings_;               // the keys of the map
};

}  // namespace drc
