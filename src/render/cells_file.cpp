#include "render/cells_file.h"

#include <fmt/core.h>

#include <cstdlib>

#include "base/error.h"
#include "base/regular_file.h"
#include "pbrt/world_key.h"

namespace drc {
namespace {

constexpr const char* kCellsKind = "drc cells";
// Rises when the format changes, or the meaning of what is in it.
constexpr int kCellsVersion = 1;

std::string headerOf(const Identity& identity) {
    return fmt::format("{} {} {}", kCellsKind, kCellsVersion, identityLine(identity));
}

}  // namespace

Identity cellsIdentity(const Scene& scene, const RenderParams& params) {
    if (scene.files.empty() || !isRegularFile(scene.files[0]))
        throw Error("cells: a scene that comes through a pipe cannot be told from another; give its file");
    const std::optional<uint64_t> world = pbrt::worldKey(scene.files[0]);
    if (!world)
        throw Error(scene.files[0] + ": cells are of the world, which here depends on the camera: CoordSysTransform");
    Identity identity{{"world (shapes, materials, lights, media)", fmt::format("{:016x}", *world)},
                      {"--max-depth", std::to_string(*params.maxDepth)},
                      {"--clamp", fmt::format("{}", params.clamp)}};
    const Identity files = identityOfFiles(scene, 1);
    identity.insert(identity.end(), files.begin(), files.end());
    return identity;
}

void saveCells(const std::string& path, const CellCollection& cells, const Identity& identity) {
    StateWriter file(path, headerOf(identity));
    cells.save(file);
    file.commit();
}

Identity identityOfCells(const std::string& what, const std::string& path) {
    const std::string header = stateHeader(path, kCellsKind);
    const int version = std::atoi(header.c_str() + std::string(kCellsKind).size());
    if (version > kCellsVersion)
        throw Error(
            fmt::format("{}: it is of a later version of drc: format {}, here {}", what, version, kCellsVersion));
    return identityIn(path, kCellsKind);
}

CellCollection loadCells(const std::string& what, const std::string& path, const Identity& identity) {
    requireIdentity(what, identityOfCells(what, path), identity);
    StateReader file(path, kCellsKind, headerOf(identity));
    CellCollection cells = CellCollection::load(file);
    file.finish();
    return cells;
}

}  // namespace drc
